import type { Draw, Gpu, Program } from "../../gl/gpu.js";
import type { CachedLight } from "../cached-light.js";
import type { FlameCaptures } from "../gi/light-captures.js";
import type { Mesh } from "../mesh/mesh.js";
import type { Tier } from "../quality.js";
import { forwardProgram, nightProgram } from "./forward-programs.js";
import type { FrameBlocks } from "./opaque-stage.js";

/** What forward shading needs beside the mesh. */
export interface LightPass extends Required<Pick<Draw, "textures" | "blocks">> {
  /** For a mesh; without one, for any that is glossy. */
  readonly programOf: (mesh?: Mesh) => Program;
  /** Whether the moon is all that shines. */
  readonly isNight: boolean;
}

interface Context {
  readonly gpu: Gpu;
  readonly tier: Tier;
  readonly blocks: FrameBlocks;
}

/** For the moon alone. */
export function nightPass(
  { gpu, tier, blocks }: Context,
  { shadow, irradiance, block, virtual }: CachedLight,
): LightPass {
  return {
    programOf: () => nightProgram(gpu, tier),
    textures: { uMoonMap: shadow, ...irradiance.textures, ...virtual },
    blocks: { Frame: blocks.Frame, Volume: irradiance.block, Moon: block },
    isNight: true,
  };
}

/** For the carried flame, and for what shines beside it. */
export function lightPass(
  { gpu, tier, blocks }: Context,
  { shadow, irradiance }: FlameCaptures,
  moon: CachedLight | null,
  hasCandles: boolean,
): LightPass {
  const { textures, surfels, block } = irradiance;
  const lights = { isMoonlit: moon !== null, hasCandles };
  return {
    programOf: (mesh) => forwardProgram(gpu, tier, lights, mesh),
    textures: {
      uShadow: shadow.depth,
      ...surfels,
      ...textures,
      ...(moon && {
        uMoonMap: moon.shadow,
        uMoonIrradiance: moon.irradiance.textures.uIrradiance,
      }),
    },
    blocks: { ...blocks, Volume: block, ...(moon && { Moon: moon.block }) },
    isNight: false,
  };
}
