import type { Gpu, RenderTarget, Texture, TextureFormat, TextureView } from "../../gl/gpu.js";
import type { Size } from "../frame-input.js";

/** The composited frame: opaque surfaces, and later the media. */
export interface CompositedFrame {
  /** Radiance, cd/m², without a depth attachment, so that `depth` can be sampled. */
  readonly target: RenderTarget | TextureView;
  /** Of the opaque surfaces. */
  readonly depth: Texture;
  /** The radiance to read. */
  readonly color: Texture;
  /** The radiance with a depth buffer to test against. */
  readonly tested: TextureView;
}

/** Radiance of a frame, to composite with the depth of any layer. */
export class RadianceTarget {
  readonly whole: RenderTarget;
  readonly #gpu: Gpu;
  /** With each depth that it was composited with. */
  readonly #tested = new Map<Texture, TextureView>();

  constructor(gpu: Gpu, size: Size, format: TextureFormat) {
    this.#gpu = gpu;
    this.whole = gpu.renderTarget({ label: "radiance", ...size, color: [format] });
  }

  with(depth: Texture): CompositedFrame {
    const { color } = this.whole;
    let tested = this.#tested.get(depth);
    if (!tested) {
      const view = { label: "radiance and depth", textures: [color], depth };
      tested = this.#gpu.textureView(view);
      this.#tested.set(depth, tested);
    }
    return { color, target: this.whole, tested, depth };
  }

  dispose(): void {
    for (const old of [this.whole, ...this.#tested.values()]) old.dispose();
  }
}
