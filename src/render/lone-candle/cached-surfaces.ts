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
/** Images of another shape than the frame, by more than rounding, are not shown. */
const MOST_STRETCH = 0.02;
const SAMPLES = 4;
const CLEAR = [0, 0, 0, 0] as const;

/** Draws the surfaces in one of their lights, within a part of the target. */
export type DrawInLight = (light: number, target: RenderTarget, part: Box) => void;

/**
 * Images of surfaces at rest, one for each light: light adds, so that a frame is their sum, each as bright as its light.
 *
 * They are drawn a band in a step. Meanwhile those before are shown, whatever their size.
 */
export class CachedSurfaces {
  readonly #gpu: Gpu;
  readonly #lights: number;
  readonly #draw: DrawInLight;
  #images: readonly RenderTarget[] = [];
  #key = "";
  #size: Size = { width: 0, height: 0 };
  #steps: Steps | null = null;
  /** Whether the last frame drew no band. */
  #rests = false;
  /** Targets of the images to come. */
  #pending: RenderTarget[] = [];

  constructor(gpu: Gpu, lights: number, draw: DrawInLight) {
    this.#gpu = gpu;
    this.#lights = lights;
    this.#draw = draw;
  }

  /** In the order of the lights, premultiplied; none before the first are complete. */
  get images(): readonly Texture[] {
    return this.#images.map(({ color }) => color);
  }

  /** Gives up images of another shape than a frame of that size. */
  fit(size: Size): void {
    const { width, height } = this.#size;
    const stretch = (size.width * height) / (size.height * width);
    if (Math.abs(stretch - 1) <= MOST_STRETCH) return;
    this.#abandon();
    this.#release();
    this.#size = { width: 0, height: 0 };
  }

  /**
   * Draws the next band of the images of a size or more, if any is missing. True when none is.
   *
   * @param detail all that they depend on beside it
   */
  proceed(size: Size, detail: unknown): boolean {
    const key = JSON.stringify(detail);
    const { width, height } = this.#size;
    const isAsLarge = width >= size.width && height >= size.height;
    if (key !== this.#key || !isAsLarge) {
      this.#abandon();
      this.#key = key;
      const factor = this.#images.length > 0 && !isAsLarge ? AHEAD : 1;
      this.#size = {
        width: Math.ceil(size.width * factor),
        height: Math.ceil(size.height * factor),
      };
      this.#steps = this.#drawAll(this.#size);
    }
    // With images to show, motion is smoother where a frame between two steps has none.
    this.#rests = this.#images.length > 0 && !this.#rests;
    if (!this.#rests && this.#steps?.next().done) this.#steps = null;
    return this.#steps === null;
  }

  *#drawAll({ width, height }: Size): Steps {
    const size = { width, height, color: ["RGBA16F"] as const };
    const label = "candle/cached-samples";
    const samples = this.#target({ ...size, label, depth: "buffer", samples: SAMPLES });
    const images: RenderTarget[] = [];
    const pixels = this.#images.length > 0 ? PIXELS : FIRST_PIXELS;
    const rows = Math.ceil(height / Math.ceil((width * height) / pixels));
    for (let light = 0; light < this.#lights; light++) {
      const image = this.#target({ ...size, label: "candle/cached" });
      images.push(image);
      for (let bottom = 0; bottom < height; bottom += rows) {
        const part: Box = [0, bottom, width, Math.min(rows, height - bottom)];
        this.#gpu.clear(samples, CLEAR, part);
        this.#draw(light, samples, part);
        this.#gpu.resolve(samples, image, part);
        yield;
      }
    }
    this.#release();
    this.#images = images;
    this.#pending = [];
    samples.dispose();
  }

  #target(options: Parameters<Gpu["renderTarget"]>[0]): RenderTarget {
    const target = this.#gpu.renderTarget(options);
    this.#pending.push(target);
    return target;
  }

  #abandon(): void {
    for (const target of this.#pending) target.dispose();
    this.#pending = [];
    this.#steps = null;
  }

  #release(): void {
    for (const image of this.#images) image.dispose();
    this.#images = [];
  }

  dispose(): void {
    this.#abandon();
    this.#release();
  }
}
