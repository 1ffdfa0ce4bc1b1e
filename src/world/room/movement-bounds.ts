import { type Bounds, clampInside, type Vec3 } from "../geometry.js";

/** Bounds of the player's movement: a floor plan, a box, or none. */
export interface MovementBounds {
  /** Moves a position by a level way, metres, as far as it is free; stops the part of `velocity` that led on. */
  move(position: Vec3, way: Readonly<Vec3>, velocity: Vec3): void;
  /** Moves a position to the nearest free one. */
  clamp(position: Vec3): void;
}

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

export const UNBOUNDED = boxBounds({
  min: [-Infinity, -Infinity, -Infinity],
  max: [Infinity, Infinity, Infinity],
});
