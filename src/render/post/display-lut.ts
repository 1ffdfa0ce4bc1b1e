import hueLutFrag from "../../../shaders/post/hue-lut.frag";
import toneLutFrag from "../../../shaders/post/tone-lut.frag";
import type { Gpu, Program, RenderTarget, Texture, UniformValue } from "../../gl/gpu.js";
import type { DisplayTransform } from "./display-pass.js";

/** Texels along an edge: `HUE_LUT_SIZE` of the shaders. */
const HUE_SIZE = 64;
/** Hues along an edge, and levels: `TONE_LUT_SIZE` of the shaders. */
const TONE_SIZE = 40;

/** A table of the display transform, filled when that changes. */
export type DisplayLut = (transform: DisplayTransform) => Texture;

/** Vibrance of each hue; without it the display pass took a third longer. */
export function hueLut(gpu: Gpu): DisplayLut {
  const size = { width: HUE_SIZE, height: HUE_SIZE, color: ["RGBA16F"] } as const;
  const fill = filler(
    gpu,
    gpu.pass("post/hue-lut", hueLutFrag),
    gpu.renderTarget({ label: "hue LUT", ...size }),
  );
  return ({ uWhite, uVibrance, uRods }) => fill({ uWhite, uVibrance, uRods });
}

export function toneLut(gpu: Gpu): DisplayLut {
  // Software filters 8 bits twice as fast as floats, and to more bits than they have.
  const size = { width: TONE_SIZE ** 2, height: TONE_SIZE, color: ["RGBA8"] } as const;
  const fill = filler(
    gpu,
    gpu.pass("post/tone-lut", toneLutFrag),
    gpu.renderTarget({ label: "tone LUT", ...size }),
  );
  return ({ uAdaptation: _, ...transform }) => fill(transform);
}

function filler(gpu: Gpu, program: Program, target: RenderTarget) {
  let last = "";
  return (uniforms: Readonly<Record<string, UniformValue>>): Texture => {
    const key = JSON.stringify(uniforms);
    if (key !== last) gpu.draw({ program, target, uniforms });
    last = key;
    return target.color;
  };
}
