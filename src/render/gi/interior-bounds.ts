import { vec3 } from "gl-matrix";
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

/** Share of the walls' area, at least, that runs along two axes at right angles, for bounds along them. */
const LEAST_ALONG_AXES = 0.5;
/** Walls that are turned less are taken to run along x and z, radians. */
const LEAST_YAW = 0.03;

/** A box along axes that are turned about the vertical through the origin. */
export interface InteriorBounds extends Bounds {
  /** Angle from the world's axes to the box's, radians. */
  readonly yaw: number;
}

/** Where a ray meets a surface, and the surface's normal. */
interface Hit {
  readonly place: Vec3;
  readonly normal: Vec3;
}

const known = new WeakMap<CollisionMesh, InteriorBounds>();

/**
 * Bounds of a room's inner surfaces along its walls, m: without the thickness of its walls, and what stands outside. Of
 * a model without an inside, its own. Panes bound it, however clear: probes outdoors are of no use.
 */
export function interiorBounds(collision: CollisionMesh, { bounds }: Model): InteriorBounds {
  const before = known.get(collision);
  if (before) return before;
  const hits: Hit[] = [];
  let pointsInside = 0;
  for (const point of pointsIn(bounds, POINTS)) {
    const inFront = DIRECTIONS.flatMap((direction) => {
      const hit = collision.raycast(point, direction, Infinity);
      if (!hit || hit.isBack) return [];
      const place = vec3.scaleAndAdd([0, 0, 0], point, direction, hit.distance) as Vec3;
      // The next ray overwrites the hit.
      return [{ place, normal: [...hit.normal] as Vec3 }];
    });
    if (inFront.length < INSIDE_SHARE * DIRECTIONS.length) continue;
    pointsInside++;
    hits.push(...inFront);
  }
  const isRoom = pointsInside >= LEAST_INSIDE * POINTS[0] * POINTS[1] * POINTS[2];
  const inside = isRoom ? boundsOf(hits) : { ...bounds, yaw: 0 };
  known.set(collision, inside);
  return inside;
}

/** A point turned about the vertical through the origin. */
export function turned(point: Vec3, yaw: number): Vec3 {
  return vec3.rotateY([0, 0, 0], point, [0, 0, 0], yaw) as Vec3;
}

/** Angle of the axes that most walls run along: the mean of four times their angles, which is one for all four sides. */
function yawOf(hits: readonly Hit[]): number {
  let [cosine, sine, total] = [0, 0, 0];
  for (const {
    normal: [x, , z],
  } of hits) {
    const weight = x * x + z * z;
    const angle = 4 * Math.atan2(-z, x);
    cosine += weight * Math.cos(angle);
    sine += weight * Math.sin(angle);
    total += weight;
  }
  const yaw = Math.atan2(sine, cosine) / 4;
  const isAligned = Math.hypot(cosine, sine) >= LEAST_ALONG_AXES * total;
  return isAligned && Math.abs(yaw) >= LEAST_YAW ? yaw : 0;
}

function boundsOf(hits: readonly Hit[]): InteriorBounds {
  const yaw = yawOf(hits);
  const places = hits.map(({ place }) => turned(place, -yaw));
  const at = (share: number) =>
    [0, 1, 2].map((axis) => {
      const sorted = places.map((place) => place[axis]!).sort((a, b) => a - b);
      return sorted[Math.round(share * (sorted.length - 1))]!;
    }) as Vec3;
  return { min: at(OUTSIDE_SHARE), max: at(1 - OUTSIDE_SHARE), yaw };
}
