import prefilterFrag from "../../../shaders/post/bloom-prefilter.frag";
import type { Box, Gpu, Program, RenderTarget, Texture, TextureFormat } from "../../gl/gpu.js";
import { boundsOf, expandBox, scaleBox } from "../screen-bounds.js";
import { BloomPass } from "./bloom-pass.js";
import type { BloomTransform } from "./display-pass.js";
import type { Bloom } from "./frame-bloom-pass.js";

/** Pixels of the frame for one of the bloom, along each axis. */
export const BLOOM_SCALE = 4;
/** Extent of the bloom around the flame, pixels. */
export const BLOOM_REACH = 96;
/** Extent in which it is drawn: a later frame may show it shifted. */
const FARTHEST = 2 * BLOOM_REACH;

/** A point of the frame, uv. */
type Uv = readonly [number, number];

/**
 * Bloom of the flame alone: nothing else is bright enough.
 *
 * It may be an earlier frame's, shifted with the flame.
 */
export class FlameBloomPass implements Bloom {
  readonly #gpu: Gpu;
  readonly #format: TextureFormat;
  readonly #program: Program;
  readonly #bloom: BloomPass;
  #prefiltered: RenderTarget | null = null;
  #size = { width: 1, height: 1 };
  #latest: Texture | null = null;
  /** Position of the flame in the frame that the bloom is of; null before the first. */
  #flame: Uv | null = null;

  constructor(gpu: Gpu, levels: number, format: TextureFormat) {
    this.#gpu = gpu;
    this.#format = format;
    this.#program = gpu.pass("post/bloom-prefilter", prefilterFrag);
    this.#bloom = new BloomPass(gpu, levels, { format, isFrugal: true });
  }

  resize(width: number, height: number): void {
    this.#prefiltered?.dispose();
    this.#size = { width, height };
    const quarter = {
      width: Math.max(1, Math.ceil(width / BLOOM_SCALE)),
      height: Math.max(1, Math.ceil(height / BLOOM_SCALE)),
    };
    const color = [this.#format];
    this.#prefiltered = this.#gpu.renderTarget({ label: "bloom/prefiltered", ...quarter, color });
    this.#bloom.resize(quarter.width, quarter.height);
    this.#flame = null;
  }

  /** Whether there is a bloom of this size. */
  get isDrawn(): boolean {
    return this.#flame !== null;
  }

  get latest(): Texture {
    if (!this.#latest) throw new Error("The bloom has not been drawn yet.");
    return this.#latest;
  }

  transform([x, y]: Uv): BloomTransform {
    return {
      share: [1, 1],
      shift: this.#flame ? [this.#flame[0] - x, this.#flame[1] - y] : [0, 0],
    };
  }

  /**
   * @param boxes of the radiance that were drawn; all flames in the frame are in them
   * @param flame position of the carried flame
   */
  render(radiance: Texture, boxes: readonly Box[], flame: Uv): void {
    const target = this.#prefiltered!;
    this.#gpu.clear(target, [0, 0, 0, 1]);
    for (const [x, y, width, height] of boxes) {
      const left = Math.floor(x / BLOOM_SCALE) + (x > 0 ? 1 : 0);
      const bottom = Math.floor(y / BLOOM_SCALE) + (y > 0 ? 1 : 0);
      const right = Math.floor((x + width) / BLOOM_SCALE) - (x + width < this.#size.width ? 1 : -1);
      const top =
        Math.floor((y + height) / BLOOM_SCALE) - (y + height < this.#size.height ? 1 : -1);
      this.#gpu.draw({
        program: this.#program,
        target,
        textures: { uSource: radiance },
        scissor: [left, bottom, Math.max(right - left, 0), Math.max(top - bottom, 0)],
      });
    }
    const around = expandBox(boundsOf(boxes), FARTHEST, this.#size);
    const region = scaleBox(around, this.#size, target);
    this.#latest = this.#bloom.render(target.color, target, region);
    this.#flame = flame;
  }
}
