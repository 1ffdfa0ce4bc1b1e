import { mat4 } from "gl-matrix";
import type { Vec3 } from "../world/bounds.js";

/** Vertical field of view, radians: the paper's 45 degrees. */
export const FIELD_OF_VIEW = Math.PI / 4;
const NEAR = 0.05;
const FAR = 60;

/** Clip space from world space, for an eye (metres) that looks along -Z at yaw and pitch 0. */
export function clipFromWorld(eye: Vec3, yaw: number, pitch: number, aspect: number): mat4 {
  const clipFromView = mat4.perspective(mat4.create(), FIELD_OF_VIEW, aspect, NEAR, FAR);
  const viewFromWorld = mat4.create();
  mat4.rotateX(viewFromWorld, viewFromWorld, -pitch);
  mat4.rotateY(viewFromWorld, viewFromWorld, -yaw);
  mat4.translate(viewFromWorld, viewFromWorld, [-eye[0], -eye[1], -eye[2]]);
  return mat4.multiply(mat4.create(), clipFromView, viewFromWorld);
}

/** Pixels that a thing 1 m wide covers at a distance of 1 m. */
export function projectionScale(height: number): number {
  return height / (2 * Math.tan(FIELD_OF_VIEW / 2));
}
