import type { Box, Gpu, Texture } from "../../gl/gpu.js";
import type { Size } from "../frame-input.js";
import { BloomPass } from "./bloom-pass.js";
import type { BloomTransform } from "./display-pass.js";

/** Bloom of a frame, drawn anew or that of an earlier one. */
export interface Bloom {
  readonly isDrawn: boolean;
  readonly latest: Texture;
  resize(width: number, height: number): void;
  /** @param regions of the radiance: all that blooms is in them */
  render(radiance: Texture, regions: readonly Box[], flameUv: readonly [number, number]): void;
  /** Where `latest` lies on a frame with the flame at a place. */
  transform(flameUv: readonly [number, number]): BloomTransform;
}

/** Bloom of all that is in the frame, at half its size. */
export class FrameBloomPass implements Bloom {
  readonly #bloom: BloomPass;
  #latest: Texture | null = null;
  #size: Size = { width: 1, height: 1 };

  constructor(gpu: Gpu, levels: number) {
    this.#bloom = new BloomPass(gpu, levels, { format: "RGBA16F", isFrugal: false });
  }

  get isDrawn(): boolean {
    return this.#latest !== null;
  }

  get latest(): Texture {
    if (!this.#latest) throw new Error("There is no bloom yet.");
    return this.#latest;
  }

  resize(width: number, height: number): void {
    this.#size = { width, height };
    this.#bloom.resize(width, height);
    this.#latest = null;
  }

  render(radiance: Texture): void {
    this.#latest = this.#bloom.render(radiance);
  }

  transform(): BloomTransform {
    const { width, height } = this.latest; // half the size, rounded up
    const share = [this.#size.width / (2 * width), this.#size.height / (2 * height)] as const;
    return { share, shift: [0, 0] };
  }
}
