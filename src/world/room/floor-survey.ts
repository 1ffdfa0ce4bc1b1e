import type { Bounds } from "../geometry.js";
import { WALKER_RADIUS } from "../player/player.js";
import type { CollisionMesh } from "./collision-mesh.js";
import { distanceField } from "./distance-field.js";
import { gridOver, markTouched } from "./floor-grid.js";

/** Heights above the floor between which things are obstacles. Metres. */
const STEP_OVER = 0.1;
export const HEADROOM = 1.7;
/** Least area for the walker's centre in a room, m²; less is a cupboard. */
const ROOM = 1;
/** Least area for it in any room, m². */
const CLOSET = 0.2;
/** Half the widest gap between boards that one walks over. Metres. */
const CRACK = 0.15;
/** Share of the plan from which the edge of the floor bounds the walk. */
const FLOOR_SHARE = 0.5;
/** Clearance of the start without a spawn point, where there is any. Metres. */
const ELBOW_ROOM = 0.5;
/** Farthest detour to a start that is on the floor: the middle of a bent corridor is not. Metres. */
const DETOUR = 100;

/** Survey of a floor: where a walker fits. */
export type FloorSurvey = Readonly<NonNullable<ReturnType<typeof surveyFloor>>>;

/**
 * Surveys the floor within some bounds; null if a walker fits nowhere.
 *
 * @param target where to start if there is space, or else near
 * @param isExact whether the target was meant, so that a nearer spot is better than a roomier one
 */
export function surveyFloor(
  collision: CollisionMesh,
  bounds: Bounds,
  floor: number,
  target: readonly [number, number],
  isExact: boolean,
) {
  const grid = gridOver(bounds, target);
  const { columns, rows, cell } = grid;
  const isTaken = new Uint8Array(columns * rows);
  markTouched(isTaken, grid, collision, floor + STEP_OVER, floor + HEADROOM);
  for (let row = 0; row < rows; row++) {
    isTaken[row * columns] = isTaken[row * columns + columns - 1] = 1;
  }
  isTaken.fill(1, 0, columns).fill(1, (rows - 1) * columns);

  const isFloor = new Uint8Array(columns * rows);
  markTouched(isFloor, grid, collision, floor - STEP_OVER, floor + STEP_OVER, 0.5);
  let floorArea = 0;
  for (let i = 0; i < isFloor.length; i++) floorArea += isFloor[i]!;
  // One walks around a model that is too small on no floor of its.
  const isInside = bounds === collision.bounds;
  if (isInside && floorArea >= isFloor.length * FLOOR_SHARE && floorArea < isFloor.length) {
    const toFloor = distanceField(isFloor, columns, rows);
    for (let i = 0; i < isTaken.length; i++) if (toFloor[i]! * cell > CRACK) isTaken[i] = 1;
  }

  const clearance = distanceField(isTaken, columns, rows);
  // A thing may be anywhere in its square. And between the middles of four squares, a cone of
  // distances at least a radius from its tip lies at most this much below its bilinear interpolant.
  const margin = cell * Math.SQRT1_2 + (cell * cell) / (8 * (WALKER_RADIUS - cell));
  for (let i = 0; i < clearance.length; i++) clearance[i] = clearance[i]! * cell - margin;

  const { region, areas } = regionsOf(clearance, columns);
  const largest = areas.reduce((most, area) => Math.max(most, area), 0);
  if (largest * cell * cell < CLOSET) return null;
  const enough = Math.min(ROOM / (cell * cell), largest);
  let start = -1;
  let least = Infinity;
  for (let at = 0, row = 0; row < rows; row++) {
    const dz = grid.z + (row + 0.5) * cell - target[1];
    for (let column = 0; column < columns; column++, at++) {
      if (region[at] === 0 || areas[region[at]! - 1]! < enough) continue;
      const dx = grid.x + (column + 0.5) * cell - target[0];
      let cost = Math.sqrt(dx * dx + dz * dz);
      if (!isExact) {
        cost += 2 * Math.max(0, ELBOW_ROOM - clearance[at]!) + (isFloor[at] ? 0 : DETOUR);
      }
      if (cost >= least) continue;
      least = cost;
      start = at;
    }
  }
  const isReachable = new Uint8Array(region.length);
  for (let at = 0; at < region.length; at++) if (region[at] === region[start]) isReachable[at] = 1;
  return {
    grid,
    /** Distance from the middle of each square to the nearest thing is at least this, metres. */
    clearance,
    /** Squares whose middle can be walked to from the start. */
    isReachable,
    hasFloor: isInside && floorArea > 0,
    start,
  };
}

/** Numbers the regions that a walker's middle can roam, from 1; their areas in squares. */
function regionsOf(clearance: Float32Array, columns: number) {
  const region = new Uint32Array(clearance.length);
  const areas: number[] = [];
  const queue = new Uint32Array(clearance.length);
  const steps = [-columns, -1, 1, columns];
  for (let seed = 0; seed < region.length; seed++) {
    if (region[seed] !== 0 || clearance[seed]! < WALKER_RADIUS) continue;
    areas.push(0);
    let end = 0;
    queue[end++] = seed;
    region[seed] = areas.length;
    for (let i = 0; i < end; i++) {
      // The rim is never free, so no neighbour is beyond it.
      for (const step of steps) {
        const next = queue[i]! + step;
        if (region[next] !== 0 || clearance[next]! < WALKER_RADIUS) continue;
        region[next] = areas.length;
        queue[end++] = next;
      }
    }
    areas[areas.length - 1] = end;
  }
  return { region, areas };
}
