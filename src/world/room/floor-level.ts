import type { Vec3 } from "../geometry.js";
import { type CollisionMesh, normalOf } from "./collision-mesh.js";

/** A floor is level to within 18 degrees: scanned ones have bumps. */
const LEVEL = 0.95;
/** Thickness of the layers in which areas are summed, metres; more in rooms of more than `LAYERS`. */
const LAYER = 0.02;
const LAYERS = 8192;
/** Least area of a floor, as a share of the largest level's; less is a table, a shelf, a step. */
const WALKABLE_SHARE = 0.3;
/** A level this close above a floor and nearly as large is the floor: boards on the ground. Metres. */
const COVERING = 0.1;
/** Least area of a floor under the spawn point, m², however large the ground outside; and of one in a low model. */
const ROOM = 2;
/** A spawn point may lie this far below the floor that it means, metres. */
const SPAWN_SLACK = 0.2;
const DOWN: Readonly<Vec3> = [0, -1, 0];

/** Distance from a floor to a level above it that may be the roof or a ceiling, metres. */
const STOREY = 1.7;

/**
 * Height of the floor: the large level area under the spawn point, or else the one at 0, where
 * glTF's authors put it unless that is a ceiling, or else the lowest.
 */
export function floorLevel(collision: CollisionMesh, spawn: Readonly<Vec3> | null): number {
  const { min, max } = collision.bounds;
  const layer = Math.max(LAYER, (max[1] - min[1]) / (LAYERS - 2));
  // Layer 0 reaches from -1 to 1 cm.
  const base = Math.floor(min[1] / layer + 0.5);
  const { upward, level, height } = sumAreas(collision, layer, base);
  const largest = level.reduce((most, area) => Math.max(most, area), 0);
  if (largest === 0) return min[1] <= 0.5 && max[1] >= 0 ? 0 : min[1];
  const isLarge = (area: number | undefined) => (area ?? 0) >= largest * WALKABLE_SHARE;

  let chosen = -1;
  if (spawn) {
    const from: Vec3 = [spawn[0], spawn[1] + SPAWN_SLACK, spawn[2]];
    const below = collision.raycast(from, DOWN, Infinity);
    const under = below ? Math.floor((from[1] - below.distance) / layer + 0.5) - base : -1;
    // On a slope all levels are large: the one that the spawn point stands on comes first.
    const isNear = below !== null && below.distance <= 2 * SPAWN_SLACK;
    const top = isNear ? under + 1 : Math.floor(from[1] / layer + 0.5) - base;
    for (let i = Math.min(top, LAYERS - 1); i >= 0 && chosen < 0; i--) {
      const isUnder = Math.abs(i - under) <= 1 && level[i]! >= ROOM;
      if (isUnder || isLarge(level[i])) chosen = i;
    }
  }
  // A thing to walk around, a table say, stands on the floor.
  if (chosen < 0 && largest < ROOM && max[1] - min[1] < STOREY) return min[1];
  if (chosen < 0) {
    const lowest = level.findIndex(isLarge);
    chosen = upward.findIndex(isLarge);
    // A room modelled inside out has no upward face but its roof.
    if (chosen < 0 || (chosen - lowest) * layer > STOREY) chosen = lowest;
    const isCeiling = !isLarge(upward[-base]) && (-base - chosen) * layer > STOREY;
    if (isLarge(level[-base]) && !isCeiling) chosen = -base;
  }

  const ground = chosen;
  for (let i = ground + 1; i <= ground + COVERING / layer && i < LAYERS; i++) {
    const isAsLarge = level[i]! >= level[ground]! / 2;
    const coversAsMuch = upward[i]! > 0 && upward[i]! >= upward[ground]! / 2;
    if (isAsLarge || coversAsMuch) chosen = i;
  }
  return height[chosen]!;
}

/** Areas of level triangles by layer, m²: of those that face up, and of all; and their mean height. */
function sumAreas({ triangles }: CollisionMesh, layer: number, base: number) {
  const upward = new Float64Array(LAYERS);
  const level = new Float64Array(LAYERS);
  const height = new Float64Array(LAYERS);
  const normal: Vec3 = [0, 0, 0];
  for (let at = 0; at < triangles.length; at += 9) {
    const area = normalOf(triangles, at, normal) / 2;
    if (Math.abs(normal[1]) < LEVEL) continue;
    const [a, b, c] = [triangles[at + 1]!, triangles[at + 4]!, triangles[at + 7]!];
    const first = Math.floor(Math.min(a, b, c) / layer + 0.5) - base;
    const last = Math.floor(Math.max(a, b, c) / layer + 0.5) - base;
    // A slope of a few triangles is in all layers that it rises through.
    const share = area / (last - first + 1);
    for (let i = first; i <= last; i++) {
      if (normal[1] > 0) upward[i]! += share;
      level[i]! += share;
      height[i]! += (first === last ? (a + b + c) / 3 : (i + base) * layer) * share;
    }
  }
  for (let i = 0; i < LAYERS; i++) height[i] = level[i]! > 0 ? height[i]! / level[i]! : 0;
  return { upward, level, height };
}
