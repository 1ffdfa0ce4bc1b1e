import type { Bounds, Vec3 } from "../geometry.js";
import { type CollisionMesh, normalOf } from "./collision-mesh.js";
import { Footprint } from "./footprint.js";

/** Finest and coarsest cells, metres. */
const FINEST = 0.02;
const COARSEST = 0.1;
/** 20 x 20 m in cells of 24 mm. Rooms of more than 84 m, in the coarsest cells, are cut off. */
const MAX_CELLS = 700_000;
/** Tolerance of rounding, in cells. */
const TOUCH = 1e-6;

/** Squares on the floor, row by row towards +Z. Metres. */
export interface FloorGrid {
  /** Corner of the first cell. */
  readonly x: number;
  readonly z: number;
  readonly cell: number;
  readonly columns: number;
  readonly rows: number;
}

/** Grid over the plan of a box, or over as much of it as there is memory for around `centre`. */
export function gridOver({ min, max }: Bounds, centre: readonly [x: number, z: number]): FloorGrid {
  const across = Math.max(max[0] - min[0], FINEST);
  const along = Math.max(max[2] - min[2], FINEST);
  const cell = Math.min(
    Math.max(FINEST, Math.sqrt(across / MAX_CELLS) * Math.sqrt(along)),
    COARSEST,
  );
  const most = Math.floor(Math.sqrt(MAX_CELLS));
  const fits = (across / cell) * (along / cell) <= MAX_CELLS * 1.001;
  const [x, columns] = interval(min[0], across, cell, fits ? Infinity : most, centre[0]);
  const [z, rows] = interval(min[2], along, cell, fits ? Infinity : most, centre[1]);
  return { x, z, cell, columns, rows };
}

/** Middle of a square, counted row by row. */
export function middleOf(
  { x, z, cell, columns }: FloorGrid,
  square: number,
): [x: number, z: number] {
  return [x + ((square % columns) + 0.5) * cell, z + (Math.floor(square / columns) + 0.5) * cell];
}

/** Half a cell more on each side puts walls that bound the room in the middle of cells. */
function interval(
  min: number,
  extent: number,
  cell: number,
  most: number,
  centre: number,
): [start: number, count: number] {
  const count = Math.ceil(extent / cell - TOUCH) + 1;
  const start = min - cell / 2;
  if (count <= most) return [start, count];
  const last = start + (count - most) * cell;
  return [Math.min(Math.max(centre - (most * cell) / 2, start), last), most];
}

/**
 * Marks every cell that a triangle touches between two heights.
 *
 * @param minLevelness only triangles whose normal is at least this upright, up or down
 */
export function markTouched(
  marked: Uint8Array,
  grid: FloorGrid,
  { triangles }: CollisionMesh,
  low: number,
  high: number,
  minLevelness = 0,
): void {
  const footprint = new Footprint();
  footprint.low = low;
  footprint.high = high;
  const rasterizer = new Rasterizer(marked, grid);
  const normal: Vec3 = [0, 0, 0];
  for (let at = 0; at < triangles.length; at += 9) {
    const ay = triangles[at + 1]!;
    const by = triangles[at + 4]!;
    const cy = triangles[at + 7]!;
    if ((ay < low && by < low && cy < low) || (ay > high && by > high && cy > high)) continue;
    if (minLevelness > 0) {
      normalOf(triangles, at, normal);
      if (Math.abs(normal[1]) < minLevelness) continue;
    }
    if (footprint.clip(triangles, at)) rasterizer.fill(footprint);
  }
}

/** Conservative rasterizer of convex polygons: fills every cell that they touch. */
class Rasterizer {
  readonly #marked: Uint8Array;
  readonly #grid: FloorGrid;
  /** Of the polygon within each row. */
  readonly #left: Float64Array;
  readonly #right: Float64Array;

  constructor(marked: Uint8Array, grid: FloorGrid) {
    this.#marked = marked;
    this.#grid = grid;
    this.#left = new Float64Array(grid.rows);
    this.#right = new Float64Array(grid.rows);
  }

  fill({ x, z, count }: Footprint): void {
    const { cell, columns, rows } = this.#grid;
    let top = Infinity;
    let bottom = -Infinity;
    for (let i = 0; i < count; i++) {
      x[i] = (x[i]! - this.#grid.x) / cell;
      z[i] = (z[i]! - this.#grid.z) / cell;
      top = Math.min(top, z[i]!);
      bottom = Math.max(bottom, z[i]!);
    }
    const first = Math.max(0, Math.floor(top - TOUCH));
    const last = Math.min(rows - 1, Math.floor(bottom + TOUCH));
    if (first > last) return;
    for (let row = first; row <= last; row++) {
      this.#left[row] = Infinity;
      this.#right[row] = -Infinity;
    }
    for (let i = 0; i < count; i++) {
      const next = i + 1 === count ? 0 : i + 1;
      this.#trace(x[i]!, z[i]!, x[next]!, z[next]!);
    }
    for (let row = first; row <= last; row++) {
      const begin = Math.max(0, Math.floor(this.#left[row]! - TOUCH));
      const end = Math.min(columns - 1, Math.floor(this.#right[row]! + TOUCH));
      for (let column = begin; column <= end; column++) this.#marked[row * columns + column] = 1;
    }
  }

  /** Extends the span of each row to an edge. */
  #trace(ax: number, az: number, bx: number, bz: number): void {
    const high = Math.min(az, bz);
    const low = Math.max(az, bz);
    const slope = low - high > 1e-12 ? (bx - ax) / (bz - az) : 0;
    const first = Math.max(0, Math.floor(high - TOUCH));
    const last = Math.min(this.#grid.rows - 1, Math.floor(low + TOUCH));
    for (let row = first; row <= last; row++) {
      const zIn = Math.min(Math.max(row, high), low);
      const zOut = Math.min(Math.max(row + 1, high), low);
      const xIn = slope === 0 ? ax : ax + (zIn - az) * slope;
      const xOut = slope === 0 ? bx : ax + (zOut - az) * slope;
      this.#left[row] = Math.min(this.#left[row]!, xIn, xOut);
      this.#right[row] = Math.max(this.#right[row]!, xIn, xOut);
    }
  }
}
