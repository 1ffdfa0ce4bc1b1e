import displayFrag from "../../../shaders/post/display.frag";
import displayVert from "../../../shaders/post/display.vert";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { adaptation, adaptedWhite, P3_FROM_RGB, type Rgb, VIBRANCE } from "../../light/color.js";
import { TAPER } from "../../light/flame-light.js";
import { EXPOSURE_LAW } from "../../world/player/exposure-adaptation.js";
import type { FrameSettings } from "../frame-settings.js";

/** Share of the light that the eye and the lens scatter. */
const SCATTERED = 0.0006;
/** From cd/m² to the display's white, where nothing meters. */
const FIXED_EXPOSURE = 2 ** EXPOSURE_LAW.stops;
const ADAPTATION = adaptation(TAPER.color);
const UNADAPTED: Rgb = [1, 1, 1];
const WHITE = adaptedWhite();
/** From linear Rec. 709 to the primaries of the screen, by columns. */
const GAMUT: Readonly<Record<PredefinedColorSpace, readonly number[]>> = {
  srgb: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  "display-p3": [0, 1, 2].flatMap((column) => P3_FROM_RGB.map((row) => row[column] ?? 0)),
};

/** Share of the light that this view scatters. */
export function glareShareOf({ features }: Pick<FrameSettings, "features">): number {
  return features.bloom ? SCATTERED : 0;
}

/** What metered stops, or none, are multiplied with: `Frame.exposure`. */
export function exposureFactor({ features, exposure }: FrameSettings): number {
  return 2 ** exposure * (features.autoExposure ? 1 : FIXED_EXPOSURE);
}

/** Uniforms of `lib/display-transform.glsl`, for a canvas that from now on has these primaries. */
export function displayTransform(
  gpu: Gpu,
  { features, gamut }: Pick<FrameSettings, "features" | "gamut">,
) {
  return {
    uAdaptation: features.adaptation ? ADAPTATION : UNADAPTED,
    uWhite: features.adaptation ? WHITE : TAPER.color,
    uVibrance: features.adaptation ? VIBRANCE : 0,
    uToneMapped: features.toneMap ? 1 : 0,
    uGamut: GAMUT[gpu.paintIn(gamut)],
  };
}

export type DisplayTransform = ReturnType<typeof displayTransform>;

/** Where a bloom lies on the picture. */
export interface BloomTransform {
  /** Of its texture that the picture fills. */
  readonly share: readonly [number, number];
  /** What has to be added to a place in the picture, as shares of it. */
  readonly shift: readonly [number, number];
}

/** The end of the picture's light: from cd/m² to the canvas. */
export class DisplayPass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  readonly #screen: VertexArray;

  /** @param isTabled whether most of it is looked up in a table, `uToneLut` */
  constructor(gpu: Gpu, screen: VertexArray, isTabled = false) {
    this.#gpu = gpu;
    this.#screen = screen;
    const defines = { TONE_LUT: isTabled ? 1 : 0 };
    this.#program = gpu.program("post/display", displayVert, displayFrag, { defines });
  }

  /**
   * @param exposure one texel, stops
   * @param scissor part of the picture; all of it if absent
   */
  render(
    textures: Readonly<Record<"uRadiance" | "uBloom" | "uExposure", Texture>> & {
      readonly uToneLut?: Texture;
    },
    { share, shift }: BloomTransform,
    view: Pick<FrameSettings, "features" | "gamut">,
    frame: UniformBlock,
    scissor?: Box,
  ): void {
    this.#gpu.draw({
      program: this.#program,
      target: "canvas",
      vertexArray: this.#screen,
      textures,
      uniforms: {
        ...displayTransform(this.#gpu, view),
        uAutoExposure: view.features.autoExposure ? 1 : 0,
        uBloomTransform: [...share, share[0] * shift[0], share[1] * shift[1]],
        uGlareShare: glareShareOf(view),
      },
      blocks: { Frame: frame },
      scissor,
    });
  }
}
