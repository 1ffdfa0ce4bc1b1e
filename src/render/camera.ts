import { mat4 } from "gl-matrix";
import type { Bounds, Vec3 } from "../world/bounds.js";

/** Field of view across the picture's shorter side, radians: the paper's 45 degrees. */
export const FIELD_OF_VIEW = Math.PI / 4;
const NEAR = 0.05;
const FAR = 60;

/** Clip space from world space, for an eye (metres) that looks along -Z at yaw and pitch 0. */
export function clipFromWorld(
  eye: Vec3,
  yaw: number,
  pitch: number,
  aspect: number,
  fieldOfView = FIELD_OF_VIEW,
): mat4 {
  // A phone held upright sees more of floor and ceiling, instead of losing the candle at its side.
  const height = 2 * Math.atan(Math.tan(fieldOfView / 2) / Math.min(aspect, 1));
  const clipFromView = mat4.perspective(mat4.create(), height, aspect, NEAR, FAR);
  const viewFromWorld = mat4.create();
  mat4.rotateX(viewFromWorld, viewFromWorld, -pitch);
  mat4.rotateY(viewFromWorld, viewFromWorld, -yaw);
  mat4.translate(viewFromWorld, viewFromWorld, [-eye[0], -eye[1], -eye[2]]);
  return mat4.multiply(mat4.create(), clipFromView, viewFromWorld);
}

/** Whether a box may show: it is not wholly beyond an edge of the picture, nor behind the eye. */
export function isInSight(clip: mat4, { min, max }: Bounds): boolean {
  const isBeyond = (row: 0 | 1 | 2, sign: 1 | -1) => {
    let most = (clip[15] ?? 0) + sign * (clip[12 + row] ?? 0);
    for (let axis = 0; axis < 3; axis++) {
      const slope = (clip[4 * axis + 3] ?? 0) + sign * (clip[4 * axis + row] ?? 0);
      most += slope * ((slope > 0 ? max[axis] : min[axis]) ?? 0);
    }
    return most < 0;
  };
  return !(
    isBeyond(0, 1) ||
    isBeyond(0, -1) ||
    isBeyond(1, 1) ||
    isBeyond(1, -1) ||
    isBeyond(2, 1)
  );
}

/** Pixels that a thing 1 m wide covers at a distance of 1 m, by the picture's shorter side. */
export function projectionScale(shorterSide: number): number {
  return shorterSide / (2 * Math.tan(FIELD_OF_VIEW / 2));
}
