import type {
  Draw,
  Gpu,
  Program,
  RenderTarget,
  TextureFormat,
  UniformBlock,
} from "../../gl/gpu.js";
import type { Rgb } from "../../light/color.js";
import { type CachedLight, candlesOf } from "../cached-light.js";
import { fittedTarget } from "../fitted-target.js";
import type { FlameCaptures } from "../gi/light-captures.js";
import { drawScaled } from "./candle-layers.js";

/** Inputs of a program that shades for all flames at once: as they burn, in cd. */
export class MultiLightInputs {
  readonly #gpu: Gpu;
  readonly #format: TextureFormat;
  #block: UniformBlock | null = null;
  #irradiance: RenderTarget | null = null;

  /** @param format of the irradiance volume */
  constructor(gpu: Gpu, format: TextureFormat) {
    this.#gpu = gpu;
    this.#format = format;
  }

  /**
   * @param program that shades; where candles stand, it has the block `Candles`
   * @param lights the volume of all has theirs
   * @param carried captures of the carried flame, for 1 cd
   */
  inputs(
    program: Program,
    lights: readonly CachedLight[],
    { irradiance: carried }: FlameCaptures,
    intensity: Rgb,
  ): Required<Pick<Draw, "textures" | "blocks">> {
    const { width, height } = carried.textures.uIrradiance;
    const options = { label: "opaque/irradiance", width, height, color: [this.#format] };
    const target = fittedTarget(this.#gpu, this.#irradiance, options);
    this.#irradiance = target;
    for (const light of [{ irradiance: carried, intensity }, ...lights]) {
      const { uIrradiance: uRadiance } = light.irradiance.textures;
      const isFirst = light.irradiance === carried;
      const scissor = isFirst ? undefined : ([0, 0, width, height] as const);
      drawScaled(this.#gpu, [{ uRadiance, uIntensity: light.intensity }], target, scissor);
    }
    const candles = candlesOf(lights);
    const textures = { uIrradiance: target.color };
    const [first] = candles;
    if (!first) return { textures, blocks: {} };
    this.#block ??= this.#gpu.uniformBlock(program, "Candles");
    for (const [i, { light, intensity }] of candles.entries()) {
      const members = Object.entries({ ...light, intensity });
      this.#block.update(
        Object.fromEntries(members.map(([name, value]) => [`candles[${i}].${name}`, value])),
      );
    }
    this.#block.update({ count: candles.length });
    return {
      textures: { ...textures, uStandingShadow: first.shadow },
      blocks: { Candles: this.#block },
    };
  }
}
