import { expect, test } from "vitest";
import type { GltfDocument } from "../../../src/assets/gltf-document.ts";
import { JsonEntry } from "../../../src/assets/json-entry.ts";
import { readMaterial } from "../../../src/assets/read-material.ts";
import type { TextureImages } from "../../../src/assets/texture-images.ts";

/** A material of a file of two textures, neither of which has a picture that can be read. */
async function materialOf(entry: object) {
  const textures = [new JsonEntry({}, ""), new JsonEntry({}, "")];
  const document = { textures, samplers: [] } as unknown as GltfDocument;
  const images = { texture: async () => null } as unknown as TextureImages;
  return (await readMaterial(document, new JsonEntry(entry, ""), images, new Set())).material;
}

test.each([
  ["a factor", { glossinessFactor: 0.25 }, undefined, 0.75],
  ["a map", { specularGlossinessTexture: { index: 0 } }, undefined, 1],
  [
    "a map, and a fallback",
    { specularGlossinessTexture: { index: 0 } },
    { roughnessFactor: 0.4 },
    0.4,
  ],
])("glossiness as %s makes no mirror", async (_, glossy, pbrMetallicRoughness, roughness) => {
  const extensions = { KHR_materials_pbrSpecularGlossiness: glossy };
  const entry = { extensions, ...(pbrMetallicRoughness && { pbrMetallicRoughness }) };
  expect(await materialOf(entry)).toMatchObject({ roughness, metallic: 0, isGlossy: false });
});

test("an unlit surface is rough and no metal", async () => {
  const material = await materialOf({ extensions: { KHR_materials_unlit: {} } });
  expect(material).toMatchObject({ roughness: 1, metallic: 0, isGlossy: false });
});

test("a surface whose map is left out is no metal", async () => {
  const pbrMetallicRoughness = {
    baseColorTexture: { index: 0 },
    metallicRoughnessTexture: { index: 1, texCoord: 1 },
  };
  expect(await materialOf({ pbrMetallicRoughness })).toMatchObject({ metallic: 0 });
});

test("a mask whose cutoff is above 1 keeps it", async () => {
  const material = await materialOf({ alphaMode: "MASK", alphaCutoff: 1.5 });
  expect(material.alphaCutoff).toBe(1.5);
});
