import hueLutFrag from "../../../shaders/post/hue-lut.frag";
import type { Gpu, Program, RenderTarget, Texture } from "../../gl/gpu.js";
import type { DisplayTransform } from "./display-pass.js";

/** Texels along an edge: `HUE_LUT_SIZE` of the shader. */
const SIZE = 64;

/** Vibrance of each hue, as a table; without it the display pass took a third longer. */
export class HueLut {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #target: RenderTarget;
  #key = "";

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#program = gpu.pass("post/hue-lut", hueLutFrag);
    this.#target = gpu.renderTarget({
      label: "hue LUT",
      width: SIZE,
      height: SIZE,
      color: ["RGBA16F"],
    });
  }

  /** The table of a display transform. */
  of({ uWhite, uVibrance, uRods }: DisplayTransform): Texture {
    const key = JSON.stringify([uWhite, uVibrance, uRods]);
    if (key !== this.#key) {
      this.#key = key;
      this.#gpu.draw({
        program: this.#program,
        target: this.#target,
        uniforms: { uWhite, uVibrance, uRods, uAdaptation: [1, 1, 1] },
      });
    }
    return this.#target.color;
  }
}
