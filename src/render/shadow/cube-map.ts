import { mat4 } from "gl-matrix";
import type { Bounds, Vec3 } from "../../world/geometry.js";

/** Near plane, metres: the candle itself is nearer to the centre of the cube. */
const NEAR = 0.04;
const FAR = 60;

/** Direction and up of each face of a cube map, in GL's order. */
export const FACES: readonly (readonly [direction: Vec3, up: Vec3])[] = [
  [
    [1, 0, 0],
    [0, -1, 0],
  ],
  [
    [-1, 0, 0],
    [0, -1, 0],
  ],
  [
    [0, 1, 0],
    [0, 0, 1],
  ],
  [
    [0, -1, 0],
    [0, 0, -1],
  ],
  [
    [0, 0, 1],
    [0, -1, 0],
  ],
  [
    [0, 0, -1],
    [0, -1, 0],
  ],
];

/** Clip space of one face of a cube around `origin` (metres), from world space. */
export function clipFromFace(face: number, origin: Vec3, out: mat4): mat4 {
  const [direction, up] = FACES[face] ?? [
    [0, 0, -1],
    [0, 1, 0],
  ];
  const target: Vec3 = [
    origin[0] + direction[0],
    origin[1] + direction[1],
    origin[2] + direction[2],
  ];
  const clipFromView = mat4.perspective(mat4.create(), Math.PI / 2, 1, NEAR, FAR);
  return mat4.multiply(out, clipFromView, mat4.lookAt(mat4.create(), origin, target, up));
}

/** Whether a box may touch the frustum of one face of a cube around `origin` (metres). */
export function isInCubeFace(face: number, origin: Vec3, { min, max }: Bounds): boolean {
  const axis = face >> 1;
  const sign = face % 2 === 0 ? 1 : -1;
  // Farthest extent of the box along the face's direction.
  const ahead =
    sign > 0 ? (max[axis] ?? 0) - (origin[axis] ?? 0) : (origin[axis] ?? 0) - (min[axis] ?? 0);
  for (let side = 0; side < 3; side++) {
    if (side === axis) continue;
    const low = (min[side] ?? 0) - (origin[side] ?? 0);
    const high = (max[side] ?? 0) - (origin[side] ?? 0);
    if (low > ahead || -high > ahead) return false;
  }
  return ahead > 0;
}
