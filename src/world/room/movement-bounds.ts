import { type Bounds, clampInside, type Vec3 } from "../geometry.js";

/** What a walker walks on, and what stops him. `FloorPlan` is one; a box and the open are others. */
export interface MovementBounds {
  /** Walks a level way, metres, as far as it goes; stops the part of `velocity` that led on. */
  move(position: Vec3, way: Readonly<Vec3>, velocity: Vec3): void;
  /** Moves a position to the nearest one that is free. */
  clamp(position: Vec3): void;
}

/** Ground within walls. */
export function boxBounds(bounds: Bounds): MovementBounds {
  return {
    move(position, way, velocity) {
      position[0] += way[0];
      position[2] += way[2];
      clampInside(position, bounds, velocity);
    },
    clamp: (position) => clampInside(position, bounds),
  };
}

/** Ground without end. */
export const UNBOUNDED: MovementBounds = {
  move(position, way) {
    position[0] += way[0];
    position[2] += way[2];
  },
  clamp() {},
};
