import { mat4 } from "gl-matrix";
import type { Vec3 } from "../../world/bounds.js";

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
