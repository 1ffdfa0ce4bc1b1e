import type { Model } from "../../assets/model.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { pointsIn } from "../points.js";
import { octahedral } from "./ray-directions.js";

/** Points along each axis that rays start from, and the rays' directions. */
const POINTS: Readonly<Vec3> = [6, 4, 6];
const DIRECTIONS = octahedral(4, 4, 0);
/** Share of a point's rays that must meet the front of a surface, for it to lie inside. */
const INSIDE_SHARE = 0.6;
/** Share of the points that must lie inside: an alcove of an open yard is not the room. */
const LEAST_INSIDE = 0.25;
/** Share of all hits that may lie beyond each face of the bounds: panes and doors in their recesses. */
const OUTSIDE_SHARE = 0.02;

const known = new WeakMap<CollisionMesh, Bounds>();

/**
 * Bounds of a room's inner surfaces, m: without the thickness of its walls, and what stands outside. Of a model without
 * an inside, its own.
 */
export function interiorBounds(collision: CollisionMesh, { bounds }: Model): Bounds {
  const before = known.get(collision);
  if (before) return before;
  const hits: Vec3[] = [];
  let pointsInside = 0;
  for (const point of pointsIn(bounds, POINTS)) {
    const inFront = DIRECTIONS.flatMap((direction): Vec3[] => {
      const hit = collision.raycast(point, direction, Infinity);
      if (!hit || hit.isBack) return [];
      return [[0, 1, 2].map((axis) => point[axis]! + direction[axis]! * hit.distance) as Vec3];
    });
    if (inFront.length < INSIDE_SHARE * DIRECTIONS.length) continue;
    pointsInside++;
    hits.push(...inFront);
  }
  const inside =
    pointsInside >= LEAST_INSIDE * POINTS[0] * POINTS[1] * POINTS[2] ? boundsOf(hits) : bounds;
  known.set(collision, inside);
  return inside;
}

function boundsOf(hits: readonly Vec3[]): Bounds {
  const at = (share: number) =>
    [0, 1, 2].map((axis) => {
      const sorted = hits.map((hit) => hit[axis]!).sort((a, b) => a - b);
      return sorted[Math.round(share * (sorted.length - 1))]!;
    }) as Vec3;
  return { min: at(OUTSIDE_SHARE), max: at(1 - OUTSIDE_SHARE) };
}
