import { vec3 } from "gl-matrix";
import { GRASP } from "../candle.js";
import type { Vec3 } from "../geometry.js";
import { WALKER_RADIUS } from "../player/player.js";
import type { CollisionMesh, RayHit } from "./collision-mesh.js";
import type { FloorPlan } from "./floor-plan.js";

/** Why a candle cannot be put down. */
export type Refusal =
  | "nothing within reach"
  | "too steep"
  | "overhangs"
  | "no room"
  | "out of reach";

/** Bounding cylinder of a standing candle: upright, metres. */
export interface Cylinder {
  /** Of the holder's foot, all of which must be supported. */
  readonly radius: number;
  /** Includes the space that the flame needs. */
  readonly height: number;
}

/**
 * Farthest from the eye, along the floor, metres: an arm of 0.7 m and a lean of 0.5 m. Only along the
 * floor, because knees bend: the floor before one's feet is as easily reached as a table top.
 */
export const REACH = 1.2;
/** Highest above the eye, and lowest below the floor: an arm stretched up, a step down. Metres. */
const REACH_UP = 0.35;
const REACH_DOWN = 0.3;
/** Distance of the spot where the line of sight meets no surface, metres. */
const AHEAD = 0.8;
/** From there, how far apart surfaces are looked for, nearer and farther, and how often. Metres. */
const STRIDE = 0.1;
const STRIDES = 4;
/** What is higher than the floor by this is furniture, metres. */
const FURNITURE = 0.1;
/** Cosine of 18 degrees: steeper surfaces are refused before their heights are measured. */
const LEVEL = 0.95;
/** Largest difference of height under the foot, metres: 2.2 degrees on a plane. */
const UNEVENNESS = 0.005;
const COS_TILT = 0.9993;
/** Cracks between boards are bridged if they are narrower than twice this, metres. */
const CRACK = 0.008;
/** Farthest that a spot is moved to fit, metres. */
const NUDGE = 0.04;
const NUDGES = 4;
const BEARINGS = 12;
/** Between the player and a candle at their feet, metres. */
const ELBOW_ROOM = 0.02 + NUDGE;
const DOWN: Readonly<Vec3> = [0, -1, 0];
/** Sample points under the foot, in rings of a fraction of its radius. */
const RINGS: readonly (readonly [fraction: number, count: number])[] = [
  [0, 1],
  [0.55, 8],
  [1, 16],
];

/** Input of a placement: the room, the eye, and the candle's volume. */
export interface PlacementQuery {
  readonly collision: CollisionMesh;
  readonly plan: FloorPlan;
  readonly eye: Readonly<Vec3>;
  /** Line of sight, unit; not straight up or down. */
  readonly direction: Readonly<Vec3>;
  readonly cylinder: Cylinder;
}

const from: Vec3 = [0, 0, 0];
const other: Vec3 = [0, 0, 0];

/** Finds the spot along the line of sight, or ahead if that is out of reach. Null, or why there is none. */
export function findSpot(query: PlacementQuery, spot: Vec3): Refusal | null {
  const refusal = findAimedSpot(query, spot);
  // Looking at a wall, or past everything, selects the surface ahead.
  const meansAhead = refusal === "nothing within reach" || refusal === "too steep";
  return meansAhead && findSpotAhead(query, spot) === null ? null : refusal;
}

/**
 * Finds the spot on the surface along the line of sight. `spot` is the middle of the candle's foot.
 *
 * @returns null, or why there is no such spot
 */
export function findAimedSpot(reach: PlacementQuery, spot: Vec3): Refusal | null {
  const { collision, eye, direction, cylinder } = reach;
  const level = Math.hypot(direction[0], direction[2]);
  const hit = collision.raycast(eye, direction, Infinity);
  const [away, y] = hit
    ? [hit.distance * level, eye[1] + hit.distance * direction[1]]
    : whereFloorWouldBe(reach, level);
  if (away > REACH || y > eye[1] + REACH_UP) return "nothing within reach";
  if (hit && hit.normal[1] < LEVEL) return "too steep";
  const near = WALKER_RADIUS + cylinder.radius + ELBOW_ROOM;
  if (away < near) return fitAround(reach, near, eye[1], spot);
  return fitAround(reach, away, y + UNEVENNESS, spot);
}

/**
 * Finds the spot ahead, below the line of sight; before a wall if one is near. Where a table or shelf is within reach on
 * the way, it is there, not on the floor before it.
 *
 * @returns null, or why there is no such spot
 */
export function findSpotAhead(reach: PlacementQuery, spot: Vec3): Refusal | null {
  const { collision, plan, eye, direction, cylinder } = reach;
  const level = Math.hypot(direction[0], direction[2]);
  const hit = collision.raycast(eye, direction, Infinity);
  const clearance = (hit ? hit.distance * level : Infinity) - cylinder.radius - NUDGE;
  const nearest = WALKER_RADIUS + cylinder.radius + ELBOW_ROOM;
  const usual = Math.min(AHEAD, clearance);
  if (usual < nearest) return "no room";
  const fitAt = (distance: number, spot: Vec3) => {
    const y = eye[1] + Math.min(REACH_UP, (direction[1] / level) * distance);
    return fitAround(reach, distance, y, spot);
  };
  const isFurniture = ([, y]: Readonly<Vec3>) => y > plan.floor + FURNITURE;
  let refusal = fitAt(usual, spot);
  if (refusal === null && isFurniture(spot)) return null;
  for (let i = 1; i <= STRIDES; i++) {
    for (const distance of [usual + i * STRIDE, usual - i * STRIDE]) {
      if (distance > Math.min(REACH, clearance) || distance < nearest) continue;
      if (fitAt(distance, other) !== null) continue;
      if (refusal === null && !isFurniture(other)) continue;
      vec3.copy(spot, other);
      if (isFurniture(spot)) return null;
      refusal = null;
    }
  }
  return refusal;
}

/** Whether a candle that stands can be taken up: it is near, and some of it in sight. */
export function canTake(
  collision: CollisionMesh,
  eye: Readonly<Vec3>,
  [x, y, z]: Readonly<Vec3>,
  { height }: Cylinder,
): boolean {
  const isNear = Math.hypot(x - eye[0], z - eye[2]) <= GRASP && y <= eye[1] + REACH_UP;
  return (
    isNear && [0.1, 0.5, 1].some((share) => collision.isClear(eye, [x, y + share * height, z]))
  );
}

/** Where the line of sight meets the height of a floor that the room does not have. */
function whereFloorWouldBe(
  { plan, eye, direction }: PlacementQuery,
  level: number,
): [number, number] {
  if (plan.hasFloor || direction[1] >= 0) return [Infinity, 0];
  return [((plan.floor - eye[1]) / direction[1]) * level, plan.floor];
}

/** Tries the highest surface below `y`, so far along the line of sight, and the spots around it. */
function fitAround(reach: PlacementQuery, distance: number, y: number, spot: Vec3): Refusal | null {
  const { eye, direction } = reach;
  const t = distance / Math.hypot(direction[0], direction[2]);
  const x = eye[0] + direction[0] * t;
  const z = eye[2] + direction[2] * t;
  const refusal = fit(reach, x, y, z, spot);
  if (refusal !== "overhangs" && refusal !== "no room") return refusal;
  for (let step = 1; step <= NUDGES; step++) {
    for (let i = 0; i < BEARINGS; i++) {
      const angle = (2 * Math.PI * i) / BEARINGS;
      const nudge = (NUDGE * step) / NUDGES;
      const [sideX, sideZ] = [x + Math.cos(angle) * nudge, z + Math.sin(angle) * nudge];
      if (fit(reach, sideX, y, sideZ, spot) === null) return null;
    }
  }
  return refusal;
}

/** Whether the foot fits on the highest surface below a point. */
function fit(reach: PlacementQuery, x: number, y: number, z: number, spot: Vec3): Refusal | null {
  const { collision, plan, eye, cylinder } = reach;
  const hit = castDown(collision, x, y, z, Infinity);
  let top = hit ? y - hit.distance : Number.NEGATIVE_INFINITY;
  if (top < plan.floor - REACH_DOWN) {
    // In a room without a floor, the candle stands in the air at the floor's height.
    if (plan.hasFloor || plan.clearance(x, z) <= 0) return "nothing within reach";
    top = plan.floor;
  } else if (hit) {
    // Read before the next ray overwrites the hit.
    const slope = hit.normal[1];
    if (slope < LEVEL) return "too steep";
    const highest = highestSupport(collision, x, top, z, cylinder.radius);
    if (Number.isNaN(highest)) return slope < COS_TILT ? "too steep" : "overhangs";
    top = highest;
  }
  vec3.set(from, x, top + UNEVENNESS, z);
  if (collision.overlapsCylinder(from, cylinder.radius, cylinder.height - UNEVENNESS))
    return "no room";
  from[1] = top + cylinder.height / 2;
  if (!collision.isClear(eye, from)) return "no room";
  vec3.set(spot, x, top, z);
  return null;
}

/** Highest support under the foot; NaN if part of it hangs in the air, or if it would wobble. */
function highestSupport(
  collision: CollisionMesh,
  x: number,
  y: number,
  z: number,
  radius: number,
): number {
  let top = y;
  let bottom = y;
  for (const [fraction, count] of RINGS) {
    for (let i = 0; i < count; i++) {
      const angle = (2 * Math.PI * i) / count;
      const px = x + Math.cos(angle) * fraction * radius;
      const pz = z + Math.sin(angle) * fraction * radius;
      const height = supportAt(collision, px, y, pz);
      top = Math.max(top, height);
      bottom = Math.min(bottom, height);
      if (!(top - bottom <= UNEVENNESS)) return Number.NaN;
    }
  }
  return top;
}

/** Height of the support under a point of the foot, be it across a crack; NaN if there is none. */
function supportAt(collision: CollisionMesh, x: number, y: number, z: number): number {
  const height = feel(collision, x, y, z);
  if (!Number.isNaN(height)) return height;
  const across = Math.max(feel(collision, x - CRACK, y, z), feel(collision, x + CRACK, y, z));
  if (!Number.isNaN(across)) return across;
  return Math.max(feel(collision, x, y, z - CRACK), feel(collision, x, y, z + CRACK));
}

function feel(collision: CollisionMesh, x: number, y: number, z: number): number {
  const hit = castDown(collision, x, y + 2 * UNEVENNESS, z, 4 * UNEVENNESS);
  return hit ? y + 2 * UNEVENNESS - hit.distance : Number.NaN;
}

function castDown(
  collision: CollisionMesh,
  x: number,
  y: number,
  z: number,
  distance: number,
): RayHit | null {
  vec3.set(from, x, y, z);
  return collision.raycast(from, DOWN, distance);
}
