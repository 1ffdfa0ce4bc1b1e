import displayFrag from "../../../shaders/post/display.frag";
import displayVert from "../../../shaders/post/display.vert";
import type { Box, Gpu, Program, Surface, Texture, UniformBlock } from "../../gl/gpu.js";
import { adaptedWhite, P3_FROM_RGB, type Rgb, VIBRANCE } from "../../light/color.js";
import { ADAPTATION, TAPER } from "../../light/flame-light.js";
import { nightVision } from "../../light/night-vision.js";
import { EXPOSURE_LAW } from "../../world/player/exposure-adaptation.js";
import type { FrameSettings } from "../frame-settings.js";
import type { BloomTransform } from "./bloom-pass.js";
import { type DisplayLut, hueLut } from "./display-lut.js";

/** Share of the light that eye and lens scatter. */
const GLARE_SHARE = 0.0006;
/** Exposure without metering: from cd/m² to the display's white. */
const FIXED_EXPOSURE = 2 ** EXPOSURE_LAW.stops;
const UNADAPTED: Rgb = [1, 1, 1];
const WHITE = adaptedWhite();
/** From linear Rec. 709 to the primaries of the screen, by columns. */
const GAMUT: Readonly<Record<PredefinedColorSpace, readonly number[]>> = {
  srgb: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  "display-p3": [0, 1, 2].flatMap((column) => P3_FROM_RGB.map((row) => row[column] ?? 0)),
};

/** `Frame.exposure`: the factor on top of the metered exposure, or in its place. */
export function exposureFactor({ features, exposure }: FrameSettings): number {
  return 2 ** exposure * (features.autoExposure ? 1 : FIXED_EXPOSURE);
}

/**
 * Uniforms of `lib/display-transform.glsl`. Sets the canvas to the view's primaries.
 *
 * @param darkness adaptation of the eye to moonlight, 0 to 1
 */
export function displayTransform(
  gpu: Gpu,
  { features, gamut }: Pick<FrameSettings, "features" | "gamut">,
  darkness: number,
) {
  const { contrast, rods } = nightVision(darkness);
  return {
    uContrast: contrast,
    uRods: features.adaptation ? rods : 0,
    uAdaptation: features.adaptation ? ADAPTATION : UNADAPTED,
    uWhite: features.adaptation ? WHITE : TAPER.color,
    uVibrance: features.adaptation ? VIBRANCE : 0,
    uToneMapped: features.toneMap ? 1 : 0,
    uGamut: GAMUT[gpu.setColorSpace(gamut)],
  };
}

export type DisplayTransform = ReturnType<typeof displayTransform>;

/** Gains that make candlelight white, luma 1. */
export function whiteBalance({ uAdaptation, uWhite }: DisplayTransform): Rgb {
  const gain = (i: 0 | 1 | 2) => uAdaptation[i] / uWhite[i];
  return [gain(0), gain(1), gain(2)];
}

/** Uniforms of what displays: with the bloom, and by the exposure. */
export function displayUniforms(
  transform: DisplayTransform,
  { features }: Pick<FrameSettings, "features">,
  uBloomTransform: BloomTransform,
) {
  return {
    uWhiteBalance: whiteBalance(transform),
    uAutoExposure: features.autoExposure ? 1 : 0,
    uBloomTransform,
    uGlareShare: features.bloom ? GLARE_SHARE : 0,
  };
}

export type DisplayUniforms = ReturnType<typeof displayUniforms>;

/** Exposure, bloom and display transform: from cd/m² to the canvas. */
export class DisplayPass {
  readonly #gpu: Gpu;
  readonly #program: Program;
  /** Null with a tone LUT. */
  readonly #hueLut: DisplayLut | null;

  /** @param usesToneLut whether the display transform is looked up in `uToneLut`, but for the brightest light */
  constructor(gpu: Gpu, usesToneLut = false) {
    this.#gpu = gpu;
    const defines = { TONE_LUT: usesToneLut ? 1 : 0 };
    this.#program = gpu.program("post/display", displayVert, displayFrag, { defines });
    this.#hueLut = usesToneLut ? null : hueLut(gpu);
  }

  /** @param scissor part of the frame; all of it if absent */
  render(
    textures: Readonly<Record<"uRadiance" | "uBloom" | "uExposure", Texture>> & {
      readonly uToneLut?: Texture;
    },
    uniforms: DisplayUniforms,
    transform: DisplayTransform,
    frame: UniformBlock,
    scissor?: Box,
    screen: Surface = "canvas",
  ): void {
    this.#gpu.draw({
      program: this.#program,
      target: screen,
      textures: { ...textures, ...(this.#hueLut && { uHueLut: this.#hueLut(transform) }) },
      uniforms: { ...transform, ...uniforms },
      blocks: { Frame: frame },
      scissor,
    });
  }
}
