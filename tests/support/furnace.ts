import { Gpu } from "../../src/gl/gpu.ts";
import type { ShaderSource } from "../../src/gl/program.ts";
import {
  ENVIRONMENT_BRDF_SIZE,
  tabulateEnvironmentBrdf,
} from "../../src/render/opaque/environment-brdf.ts";

/** What `furnace.frag` finds, three numbers for each of `size` x `size` surfaces. Runs in the browser. */
export function furnace(vertex: ShaderSource, fragment: ShaderSource, size: number): number[] {
  const gpu = new Gpu(document.createElement("canvas"));
  const target = gpu.renderTarget({
    label: "furnace",
    width: size,
    height: size,
    color: ["RGBA16F"],
  });
  const uEnvironmentBrdf = gpu.texture({
    label: "reflectance",
    format: "RG16F",
    source: {
      width: ENVIRONMENT_BRDF_SIZE,
      height: ENVIRONMENT_BRDF_SIZE,
      data: tabulateEnvironmentBrdf(),
    },
  });
  gpu.draw({
    program: gpu.program("furnace", vertex, fragment),
    target,
    textures: { uEnvironmentBrdf },
  });
  const found = Array.from(gpu.readFloats(target, [0, 0, size, size]));
  gpu.dispose();
  return found;
}
