import { mat4 } from "gl-matrix";
import type { Bounds, Vec3 } from "../../world/geometry.js";

/** Nothing is seen nearer to the middle of a cube than this: the candle itself is there. Metres. */
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

/** Clip space of one face, from world space, seen from `eye` (metres). */
export function clipFromFace(face: number, eye: Vec3, out: mat4): mat4 {
  const [direction, up] = FACES[face] ?? [
    [0, 0, -1],
    [0, 1, 0],
  ];
  const ahead: Vec3 = [eye[0] + direction[0], eye[1] + direction[1], eye[2] + direction[2]];
  const clipFromView = mat4.perspective(mat4.create(), Math.PI / 2, 1, NEAR, FAR);
  return mat4.multiply(out, clipFromView, mat4.lookAt(mat4.create(), eye, ahead, up));
}

/** Whether a box may show in one face, seen from `eye` (metres): it touches the pyramid of that face. */
export function isInCubeFace(face: number, eye: Vec3, { min, max }: Bounds): boolean {
  const axis = face >> 1;
  const sign = face % 2 === 0 ? 1 : -1;
  // Farthest reach of the box along the face's direction, from the eye.
  const ahead =
    sign > 0 ? (max[axis] ?? 0) - (eye[axis] ?? 0) : (eye[axis] ?? 0) - (min[axis] ?? 0);
  for (let side = 0; side < 3; side++) {
    if (side === axis) continue;
    const low = (min[side] ?? 0) - (eye[side] ?? 0);
    const high = (max[side] ?? 0) - (eye[side] ?? 0);
    if (low > ahead || -high > ahead) return false;
  }
  return ahead > 0;
}
