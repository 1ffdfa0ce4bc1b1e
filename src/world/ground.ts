import { type Bounds, keepInside, type Vec3 } from "./bounds.js";

/** What a walker walks on, and what stops him. `FloorPlan` is one; a box and the open are others. */
export interface Ground {
  /** Walks a way along the floor, metres, as far as it goes; stops the part of `velocity` that led on. */
  walk(position: Vec3, dx: number, dz: number, velocity: Vec3): void;
  /** Moves a position to the nearest one that is free. */
  settle(position: Vec3): void;
}

/** Ground within walls. */
export function walled(bounds: Bounds): Ground {
  return {
    walk(position, dx, dz, velocity) {
      position[0] += dx;
      position[2] += dz;
      keepInside(position, bounds, velocity);
    },
    settle: (position) => keepInside(position, bounds),
  };
}

/** Ground without end. */
export const OPEN: Ground = {
  walk(position, dx, dz) {
    position[0] += dx;
    position[2] += dz;
  },
  settle() {},
};
