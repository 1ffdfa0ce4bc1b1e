import resampleFrag from "../../../shaders/refinement/resample-irradiance.frag";
import type { Gpu, Program, RenderTarget } from "../../gl/gpu.js";
import { irradianceMaps } from "../gi/indirect-targets.js";
import type { IrradianceVolume } from "../gi/irradiance-volume.js";
import { type IndirectDetail, IRRADIANCE_TEXELS } from "../gi/probe-rays.js";

/** Irradiance of another renderer's coarser volume, at the probes of a finer one of the same room. */
export class ResampledIrradiance {
  readonly #gpu: Gpu;
  readonly #detail: IndirectDetail;
  readonly #program: Program;
  #target: RenderTarget | null = null;
  /** Volume that was resampled last. */
  #source: IrradianceVolume | null = null;

  /** @param detail of the finer volume */
  constructor(gpu: Gpu, detail: IndirectDetail) {
    this.#gpu = gpu;
    this.#detail = detail;
    this.#program = gpu.pass("refinement/resample-irradiance", resampleFrag, {
      defines: { IRRADIANCE_TEXELS },
    });
  }

  /** The finer volume with the irradiance of a coarser one, which is resampled unless it was the last. */
  update(source: IrradianceVolume, finer: IrradianceVolume): IrradianceVolume {
    this.#target ??= irradianceMaps(this.#gpu, this.#detail, "refinement/irradiance");
    if (this.#source !== source) {
      this.#source = source;
      this.#gpu.draw({
        program: this.#program,
        target: this.#target,
        textures: { ...source.textures, uFinePositions: finer.textures.uProbePositions },
        blocks: { Volume: source.block },
      });
    }
    return { ...finer, textures: { ...finer.textures, uIrradiance: this.#target.color } };
  }
}
