import type { Texture } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";

/** Target of the volumetric stage: the opaque stage's radiance, and its depth. */
export interface VolumetricTarget {
  /** Radiance, cd/m², without a depth attachment, so that `depth` can be sampled. */
  readonly target: TextureView;
  readonly depth: Texture;
}
