import hueLutFrag from "../../../shaders/post/hue-lut.frag";
import toneLutFrag from "../../../shaders/post/tone-lut.frag";
import type { Gpu, Program, Texture, UniformValue } from "../../gl/gpu.js";
import type { DisplayTransform } from "./display-pass.js";

/** Texels along an edge: `HUE_LUT_SIZE` and `TONE_LUT_SIZE` of the shaders. */
const HUE_SIZE = 64;
const TONE_SIZE = 32;

/** A table of the display transform, filled when that changes. */
export type DisplayLut = (transform: DisplayTransform) => Texture;

/** Vibrance of each hue; without it the display pass took a third longer. */
export function hueLut(gpu: Gpu): DisplayLut {
  const program = gpu.pass("post/hue-lut", hueLutFrag);
  const source = { width: HUE_SIZE, height: HUE_SIZE };
  const table = gpu.texture({ label: "hue LUT", format: "RGBA16F", source });
  const fill = filler(gpu, program, table, 1);
  return ({ uWhite, uVibrance, uRods }) =>
    fill({ uWhite, uVibrance, uRods, uAdaptation: [1, 1, 1] });
}

export function toneLut(gpu: Gpu): DisplayLut {
  const program = gpu.pass("post/tone-lut", toneLutFrag);
  const [source, shape] = [{ width: TONE_SIZE, height: TONE_SIZE }, { layers: TONE_SIZE }];
  // Software filters 8 bits twice as fast as floats, and to more bits than they have.
  const table = gpu.texture({ label: "tone LUT", format: "RGBA8", source, shape });
  const fill = filler(gpu, program, table, TONE_SIZE);
  return ({ uAdaptation: _, ...transform }) => fill(transform);
}

function filler(gpu: Gpu, program: Program, table: Texture, layers: number) {
  let last = "";
  return (inputs: Readonly<Record<string, UniformValue>>): Texture => {
    const key = JSON.stringify(inputs);
    for (let layer = 0; key !== last && layer < layers; layer++) {
      const label = `${table.label}/${layer}`;
      const target = gpu.textureView({ label, textures: [table], image: layer });
      const uniforms = layers > 1 ? { ...inputs, uLayer: layer } : inputs;
      gpu.draw({ program, target, uniforms });
      target.dispose();
    }
    last = key;
    return table;
  };
}
