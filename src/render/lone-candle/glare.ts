import type { mat4 } from "gl-matrix";
import { luma } from "../../light/color.js";
import type { FlameLight } from "../../light/flame-light.js";
import { clipPosition } from "../camera.js";
import type { FrameSettings } from "../frame-settings.js";

/** Of a flame's glare: brightest that counts, cd, and strength for each candela. */
const BRIGHTEST_GLARE = 2;
const GLARE = 0.55;

/**
 * Factor on the glare, which is added to colours of the display: they go with about the root of light.
 *
 * @param factor of the exposure, over that of a taper alone, beside the setting's
 */
export function glareFactor({ features, exposure }: FrameSettings, factor = 1): number {
  return features.bloom ? Math.sqrt(factor * 2 ** exposure) : 0;
}

/** Centre of a light on the canvas, and its half height, uv; strength of its glare, by a factor. */
export function glareOf(
  { position: [x, y, z], halfHeight, intensity }: FlameLight,
  clip: mat4,
  factor: number,
): readonly [number, number, number, number] {
  const [u, v] = canvasUv(clip, x, y, z);
  const [, top] = canvasUv(clip, x, y + halfHeight, z);
  // Exactly none without a factor, even if the intensity is no number.
  const strength = factor === 0 ? 0 : factor * GLARE * Math.min(luma(intensity), BRIGHTEST_GLARE);
  return [u, v, Math.abs(top - v), strength];
}

/** uv on the canvas of a point in world space. */
function canvasUv(clip: mat4, x: number, y: number, z: number): readonly [number, number] {
  const [across, up, w] = clipPosition(clip, x, y, z);
  return [0.5 + (0.5 * across) / w, 0.5 + (0.5 * up) / w];
}
