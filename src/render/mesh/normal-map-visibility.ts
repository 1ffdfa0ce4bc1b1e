import visibilityFrag from "../../../shaders/mesh/normal-map-visibility.frag";
import type { Gpu, Program, Texture } from "../../gl/gpu.js";
import type { Mesh } from "./mesh.js";

/** Levels of detail of a normal map; coarser ones are as the last. */
const LEVELS = 8;

export function normalMapVisibilityProgram(gpu: Gpu): Program {
  return gpu.pass("mesh/normal-map-visibility", visibilityFrag);
}

/**
 * Normal-map visibility: what a normal map's relief leaves of light, by level of detail. Minified normal maps are
 * flatter than the relief that they stand for, and so too bright. Made once for each mesh.
 */
export function normalMapVisibilityOf(gpu: Gpu, mesh: Mesh): Texture {
  return gpu.share(mesh, () => {
    const { uNormal } = mesh.textures;
    const [, , uNormalScale] = mesh.uniforms.uSurface;
    const target = gpu.renderTarget({
      label: "normal-map visibility",
      width: LEVELS,
      height: 1,
      color: ["RGBA16F"],
    });
    gpu.draw({
      program: normalMapVisibilityProgram(gpu),
      target,
      textures: { uNormal },
      uniforms: { uNormalScale },
    });
    return target.color;
  });
}
