import { CANDLE_CYLINDER } from "../candle.js";
import { length2, type Vec3 } from "../geometry.js";
import { stiffFoot } from "../player/hand.js";
import type { World } from "../world.js";
import type { CollisionMesh } from "./collision-mesh.js";

/** Distance at which the hand reaches out to a wick: along the floor, and up or down. Metres. */
const REACH = 0.4;
const REACH_UP = 0.5;
/**
 * Offset of the carried flame from the wick that it lights: to the side, and up, of which the lowest free one.
 * Metres.
 */
const BESIDE = 0.06;
const ABOVE = [0.035, 0.075, 0.13, 0.2];

const stiff: Vec3 = [0, 0, 0];
const foot: Vec3 = [0, 0, 0];

/**
 * The hand's way to the nearest wick where either candle can light the other, written to `way`. It begins where a stiff
 * arm holds the flame: if it depended on where the hand is, it would tremble between two places.
 *
 * @returns false if there is none
 */
export function findWayToWick(world: World, way: Vec3, collision: CollisionMesh): boolean {
  const { standing, player, setup, candle, emitter, flame } = world;
  stiffFoot(player, setup.hold, stiff);
  let nearest = REACH;
  let isFound = false;
  for (let i = 0; i < standing.length; i++) {
    const { root, flame: other } = standing[i]!;
    const dx = root[0] - (stiff[0] + emitter[0] - candle.position[0]);
    const dy = root[1] - (stiff[1] + emitter[1] - candle.position[1]);
    const dz = root[2] - (stiff[2] + emitter[2] - candle.position[2]);
    const distance = length2(dx, dz);
    if (other.isLit === flame.isLit || Math.abs(dy) > REACH_UP || distance > nearest) continue;
    const share = Math.max(0, 1 - BESIDE / Math.max(distance, 1e-6));
    way[0] = dx * share;
    way[1] = dy;
    way[2] = dz * share;
    nearest = distance;
    isFound = true;
  }
  if (isFound) way[1] += freeHeight(way, collision);
  return isFound;
}

/** Height above the wick at which the candle touches nothing, at the end of `way`. */
function freeHeight(way: Readonly<Vec3>, collision: CollisionMesh): number {
  let above = 0;
  for (let i = 0; i < ABOVE.length; i++) {
    above = ABOVE[i]!;
    for (let axis = 0; axis < 3; axis++) foot[axis] = stiff[axis]! + way[axis]!;
    foot[1] += above;
    const { radius, height } = CANDLE_CYLINDER;
    if (!collision.overlapsCylinder(foot, radius, height)) break;
  }
  return above;
}
