import exposureFrag from "../../../shaders/post/exposure.frag";
import meterFrag from "../../../shaders/post/meter.frag";
import type {
  Gpu,
  Program,
  ProgramOptions,
  RenderTarget,
  Texture,
  UniformBlock,
} from "../../gl/gpu.js";
import {
  EXPOSURE_LAW,
  type ExposureAdaptation,
  mostExposure,
} from "../../world/player/exposure-adaptation.js";

/** Metered cells of the frame, each of 16 taps; even numbers. */
const CELLS = { width: 32, height: 18 } as const;

/**
 * Automatic exposure, metered from the frame without the flame.
 *
 * It has no history: the lag of adaptation is part of the world.
 */
export class ExposurePass {
  readonly #gpu: Gpu;
  readonly #meterProgram: Program;
  readonly #exposureProgram: Program;
  readonly #logLuminance: RenderTarget;
  readonly #exposure: RenderTarget;

  /** @param meter defines of the metering pass. Default: it reads radiance */
  constructor(gpu: Gpu, meter: ProgramOptions["defines"] = {}) {
    this.#gpu = gpu;
    this.#meterProgram = gpu.pass("post/meter", meterFrag, { defines: meter });
    this.#exposureProgram = gpu.pass("post/exposure", exposureFrag);
    const color = ["RGBA16F"] as const;
    this.#logLuminance = gpu.renderTarget({ label: "exposure/log-luminance", color, ...CELLS });
    const texel = { width: 1, height: 1, filter: "nearest" } as const;
    this.#exposure = gpu.renderTarget({ label: "exposure", color, ...texel });
  }

  /**
   * Radiance in, one texel out: stops.
   *
   * @param textures of the meter
   * @param roomReflectance mean of the room, one texel
   * @param adaptation of the eye. Default: full, to candlelight
   */
  render(
    textures: Readonly<Record<string, Texture>>,
    roomReflectance: Texture,
    { lag = 0, darkness = 0 }: Partial<Pick<ExposureAdaptation, "lag" | "darkness">>,
    blocks: Readonly<Record<string, UniformBlock>> = {},
  ): Texture {
    const { luminance, stops, share, least, reflectance, keyShare } = EXPOSURE_LAW;
    this.#gpu.draw({
      program: this.#meterProgram,
      target: this.#logLuminance,
      textures,
      blocks,
    });
    this.#gpu.draw({
      program: this.#exposureProgram,
      target: this.#exposure,
      textures: {
        uLogLuminance: this.#logLuminance.color,
        uRoomReflectance: roomReflectance,
      },
      uniforms: {
        uLaw: [stops + share * Math.log2(luminance), share],
        uLimits: [least, mostExposure(darkness)],
        uKey: [reflectance, keyShare],
        uLag: lag,
      },
    });
    return this.latest;
  }

  /** Of the last `render`. */
  get latest(): Texture {
    return this.#exposure.color;
  }
}
