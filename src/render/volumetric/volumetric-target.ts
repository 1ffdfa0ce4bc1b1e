import type { Gpu } from "../../gl/gpu.js";
import type { RenderTarget } from "../../gl/render-target.js";
import type { Texture, TextureFormat } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";
import type { Size } from "../frame-input.js";

export interface VolumetricTarget {
  /** Radiance, cd/m², without a depth attachment, so that `depth` can be sampled. */
  readonly target: TextureView;
  /** Of the opaque surfaces. */
  readonly depth: Texture;
}

/** The composited frame: opaque surfaces, and later the media. */
export interface CompositedFrame extends VolumetricTarget {
  /** The radiance to read. */
  readonly color: Texture;
  /** The radiance with a depth buffer to test against. */
  readonly tested: TextureView;
}

/** Radiance of a frame, to composite with the depth of any layer. */
export class RadianceTarget {
  readonly whole: RenderTarget;
  readonly #gpu: Gpu;
  readonly #target: TextureView;
  /** With each depth that it was composited with. */
  readonly #tested = new Map<Texture, TextureView>();

  constructor(gpu: Gpu, size: Size, format: TextureFormat) {
    this.#gpu = gpu;
    this.whole = gpu.renderTarget({ label: "radiance", ...size, color: [format] });
    const textures = [this.whole.color];
    this.#target = gpu.textureView({ label: "radiance", textures, image: 0 });
  }

  with(depth: Texture): CompositedFrame {
    const { color } = this.whole;
    let tested = this.#tested.get(depth);
    if (!tested) {
      const view = { label: "radiance and depth", textures: [color], image: 0, depth };
      tested = this.#gpu.textureView(view);
      this.#tested.set(depth, tested);
    }
    return { color, target: this.#target, tested, depth };
  }

  dispose(): void {
    for (const old of [this.#target, this.whole, ...this.#tested.values()]) old.dispose();
  }
}
