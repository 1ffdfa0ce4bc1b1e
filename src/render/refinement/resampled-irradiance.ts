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

  /** Resamples a volume, unless that was the last one. Returns whether it did. */
  update(source: IrradianceVolume, finer: IrradianceVolume): boolean {
    if (this.#source === source) return false;
    this.#source = source;
    this.#target ??= irradianceMaps(this.#gpu, this.#detail, "refinement/irradiance");
    this.#gpu.draw({
      program: this.#program,
      target: this.#target,
      textures: { ...source.textures, uFinePositions: finer.textures.uProbePositions },
      blocks: { Volume: source.block },
    });
    return true;
  }

  /** The finer volume with the irradiance that was resampled. */
  in(finer: IrradianceVolume): IrradianceVolume {
    if (!this.#target) throw new Error("No irradiance was resampled.");
    return { ...finer, textures: { ...finer.textures, uIrradiance: this.#target.color } };
  }
}
