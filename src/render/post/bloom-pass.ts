import downFrag from "../../../shaders/post/bloom-down.frag";
import prefilterFrag from "../../../shaders/post/bloom-prefilter.frag";
import upFrag from "../../../shaders/post/bloom-up.frag";
import type { Box, Gpu, Program, RenderTarget, Texture, TextureFormat } from "../../gl/gpu.js";
import { boundsOf, expandBox, scaleBox } from "../screen-bounds.js";

/** Weight of the coarser levels against each level: the larger, the wider the bloom. */
const COARSER_WEIGHT = 0.7;
/** Pixels of the frame for one of the flame's bloom, along each axis. */
export const BLOOM_SCALE = 4;
/** Extent of the bloom around the flame, pixels. */
export const BLOOM_REACH = 96;
/** Extent in which it is drawn: a later frame may show it shifted. */
const FARTHEST = 2 * BLOOM_REACH;

/** A point of the frame, uv. */
type Uv = readonly [number, number];

/** From uv on a frame to uv on its bloom: scale, offset. */
export type BloomTransform = readonly [number, number, number, number];

/**
 * Bloom: veiling glare of lens and eye, as a pyramid of ever wider blurs, mixed from the widest up.
 *
 * Each step conserves energy. Jimenez 2014, "Next Generation Post Processing in Call of Duty:
 * Advanced Warfare".
 *
 * That of a frame has half its size. Where it is frugal it is that of the flame alone, at a quarter: nothing else is
 * bright enough; it may be an earlier frame's, shifted with the flame.
 */
export class BloomPass {
  readonly #gpu: Gpu;
  /** Null for all of a frame. */
  readonly #prefilter: Program | null;
  readonly #down: Program;
  readonly #up: Program;
  readonly #levels: number;
  readonly #format: TextureFormat;
  #prefiltered: RenderTarget | null = null;
  #pyramid: RenderTarget[] = [];
  #size = { width: 1, height: 1 };
  #latest: Texture | null = null;
  /** The first flame that was in the frame that the bloom is of, in the list of all, and where. */
  #flame: { readonly index: number; readonly uv: Uv } | null = null;

  constructor(gpu: Gpu, levels: number, format: TextureFormat, isFrugal: boolean) {
    this.#format = format;
    this.#gpu = gpu;
    this.#levels = levels;
    this.#prefilter = isFrugal ? gpu.pass("post/bloom-prefilter", prefilterFrag) : null;
    this.#down = gpu.pass("post/bloom-down", downFrag);
    this.#up = gpu.pass("post/bloom-up", upFrag, { defines: { FRUGAL: isFrugal ? 1 : 0 } });
  }

  resize(width: number, height: number): void {
    for (const old of [this.#prefiltered, ...this.#pyramid]) old?.dispose();
    this.#size = { width, height };
    this.#latest = null;
    // Rounded up: a texel of each level covers four of the finer one.
    const target = (name: string, scale: number) =>
      this.#gpu.renderTarget({
        label: `bloom/${name}`,
        width: Math.ceil(width / scale),
        height: Math.ceil(height / scale),
        color: [this.#format],
      });
    if (this.#prefilter) this.#prefiltered = target("prefiltered", BLOOM_SCALE);
    const finest = this.#prefilter ? BLOOM_SCALE : 1;
    this.#pyramid = Array.from({ length: this.#levels }, (_, i) =>
      target(`${i}`, finest * 2 ** (i + 1)),
    );
  }

  /** Whether there is a bloom of this size. */
  get isDrawn(): boolean {
    return this.#latest !== null;
  }

  get latest(): Texture {
    return this.#latest!;
  }

  /** From uv on a frame with the flames at these places to uv on `latest`. */
  transform(flames: readonly (Uv | null)[]): BloomTransform {
    const { width, height } = this.latest; // rounded up
    const scale = this.#prefilter ? BLOOM_SCALE : 2;
    const across = this.#size.width / (scale * width);
    const up = this.#size.height / (scale * height);
    const now = this.#flame && flames[this.#flame.index];
    if (!this.#prefilter || !this.#flame || !now) return [across, up, 0, 0];
    const { uv } = this.#flame;
    return [across, up, across * (uv[0] - now[0]), up * (uv[1] - now[1])];
  }

  /**
   * @param boxes of the radiance that were drawn; all flames in the frame are in them
   * @param flames their positions; null for those that do not burn
   */
  render(radiance: Texture, boxes: readonly Box[], flames: readonly (Uv | null)[]): Texture {
    // At low resolution, texels of half the size would be visible: the last level up is the prefiltered target.
    const full = this.#prefiltered;
    const region = full && this.#drawPrefiltered(full, radiance, boxes);
    const scissorOf = (target: RenderTarget) =>
      full && region ? expandBox(scaleBox(region, full, target), 1, target) : undefined;
    let source = full?.color ?? radiance;
    for (const target of this.#pyramid) {
      if (region) this.#gpu.clear(target, [0, 0, 0, 1]);
      const textures = { uSource: source };
      this.#gpu.draw({ program: this.#down, target, textures, scissor: scissorOf(target) });
      source = target.color;
    }
    const finer = this.#pyramid.toReversed().slice(1);
    for (const target of full ? [...finer, full] : finer) {
      this.#gpu.draw({
        program: this.#up,
        target,
        textures: { uSource: source },
        uniforms: { uWeight: target === full ? 1 : COARSER_WEIGHT },
        blend: "premultiplied",
        scissor: scissorOf(target),
      });
      source = target.color;
    }
    this.#latest = source;
    const index = flames.findIndex((uv) => uv?.every((x) => x >= 0 && x <= 1));
    const uv = flames[index];
    this.#flame = uv ? { index, uv } : null;
    return source;
  }

  /** Fills a target with what blooms. Returns where it is to be blurred: the rest is black. */
  #drawPrefiltered(target: RenderTarget, uSource: Texture, boxes: readonly Box[]): Box {
    this.#gpu.clear(target, [0, 0, 0, 1]);
    const { width: frameWidth, height: frameHeight } = this.#size;
    for (const [x, y, width, height] of boxes) {
      const left = Math.floor(x / BLOOM_SCALE) + (x > 0 ? 1 : 0);
      const bottom = Math.floor(y / BLOOM_SCALE) + (y > 0 ? 1 : 0);
      const right = Math.floor((x + width) / BLOOM_SCALE) - (x + width < frameWidth ? 1 : -1);
      const top = Math.floor((y + height) / BLOOM_SCALE) - (y + height < frameHeight ? 1 : -1);
      this.#gpu.draw({
        program: this.#prefilter!,
        target,
        textures: { uSource },
        scissor: [left, bottom, Math.max(right - left, 0), Math.max(top - bottom, 0)],
      });
    }
    return scaleBox(expandBox(boundsOf(boxes), FARTHEST, this.#size), this.#size, target);
  }
}
