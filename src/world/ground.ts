import { type Bounds, keepInside, type Vec3 } from "./bounds.js";

/** What a walker walks on, and what stops him. `FloorPlan` is one; a box and the open are others. */
export interface Ground {
  /** Walks a level way, metres, as far as it goes; stops the part of `velocity` that led on. */
  walk(position: Vec3, way: Readonly<Vec3>, velocity: Vec3): void;
  /** Moves a position to the nearest one that is free. */
  settle(position: Vec3): void;
}

/** Ground within walls. */
export function walled(bounds: Bounds): Ground {
  return {
    walk(position, way, velocity) {
      position[0] += way[0];
      position[2] += way[2];
      keepInside(position, bounds, velocity);
    },
    settle: (position) => keepInside(position, bounds),
  };
}

/** Ground without end. */
export const OPEN: Ground = {
  walk(position, way) {
    position[0] += way[0];
    position[2] += way[2];
  },
  settle() {},
};
