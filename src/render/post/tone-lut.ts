import toneLutFrag from "../../../shaders/post/tone-lut.frag";
import type { Gpu, Program, Texture } from "../../gl/gpu.js";
import type { DisplayTransform } from "./display-pass.js";

/** Texels along an edge of the tone LUT: `TONE_LUT_SIZE` of the shader. */
const SIZE = 32;

/** The tone LUT, filled when the display transform changes. */
export class ToneLut {
  readonly #gpu: Gpu;
  readonly #fill: Program;
  readonly #lut: Texture;
  #key = "";

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#fill = gpu.pass("post/tone-lut", toneLutFrag);
    this.#lut = gpu.texture({
      label: "tone LUT",
      // Software filters 8 bits twice as fast as floats, and to more bits than they have.
      format: "RGBA8",
      source: { width: SIZE, height: SIZE },
      shape: { layers: SIZE },
    });
  }

  of({ uAdaptation: _, ...transform }: DisplayTransform): Texture {
    const key = JSON.stringify(transform);
    if (key === this.#key) return this.#lut;
    this.#key = key;
    for (let layer = 0; layer < SIZE; layer++) {
      const target = this.#gpu.textureView({
        label: `tone LUT/${layer}`,
        textures: [this.#lut],
        image: layer,
      });
      this.#gpu.draw({
        program: this.#fill,
        target,
        uniforms: { ...transform, uLayer: layer },
      });
      target.dispose();
    }
    return this.#lut;
  }
}
