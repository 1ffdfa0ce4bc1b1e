import type { Texture } from "../../gl/texture.js";
import type { UniformBlock } from "../../gl/uniform-block.js";

/** Irradiance volume, for shaders that include `lib/irradiance-volume.glsl`. */
export interface IrradianceVolume {
  readonly block: UniformBlock;
  readonly textures: {
    readonly uIrradiance: Texture;
    readonly uProbePositions: Texture;
    readonly uProbeDepth: Texture;
  };
  /** The surfels, and their light, which surfaces mirror: for `lib/distance-impostor.glsl`. */
  readonly surfels: {
    readonly uSurfelNormalDistance: Texture;
    /** In all light, lm/m². */
    readonly uTotalRadiosity: Texture;
  };
  /** Mean reflectance of the room, one texel: for the exposure. */
  readonly roomReflectance: Texture;
  /** Of the surface below the flame, for `lib/support-irradiance.glsl`. */
  readonly support: Texture;
  /** Changes with any of these. */
  readonly revision: number;
}
