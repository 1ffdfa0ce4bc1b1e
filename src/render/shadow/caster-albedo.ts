import casterAlbedoFrag from "../../../shaders/shadow/caster-albedo.frag";
import type { Gpu, Texture } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { floats } from "../float-format.js";
import type { Mesh } from "../mesh/mesh.js";

/** Texels of a tile: `CASTER_TILE` of `shaders/lib/caster-albedo.glsl`. */
const TILE = { width: 16, height: 32 } as const;
/** Tiles side by side: `CASTER_COLUMNS`. */
const COLUMNS = 128;

/**
 * Caster albedo: what all surfaces of a model reflect, in one small texture, so that a capture of surfels draws them
 * together. Each has a tile with its levels of detail. Made once for each model, a surface in each step.
 */
export function* casterAlbedoOf(gpu: Gpu, surfaces: readonly Mesh[]): Steps<Texture> {
  const albedo = gpu.share(surfaces, () => ({
    drawn: 0,
    target: gpu.renderTarget({
      label: "caster albedo",
      width: TILE.width * Math.min(surfaces.length, COLUMNS),
      height: TILE.height * Math.ceil(surfaces.length / COLUMNS),
      color: [floats(gpu, 4)],
      filter: "nearest",
    }),
  }));
  const { target } = albedo;
  while (albedo.drawn < surfaces.length) {
    const i = albedo.drawn++;
    const { textures, uniforms } = surfaces[i]!;
    gpu.draw({
      program: gpu.pass("shadow/caster-albedo", casterAlbedoFrag),
      target,
      viewport: [
        (i % COLUMNS) * TILE.width,
        Math.floor(i / COLUMNS) * TILE.height,
        TILE.width,
        TILE.height,
      ],
      textures,
      uniforms: { ...uniforms, uTile: i },
    });
    yield;
  }
  return target.color;
}
