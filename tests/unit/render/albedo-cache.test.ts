import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import { AlbedoCache } from "../../../src/render/gbuffer/albedo-cache.ts";
import type { Mesh } from "../../../src/render/mesh/mesh.ts";

const [uAlbedo, uOcclusionRoughness] = [
  { width: 4, height: 4 },
  { width: 4, height: 4 },
];

function mesh(uOcclusionStrength: number, metallic = 0): Mesh {
  return {
    textures: { uAlbedo, uOcclusionRoughness },
    uniforms: { uOcclusionStrength, uSurface: [1, metallic, 1, 0] },
  } as unknown as Mesh;
}

test("materials share an albedo only if all that is baked into it is the same", () => {
  let made = 0;
  const gpu = {
    texture: () => ({ number: ++made, updateMipmaps: () => {} }),
    textureView: () => ({ dispose: () => {} }),
    pass: () => null,
    draw: () => {},
  } as unknown as Gpu;
  const albedos = new AlbedoCache(gpu);
  const meshes = [mesh(1), mesh(0.3), mesh(1), mesh(1, 1), mesh(0.3, 1)];
  while (!albedos.isComplete) albedos.updateIncrementally(meshes);
  expect(meshes.map((one) => albedos.of(one))).toMatchObject(
    [1, 2, 1, 3, 3].map((number) => ({ number })),
  );
});
