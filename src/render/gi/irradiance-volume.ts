import type { Model } from "../../assets/model.js";
import type { Gpu, Program, Texture, UniformBlock } from "../../gl/gpu.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { interiorBounds } from "./interior-bounds.js";
import type { ProbeDetail } from "./probe-rays.js";

/** Bias along the normal, for the visibility of probes, as a share of their least spacing. */
const NORMAL_BIAS = 0.15;

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

/** Block of `lib/irradiance-volume.glsl`, shared by a room's volumes of one resolution. */
export function volumeBlock(
  gpu: Gpu,
  program: Program,
  { collision, model }: { readonly collision: CollisionMesh; readonly model: Model },
  { probes, inset }: ProbeDetail,
): UniformBlock {
  const [columns, rows, planes] = probes;
  const { min, max, yaw } = interiorBounds(collision, model);
  const lengths = min.map((low, axis) => (max[axis] ?? low) - low);
  const members = {
    corner: min,
    // A floor without walls has no height.
    extent: lengths.map((length) => Math.max(length, 0.01)),
    columns,
    rows,
    planes,
    inset,
    axis: [Math.cos(yaw), Math.sin(yaw)],
    bias: NORMAL_BIAS * Math.min(...probes.map((count, axis) => lengths[axis]! / count)),
  };
  return gpu.share(`Volume ${JSON.stringify(members)}`, () => {
    const block = gpu.uniformBlock(program, "Volume");
    block.update(members);
    return block;
  });
}
