import exposureFrag from "../../../shaders/post/exposure.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import meterFrag from "../../../shaders/post/meter.frag";
import type { Gpu } from "../../gl/gpu.js";
import type { Program, ShaderSource } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { EXPOSURE_LAW } from "../../world/player/exposure-adaptation.js";

/** Parts of the picture that are metered, each by 16 taps. */
const PARTS = { width: 32, height: 18 } as const;

/**
 * How the picture is to be exposed: metered from its own light, the flame left out.
 *
 * It keeps nothing from frame to frame: what the eye is behind is the world's to remember.
 */
export class ExposurePass {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #meter: Program;
  readonly #expose: Program;
  readonly #brightness: RenderTarget;
  readonly #exposure: RenderTarget;

  /** @param meter a stage of `lib/metering.glsl` */
  constructor(gpu: Gpu, screen: VertexArray, meter: ShaderSource = meterFrag) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#meter = gpu.program("post/meter", fullscreenVert, meter);
    this.#expose = gpu.program("post/exposure", fullscreenVert, exposureFrag);
    const target = { color: ["RGBA16F"], filter: "nearest" } as const;
    this.#brightness = gpu.renderTarget({ label: "exposure/brightness", ...target, ...PARTS });
    this.#exposure = gpu.renderTarget({ label: "exposure", ...target, width: 1, height: 1 });
  }

  /**
   * The picture's light in, one texel out: stops.
   *
   * @param textures what the meter's stage reads
   * @param lag stops by which the eye is open wider than the picture asks for
   */
  render(
    textures: Readonly<Record<string, Texture>>,
    lag: number,
    blocks: Readonly<Record<string, UniformBlock>> = {},
  ): Texture {
    const { luminance, stops, share, least, most } = EXPOSURE_LAW;
    this.#gpu.draw({
      program: this.#meter,
      target: this.#brightness,
      vertexArray: this.#screen,
      textures,
      blocks,
    });
    this.#gpu.draw({
      program: this.#expose,
      target: this.#exposure,
      vertexArray: this.#screen,
      textures: { uBrightness: this.#brightness.color },
      uniforms: {
        uLaw: [stops + share * Math.log2(luminance), share],
        uLimits: [least, most],
        uLag: lag,
      },
    });
    return this.latest;
  }

  /** What was found last, and nothing before anything was. */
  get latest(): Texture {
    return this.#exposure.color;
  }
}
