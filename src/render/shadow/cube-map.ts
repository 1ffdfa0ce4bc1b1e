import { mat4 } from "gl-matrix";
import type { Vec3 } from "../../world/geometry.js";

/** Near plane of a candle's cube, metres: the candle itself is nearer to the centre. */
export const NEAR = 0.04;
const FAR = 60;

/** Faces of a cube map, in GL's order: their axes, and which way along them. */
export const FACES = [0, 1, 2, 3, 4, 5].map((face) => ({
  axis: face >> 1,
  sign: face % 2 === 0 ? 1 : -1,
}));

/**
 * Clip space of one face of a cube map around `origin` (metres), from world space. Down is up in the view through the four
 * sides, as in GL's cube maps.
 */
export function clipFromFace(face: number, origin: Readonly<Vec3>): Float32Array {
  const { axis, sign } = FACES[face]!;
  const ahead: Vec3 = [...origin];
  ahead[axis]! += sign;
  const clip = mat4.lookAt(mat4.create(), origin, ahead, axis === 1 ? [0, 0, sign] : [0, -1, 0]);
  const clipFromView = mat4.perspective(mat4.create(), Math.PI / 2, 1, NEAR, FAR);
  return mat4.multiply(clip, clipFromView, clip) as Float32Array;
}

/**
 * Clip space of one face of the shadow cube, of `FACES`' axis and sign, from world space. Depth in [0, 1] is
 * 1 - near / distance along the axis: linear across a plane, as in `shaders/lib/shadow-tiles.glsl`.
 *
 * @param reach half the width of what is drawn, as a share of the distance along the axis
 * @param near distance of the near plane, metres
 */
export function clipFromShadowFace(
  face: number,
  origin: Vec3,
  reach: number,
  near: number,
): Float32Array {
  const { axis: ahead, sign } = FACES[face]!;
  const rows: readonly (readonly [axis: number, scale: number])[] = [
    [(ahead + 1) % 3, sign / reach],
    [(ahead + 2) % 3, sign / reach],
    [ahead, sign],
    [ahead, sign],
  ];
  const out = new Float32Array(16);
  for (const [row, [axis, scale]] of rows.entries()) {
    out[axis * 4 + row] = scale;
    out[12 + row] = -scale * origin[axis]!;
  }
  out[14]! -= 2 * near;
  return out;
}
