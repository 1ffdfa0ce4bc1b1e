import { vec3 } from "gl-matrix";
import type { Bounds, Vec3 } from "../world/geometry.js";

/** The middles of so many cells along each axis of a box. */
export function* pointsIn({ min, max }: Bounds, counts: Readonly<Vec3>): Generator<Vec3> {
  const [columns, rows, planes] = counts;
  for (let n = 0; n < columns * rows * planes; n++) {
    const cell = [n % columns, Math.floor(n / columns) % rows, Math.floor(n / columns / rows)];
    yield [0, 1, 2].map(
      (axis) => min[axis]! + ((cell[axis]! + 0.5) / counts[axis]!) * (max[axis]! - min[axis]!),
    ) as Vec3;
  }
}

/** Least and largest place of points along an axis. */
export function rangeAlong(axis: Vec3, points: readonly Vec3[]): readonly [number, number] {
  let [least, most] = [Infinity, -Infinity];
  for (const point of points) {
    const along = vec3.dot(axis, point);
    least = Math.min(least, along);
    most = Math.max(most, along);
  }
  return [least, most];
}

/** A point, from a corner and shares of two edges. */
export function pointOn(corner: Vec3, across: Vec3, up: Vec3, column: number, row: number): Vec3 {
  const along = (axis: 0 | 1 | 2) => corner[axis] + column * across[axis] + row * up[axis];
  return [along(0), along(1), along(2)];
}
