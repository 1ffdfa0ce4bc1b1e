/** Vector: a point or a direction in the room: metres, right-handed, +Y up. */
export type Vec3 = [number, number, number];

/** An axis-aligned box, metres. */
export interface Bounds {
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
}

/** The part of a box that is at least `margin` from each of its faces. */
export function inset({ min, max }: Bounds, margin: number): Bounds {
  return {
    min: [min[0] + margin, min[1] + margin, min[2] + margin],
    max: [max[0] - margin, max[1] - margin, max[2] - margin],
  };
}

/**
 * Moves a point to the nearest one inside, and stops the part of `velocity` that led out.
 *
 * A position that is no number is replaced by the middle of the box.
 */
export function clampInside(position: Vec3, { min, max }: Bounds, velocity?: Vec3): void {
  for (let axis = 0; axis < 3; axis++) {
    const value = position[axis]!;
    const low = min[axis]!;
    const high = max[axis]!;
    const clamped = Number.isNaN(value) ? (low + high) / 2 : Math.min(Math.max(value, low), high);
    if (clamped !== value && velocity) velocity[axis] = 0;
    position[axis] = clamped;
  }
}

/** Length of a level vector. `Math.hypot` allocates a list of its arguments. */
export function length2(x: number, z: number): number {
  return Math.sqrt(x * x + z * z);
}

export function length3(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}
