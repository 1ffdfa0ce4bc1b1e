import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { gzipSync } from "node:zlib";
import { Format, GLB_BUFFER, NodeIO, VertexLayout } from "@gltf-transform/core";
import validator from "gltf-validator";
import { packGlb } from "./glb-builder.mjs";

// Node does not load the WebAssembly of the package's module entry; its CommonJS entry does it by hand.
export const { generateTangents } = createRequire(import.meta.url)("mikktspace");

export const io = new NodeIO().setVertexLayout(VertexLayout.SEPARATE);

/**
 * Writes a document as a binary glTF whose textures stay outside the file, shared between models.
 *
 * @param {URL} url
 * @param {(material: string) => string | undefined} texturesOf a material's set in public/textures/
 * @param {(glb: {json: object, binary: Buffer}) => {json: object, binary: Buffer}} [refine] the last step
 * @returns what it has of triangles, draws and bytes when gzipped
 */
export async function writeGlb(url, document, texturesOf, refine = (glb) => glb) {
  const { json, resources } = await io.writeJSON(document, { format: Format.GLB });
  referToTextures(json, texturesOf);
  const refined = refine({ json, binary: resources[GLB_BUFFER] });
  const bytes = packGlb(refined.json, refined.binary);
  const file = url.pathname.split("/").at(-1);
  await assertValid(file, bytes);
  writeFileSync(url, bytes);
  return report(file, document, bytes);
}

/** Each texture is AVIF alone (Khronos, "EXT_texture_avif"), which the document model cannot say. */
function referToTextures(json, texturesOf) {
  const textures = new Map();
  json.extensionsUsed = [...(json.extensionsUsed ?? []), "EXT_texture_avif"];
  json.extensionsRequired = [...(json.extensionsRequired ?? []), "EXT_texture_avif"];
  json.samplers = [{ magFilter: 9729, minFilter: 9987, wrapS: 10497, wrapT: 10497 }];
  json.images = [];
  json.textures = [];

  const texture = (name) => {
    if (!textures.has(name)) {
      const image = { name, mimeType: "image/avif", uri: `../textures/${name}.avif` };
      const extensions = { EXT_texture_avif: { source: json.images.push(image) - 1 } };
      textures.set(name, json.textures.push({ name, sampler: 0, extensions }) - 1);
    }
    return { index: textures.get(name) };
  };

  for (const material of json.materials) {
    const set = texturesOf(material.name);
    if (!set) continue;
    material.pbrMetallicRoughness ??= {};
    material.pbrMetallicRoughness.baseColorTexture = texture(`${set}-albedo`);
    material.pbrMetallicRoughness.metallicRoughnessTexture = texture(`${set}-orm`);
    material.occlusionTexture = texture(`${set}-orm`);
    material.normalTexture = texture(`${set}-normal`);
  }
}

async function assertValid(file, bytes) {
  // The textures are another script's work, and need not be there yet. The validator has not heard of
  // AVIF, and says so in a warning for each picture.
  const { issues } = await validator.validateBytes(new Uint8Array(bytes), {
    ignoredIssues: ["IO_ERROR"],
    maxIssues: 0,
  });
  const errors = issues.messages.filter((message) => message.severity === 0);
  if (errors.length > 0) {
    const lines = errors.slice(0, 20).map((error) => `${error.pointer}: ${error.message}`);
    throw new Error(`${file}: ${errors.length} errors\n${lines.join("\n")}`);
  }
  const warnings = issues.messages.filter(({ severity }) => severity === 1);
  for (const message of warnings.filter(({ message }) => !message.includes("image/avif"))) {
    console.log(`${file}: ${message.pointer}: ${message.message}`);
  }
}

function report(file, document, bytes) {
  const totals = { triangles: 0, draws: 0, vertices: 0 };
  for (const node of document.getRoot().listNodes()) {
    const primitives = node.getMesh()?.listPrimitives() ?? [];
    const lines = primitives.map((primitive) => {
      const triangles = primitive.getIndices().getCount() / 3;
      totals.triangles += triangles;
      totals.draws += 1;
      totals.vertices += primitive.getAttribute("POSITION").getCount();
      return `${primitive.getMaterial().getName()} ${triangles}`;
    });
    console.log(`  ${node.getName()}: ${lines.join(", ") || node.getTranslation().join(" ")}`);
  }
  const gzipped = gzipSync(bytes, { level: 9 }).length;
  const { triangles, draws, vertices } = totals;
  console.log(
    `${file}: ${triangles} triangles, ${vertices} vertices, ${draws} draws, ${bytes.length} bytes, ${gzipped} gzipped`,
  );
  return { triangles, draws, bytes: gzipped };
}
