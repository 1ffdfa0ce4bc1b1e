import { vec3 } from "gl-matrix";
import { length3, type Vec3 } from "../geometry.js";
import type { CollisionMesh } from "./collision-mesh.js";

/** Rays along the axes and the diagonals. */
const DIRECTIONS: readonly Readonly<Vec3>[] = [-1, 0, 1].flatMap((x) =>
  [-1, 0, 1].flatMap((y) =>
    [-1, 0, 1].flatMap((z): Vec3[] => {
      const length = length3(x, y, z);
      return length === 1 || x * y * z !== 0 ? [[x / length, y / length, z / length]] : [];
    }),
  ),
);
const REACH = 100;
/**
 * Share of the rays that meet a back first, inside a solid, of those that do not go down: these may meet the floor that it
 * stands on. And share of all that meet a front first, inside a room.
 */
const MOST = 0.75;
const MOST_BACKS = MOST * DIRECTIONS.filter(([, y]) => y >= 0).length;

/**
 * Moves a place that lies inside a solid to the nearest one outside of it, in the room if there is one.
 *
 * A place is inside where most rays meet the back of a triangle first.
 *
 * @param clearance from the surface, metres
 * @param isSolid whether a triangle is of a solid: sheets and glass have backs that are seen
 * @returns the place itself if it is free
 */
export function freePlace(
  collision: CollisionMesh,
  place: Readonly<Vec3>,
  clearance: number,
  isSolid: (triangle: number) => boolean,
): Readonly<Vec3> {
  const { backs, isInSolid } = lookAround(collision, place, isSolid);
  if (!isInSolid) return place;
  const exits = backs
    .toSorted((a, b) => a.distance - b.distance)
    .map(({ distance, direction }) => {
      return vec3.scaleAndAdd([0, 0, 0], place, direction, distance + clearance) as Vec3;
    });
  const around = exits.map((exit) => lookAround(collision, exit, isSolid));
  const indoors = around.findIndex(
    ({ fronts, isInSolid }) => !isInSolid && fronts >= MOST * DIRECTIONS.length,
  );
  return exits[indoors] ?? exits[around.findIndex(({ isInSolid }) => !isInSolid)] ?? place;
}

/** What the rays from a place meet first. */
function lookAround(
  collision: CollisionMesh,
  place: Readonly<Vec3>,
  isSolid: (triangle: number) => boolean,
) {
  const backs: { distance: number; direction: Readonly<Vec3> }[] = [];
  let fronts = 0;
  for (const direction of DIRECTIONS) {
    const hit = collision.raycast(place, direction, REACH);
    if (!hit) continue;
    const { distance, triangle } = hit;
    if (hit.isBack && isSolid(triangle)) backs.push({ distance, direction });
    else fronts++;
  }
  const isInSolid = backs.filter(({ direction }) => direction[1] >= 0).length >= MOST_BACKS;
  return { backs, fronts, isInSolid };
}
