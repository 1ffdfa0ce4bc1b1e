import type { Draw, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Rgb } from "../../light/color.js";
import type { IrradianceVolume } from "../gi/indirect-pass.js";
import type { KeptLight } from "../kept-light.js";
import { drawScaled } from "./candle-layers.js";

/** Inputs of the program that shades for all flames at once: as they burn, in cd. */
export class StandingLights {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #block: UniformBlock;
  /** Irradiance volume of all flames. */
  #irradiance: RenderTarget | null = null;

  /** @param program that has the block `Candles` */
  constructor(gpu: Gpu, screen: VertexArray, program: Program) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#block = gpu.uniformBlock(program, "Candles");
  }

  /** @param carried the volume of the carried flame, for 1 cd */
  inputs(
    candles: readonly KeptLight[],
    carried: IrradianceVolume,
    intensity: Rgb,
  ): Required<Pick<Draw, "textures" | "blocks">> {
    const { width, height } = carried.textures.uIrradiance;
    this.#irradiance ??= this.#gpu.renderTarget({
      label: "forward/irradiance",
      width,
      height,
      color: ["RGBA16F"],
    });
    const target = this.#irradiance;
    for (const { irradiance, ...light } of [{ irradiance: carried, intensity }, ...candles]) {
      const from = irradiance.textures.uIrradiance;
      const scissor = irradiance === carried ? undefined : ([0, 0, width, height] as const);
      drawScaled(this.#gpu, this.#screen, from, target, light.intensity, scissor);
    }
    for (const [i, { light, intensity }] of candles.entries()) {
      const members = Object.entries({ ...light, intensity });
      this.#block.update(
        Object.fromEntries(members.map(([name, value]) => [`candles[${i}].${name}`, value])),
      );
    }
    this.#block.update({ count: candles.length });
    return {
      textures: { uStandingShadow: candles[0]!.shadow, uIrradiance: target.color },
      blocks: { Candles: this.#block },
    };
  }
}
