import type { Texture } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";

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
