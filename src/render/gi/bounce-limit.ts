import bounceLimitFrag from "../../../shaders/gi/bounce-limit.frag";
import irradianceFrag from "../../../shaders/gi/irradiance.frag";
import type { Gpu, Program, RenderTarget } from "../../gl/gpu.js";
import { IRRADIANCE_TEXELS } from "./probe-rays.js";

export class BounceLimit {
  readonly #gpu: Gpu;
  readonly #weightsProgram: Program;
  readonly #program: Program;
  readonly #weights: RenderTarget;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
    this.#program = gpu.pass("gi/irradiance", irradianceFrag);
    this.#weightsProgram = gpu.pass("gi/bounce-limit", bounceLimitFrag, {
      defines: { IRRADIANCE_TEXELS },
    });
    this.#weights = gpu.renderTarget({
      label: "gi/bounce-limit",
      width: 1,
      height: 1,
      color: ["RGBA16F", "RGBA16F"],
      filter: "nearest",
    });
  }

  /** Irradiance after all bounces, extrapolated from four sums of the series in a row. */
  render([first, before, previous, last]: readonly RenderTarget[], target: RenderTarget): void {
    const textures = { uLast: last!.color, uPrevious: previous!.color, uBefore: before!.color };
    this.#gpu.draw({
      program: this.#weightsProgram,
      target: this.#weights,
      textures: { ...textures, uFirst: first!.color },
    });
    const [uPreviousWeight, uBeforeWeight] = this.#weights.colors;
    this.#gpu.draw({
      program: this.#program,
      target,
      textures: {
        ...textures,
        uPreviousWeight: uPreviousWeight!,
        uBeforeWeight: uBeforeWeight!,
      },
    });
  }
}
