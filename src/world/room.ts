import type { Vec3 } from "./bounds.js";
import { FloorPlan } from "./floor-plan.js";
import { EYE_HEIGHT } from "./gait.js";
import type { Ground } from "./ground.js";
import { Solid, type Triangles } from "./solid.js";

/** The eye keeps this far from floor and ceiling, metres. */
const HEADROOM = 0.15;

/** A room as it can be walked in and touched, from whatever geometry it is made of. */
export interface Room {
  readonly solid: Solid;
  readonly plan: FloorPlan;
  readonly ground: Ground;
  /** Where the visitor's eye starts, metres, and the way he faces. */
  readonly start: Vec3;
  readonly yaw: number;
}

/** @param spawn where to start and which way to face, if the room says so */
export function createRoom(
  parts: readonly Triangles[],
  spawn: { readonly position: readonly [number, number, number]; readonly yaw: number } | null,
): Room {
  const solid = new Solid(parts);
  const plan = new FloorPlan(solid, spawn ? [...spawn.position] : null);
  const { min, max } = solid.bounds;
  const lowest = Math.min(min[1], plan.floor) + HEADROOM;
  const highest = Math.max(max[1], plan.floor + EYE_HEIGHT + 2 * HEADROOM) - HEADROOM;
  const ground: Ground = {
    walk: (position, way, velocity) => plan.walk(position, way, velocity),
    settle(position) {
      position[1] = Math.min(Math.max(position[1], lowest), highest);
      plan.settle(position);
    },
  };
  const [x, y, z] = plan.start;
  return { solid, plan, ground, start: [x, y + EYE_HEIGHT, z], yaw: spawn?.yaw ?? 0 };
}
