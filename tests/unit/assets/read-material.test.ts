import { expect, test } from "vitest";
import type { GltfDocument } from "../../../src/assets/gltf-document.ts";
import { JsonEntry } from "../../../src/assets/json-entry.ts";
import { readMaterial } from "../../../src/assets/read-material.ts";
import type { TextureImages } from "../../../src/assets/texture-images.ts";

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
  const entry = new JsonEntry(
    { extensions, ...(pbrMetallicRoughness && { pbrMetallicRoughness }) },
    "",
  );
  const document = { textures: [], samplers: [] } as unknown as GltfDocument;
  const { material } = await readMaterial(document, entry, {} as TextureImages, new Set());
  expect(material).toMatchObject({ roughness, metallic: 0, isGlossy: false });
});
