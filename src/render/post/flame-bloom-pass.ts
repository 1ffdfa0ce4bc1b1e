import glareFrag from "../../../shaders/post/bloom-prefilter.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Box, Gpu } from "../../gl/gpu.js";
import type { Program } from "../../gl/program.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import { BloomPass } from "./bloom-pass.js";
import type { BloomTransform } from "./display-pass.js";
import type { Bloom } from "./frame-bloom-pass.js";

/** Pixels of the picture for one of what blooms, along each axis. */
export const GLARE = 4;
/** How far the halo reaches around what glows, pixels. */
export const BLOOM_REACH = 96;

/** A place in the picture, as shares of it. */
type Place = readonly [number, number];

/** The bloom of the flame alone: nothing else is bright enough. It goes with the flame, and may be an older one. */
export class FlameBloomPass implements Bloom {
  readonly #gpu: Gpu;
  readonly #screen: VertexArray;
  readonly #format: TextureFormat;
  readonly #program: Program;
  readonly #bloom: BloomPass;
  #glare: RenderTarget | null = null;
  #size = { width: 1, height: 1 };
  #latest: Texture | null = null;
  /** Where the flame was in the picture that it is of; null before there is one. */
  #at: Place | null = null;

  constructor(gpu: Gpu, screen: VertexArray, levels: number, format: TextureFormat) {
    this.#gpu = gpu;
    this.#screen = screen;
    this.#format = format;
    this.#program = gpu.program("post/bloom-prefilter", fullscreenVert, glareFrag);
    this.#bloom = new BloomPass(gpu, screen, levels, { format, isFrugal: true });
  }

  resize(width: number, height: number): void {
    this.#glare?.dispose();
    this.#size = { width, height };
    const quarter = {
      width: Math.max(1, Math.ceil(width / GLARE)),
      height: Math.max(1, Math.ceil(height / GLARE)),
    };
    this.#glare = this.#gpu.renderTarget({ label: "glare", ...quarter, color: [this.#format] });
    this.#bloom.resize(quarter.width, quarter.height);
    this.#at = null;
  }

  /** Whether there is one. */
  get isDrawn(): boolean {
    return this.#at !== null;
  }

  get latest(): Texture {
    if (!this.#latest) throw new Error("There is no halo yet.");
    return this.#latest;
  }

  transform([x, y]: Place): BloomTransform {
    return { share: [1, 1], shift: this.#at ? [this.#at[0] - x, this.#at[1] - y] : [0, 0] };
  }

  /**
   * @param box of the radiance that was drawn: all that glows is in it
   * @param flame where it is
   */
  render(radiance: Texture, [x, y, width, height]: Box, flame: Place): void {
    const glare = this.#glare!;
    const left = Math.floor(x / GLARE) + (x > 0 ? 1 : 0);
    const bottom = Math.floor(y / GLARE) + (y > 0 ? 1 : 0);
    const right = Math.floor((x + width) / GLARE) - (x + width < this.#size.width ? 1 : -1);
    const top = Math.floor((y + height) / GLARE) - (y + height < this.#size.height ? 1 : -1);
    this.#gpu.clear(glare, [0, 0, 0, 1]);
    this.#gpu.draw({
      program: this.#program,
      target: glare,
      vertexArray: this.#screen,
      textures: { uSource: radiance },
      scissor: [left, bottom, Math.max(right - left, 0), Math.max(top - bottom, 0)],
    });
    this.#latest = this.#bloom.render(glare.color, glare);
    this.#at = flame;
  }
}
