import reliefFrag from "../../../shaders/mesh/normal-map-visibility.frag";
import fullscreenVert from "../../../shaders/post/fullscreen.vert";
import type { Gpu } from "../../gl/gpu.js";
import type { Texture } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Surface } from "./mesh.js";

/** Levels of a normal map; coarser ones are as the last. */
const LEVELS = 8;

/**
 * What a surface's relief hides of light where it is seen too coarsely to show, made once: see
 * `mesh/normal-map-visibility.frag`. A normal map's smaller pictures are flatter than what they stand for, and so too bright.
 */
export function normalMapVisibilityOf(gpu: Gpu, screen: VertexArray, surface: Surface): Texture {
  return gpu.share(surface, () => {
    const { uNormal } = surface.textures;
    const [, , uNormalScale] = surface.parameters;
    const target = gpu.renderTarget({
      label: "relief",
      width: LEVELS,
      height: 1,
      color: ["RGBA16F"],
    });
    gpu.draw({
      program: gpu.program("mesh/normal-map-visibility", fullscreenVert, reliefFrag),
      target,
      vertexArray: screen,
      textures: { uNormal },
      uniforms: { uNormalScale },
    });
    return target.color;
  });
}
