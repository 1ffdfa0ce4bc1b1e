import type { Box, Gpu, RenderTarget, Texture } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import type { Size } from "../frame-input.js";

/**
 * Pixels of an image that are drawn in a step, a band of it, each of which transforms all vertices: of the first images, and
 * of others, between frames.
 */
const FIRST_PIXELS = 40_000;
const PIXELS = 20_000;
/** Edge of images that replace smaller ones, as a multiple of what is asked for: soon more may be. */
const AHEAD = 1.25;
/** Edge of images at most, as a multiple of what is asked for: those that are larger would shimmer. */
const LARGEST = 2;
/** Most pixels of an image. */
const MOST_PIXELS = 1_000_000;
const SAMPLES = 4;
const CLEAR = [0, 0, 0, 0] as const;

/** Draws the surfaces in one of their lights, within a part of the target. */
export type DrawInLight = (light: number, target: RenderTarget, part: Box) => void;

/**
 * Images of surfaces at rest, one for each light: light adds, so that a frame is their sum, each as bright as its light.
 *
 * They are drawn a band in a step, those that are missing. Meanwhile those before are shown, of another size or shape too.
 */
export class CachedSurfaces {
  readonly #gpu: Gpu;
  readonly #draw: DrawInLight;
  /** Images that are drawn, by what they are of. */
  readonly #drawn = new Map<string, RenderTarget>();
  /** What those to be shown next are of, and those that are shown, in the order of the lights. */
  #next: readonly string[] = [];
  #shown: readonly string[] = [];
  #size: Size = { width: 0, height: 0 };
  #steps: Steps | null = null;
  /** Targets of the image that is being drawn. */
  #pending: RenderTarget[] = [];
  /** Whether the last frame drew no band. */
  #rests = false;

  constructor(gpu: Gpu, draw: DrawInLight) {
    this.#gpu = gpu;
    this.#draw = draw;
  }

  /** In the order of the lights, premultiplied; none before the first are complete. */
  get images(): readonly Texture[] {
    return this.#shown.map((key) => this.#drawn.get(key)!.color);
  }

  /**
   * Draws the next band of the images of a size or more, if any is missing. True when none is.
   *
   * @param details all that the image of each light depends on beside it
   */
  proceed(size: Size, details: readonly unknown[]): boolean {
    if (!this.#fits(size)) this.#size = this.#sizeFor(size);
    const next = details.map((detail, light) => JSON.stringify([this.#size, light, detail]));
    if (next.some((key, light) => key !== this.#next[light])) {
      this.#abandon();
      this.#next = next;
      this.#keep([...next, ...this.#shown]);
      this.#steps = this.#drawMissing();
    }
    // With images to show, motion is smoother where a frame between two steps has none.
    this.#rests = this.#shown.length > 0 && !this.#rests;
    if (!this.#rests && this.#steps?.next().done) this.#steps = null;
    return this.#steps === null;
  }

  /** Whether images are as large as a frame, not much larger, and of its shape but for rounding. */
  #fits(size: Size): boolean {
    const { width, height } = this.#size;
    const { width: least } = limited(size);
    const stretch = Math.abs(size.width * height - size.height * width);
    const isSimilar = width >= least && width <= LARGEST * least;
    return isSimilar && stretch <= Math.max(width, height, size.width, size.height);
  }

  #sizeFor(size: Size): Size {
    const { width, height } = this.#size;
    const isLarger = size.width > width && size.height > height;
    const factor = this.#shown.length > 0 && isLarger ? AHEAD : 1;
    return limited({
      width: Math.ceil(size.width * factor),
      height: Math.ceil(size.height * factor),
    });
  }

  *#drawMissing(): Steps {
    const { width, height } = this.#size;
    const size = { width, height, color: ["RGBA16F"] as const };
    const pixels = this.#shown.length > 0 ? PIXELS : FIRST_PIXELS;
    const rows = Math.ceil(height / Math.ceil((width * height) / pixels));
    for (const [light, key] of this.#next.entries()) {
      if (this.#drawn.has(key)) continue;
      const label = "candle/cached-samples";
      const samples = this.#target({ ...size, label, depth: "buffer", samples: SAMPLES });
      const image = this.#target({ ...size, label: "candle/cached" });
      for (let bottom = 0; bottom < height; bottom += rows) {
        const part: Box = [0, bottom, width, Math.min(rows, height - bottom)];
        this.#gpu.clear(samples, CLEAR, part);
        this.#draw(light, samples, part);
        this.#gpu.resolve(samples, image, part);
        yield;
      }
      samples.dispose();
      this.#pending = [];
      this.#drawn.set(key, image);
    }
    this.#shown = this.#next;
    this.#keep(this.#shown);
  }

  #target(options: Parameters<Gpu["renderTarget"]>[0]): RenderTarget {
    const target = this.#gpu.renderTarget(options);
    this.#pending.push(target);
    return target;
  }

  /** Frees the images of all else. */
  #keep(keys: readonly string[]): void {
    for (const [key, image] of this.#drawn) {
      if (keys.includes(key)) continue;
      image.dispose();
      this.#drawn.delete(key);
    }
  }

  #abandon(): void {
    for (const target of this.#pending) target.dispose();
    this.#pending = [];
    this.#steps = null;
  }

  /** Frees all images; others may follow. */
  dispose(): void {
    this.#abandon();
    this.#next = this.#shown = [];
    this.#keep([]);
  }
}

/** A size of the same shape, of no more pixels than an image may have. */
function limited({ width, height }: Size): Size {
  const factor = Math.min(Math.sqrt(MOST_PIXELS / (width * height)), 1);
  return { width: Math.ceil(width * factor), height: Math.ceil(height * factor) };
}
