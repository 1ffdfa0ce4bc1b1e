import type { Texture } from "../../gl/texture.js";
import type { TextureView } from "../../gl/texture-view.js";

/** A picture of the room that what floats in it is drawn over, and how far away the room is there. */
export interface VolumetricTarget {
  /** Radiance, cd/m², without a depth buffer: `depth` can be read meanwhile. */
  readonly target: TextureView;
  readonly depth: Texture;
}
