import { mat4 } from "gl-matrix";
import type { Bounds, Vec3 } from "../world/geometry.js";

/** Field of view across the image's shorter side, radians: the paper's 45 degrees. */
export const FIELD_OF_VIEW = Math.PI / 4;
/** Depths of the clip planes, metres. */
export const NEAR = 0.05;
export const FAR = 60;

/** Clip space from world space. At yaw and pitch 0 the camera at `eye` (metres) looks along -Z. */
export function clipFromWorld(
  eye: Vec3,
  yaw: number,
  pitch: number,
  aspect: number,
  fieldOfView = FIELD_OF_VIEW,
): mat4 {
  // A portrait image gains floor and ceiling, instead of losing the candle at its side.
  const height = 2 * Math.atan(Math.tan(fieldOfView / 2) / Math.min(aspect, 1));
  const clipFromView = mat4.perspective(mat4.create(), height, aspect, NEAR, FAR);
  const viewFromWorld = mat4.create();
  mat4.rotateX(viewFromWorld, viewFromWorld, -pitch);
  mat4.rotateY(viewFromWorld, viewFromWorld, -yaw);
  mat4.translate(viewFromWorld, viewFromWorld, [-eye[0], -eye[1], -eye[2]]);
  return mat4.multiply(mat4.create(), clipFromView, viewFromWorld);
}

/** A plane (a, b, c, d): points with ax + by + cz + d < 0 are outside. */
type Plane = readonly [number, number, number, number];

/** Planes of the view frustum: four sides, and the near one. */
function frustumPlanes(clip: mat4): readonly Plane[] {
  const plane = (row: 0 | 1 | 2, sign: 1 | -1) =>
    [0, 1, 2, 3].map(
      (column) => clip[4 * column + 3]! + sign * clip[4 * column + row]!,
    ) as unknown as Plane;
  return [plane(0, 1), plane(0, -1), plane(1, 1), plane(1, -1), plane(2, 1)];
}

function isOutside([x, y, z, w]: Plane, { min, max }: Bounds, margin = 0): boolean {
  const alongX = x * (x > 0 ? max[0] + margin : min[0] - margin);
  const alongY = y * (y > 0 ? max[1] + margin : min[1] - margin);
  const alongZ = z * (z > 0 ? max[2] + margin : min[2] - margin);
  return alongX + alongY + alongZ + w < 0;
}

/** Frustum culling: a test of boxes for visibility. */
export function frustumTest(clip: mat4): (box: Bounds) => boolean {
  const planes = frustumPlanes(clip);
  return (box) => !planes.some((plane) => isOutside(plane, box));
}

/**
 * Culling of shadow casters: a test of boxes whether they may shadow anything in the view frustum. They are not
 * outside of a plane that has the light inside.
 *
 * @param margin width of the light, metres
 */
export function shadowFrustumTest(
  clip: mat4,
  light: Vec3,
  margin: number,
): (box: Bounds) => boolean {
  const planes = frustumPlanes(clip).filter(
    (plane) => !isOutside(plane, { min: light, max: light }),
  );
  return (box) => !planes.some((plane) => isOutside(plane, box, margin));
}

/** Returns x, y and w. */
export function clipPosition(
  m: mat4,
  x: number,
  y: number,
  z: number,
): readonly [number, number, number] {
  const row = (i: number) => m[i]! * x + m[i + 4]! * y + m[i + 8]! * z + m[i + 12]!;
  return [row(0), row(1), row(3)];
}

/** Pixels of a length of 1 m at a distance of 1 m, by the image's shorter side. */
export function projectionScale(shorterSide: number, fieldOfView = FIELD_OF_VIEW): number {
  return shorterSide / (2 * Math.tan(fieldOfView / 2));
}
