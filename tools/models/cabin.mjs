import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { gzipSync } from "node:zlib";
import {
  Format,
  GLB_BUFFER,
  Logger,
  NodeIO,
  PropertyType,
  VertexLayout,
} from "@gltf-transform/core";
import { dedup, prune, reorder, tangents, unweld, weld } from "@gltf-transform/functions";
import validator from "gltf-validator";
import { MeshoptEncoder } from "meshoptimizer";
import { materials } from "./cabin-materials.mjs";

/**
 * Finishes what Blender exported, from work/models/ to public/models/: tangents, materials that refer
 * to the shared textures, numbers rounded to what the eye can tell, and the order of triangles that
 * packs and caches best. Run after cabin.py and chamberstick.py.
 */

// Node does not load the WebAssembly of the package's module entry; its CommonJS entry does it by hand.
const { generateTangents } = createRequire(import.meta.url)("mikktspace");

const MODELS = [
  // Steps in metres that positions are rounded to.
  { file: "cabin.glb", step: 2 ** -14 },
  { file: "chamberstick.glb", step: 2 ** -17 },
];
const NORMAL_STEP = 2 ** -9;
const TANGENT_STEP = 2 ** -8;
const TEXCOORD_STEP = 2 ** -12;

const LIMITS = { triangles: 60_000, draws: 40, bytes: 1_200_000 };

const io = new NodeIO().setVertexLayout(VertexLayout.SEPARATE);
await MeshoptEncoder.ready;

async function finish({ file, step }) {
  const raw = readFileSync(new URL(`../../work/models/${file}`, import.meta.url));
  const document = (await io.readBinary(new Uint8Array(raw))).setLogger(
    new Logger(Logger.Verbosity.WARN),
  );
  await document.transform(unweld(), tangents({ generateTangents, overwrite: true }));
  for (const primitive of primitivesOf(document)) {
    roundAttribute(primitive.getAttribute("POSITION"), step);
    roundAttribute(primitive.getAttribute("NORMAL"), NORMAL_STEP);
    roundAttribute(primitive.getAttribute("TANGENT"), TANGENT_STEP);
    roundAttribute(primitive.getAttribute("TEXCOORD_0"), TEXCOORD_STEP);
    packOcclusion(primitive.getAttribute("COLOR_0"));
  }
  await document.transform(
    weld(),
    dedup({ propertyTypes: [PropertyType.ACCESSOR] }),
    prune({ keepAttributes: true, keepLeaves: true }),
    reorder({ encoder: MeshoptEncoder, target: "size" }),
  );
  paint(document);
  const { json, resources } = await io.writeJSON(document, { format: Format.GLB });
  referToTextures(json);
  const bytes = packed(json, resources[GLB_BUFFER]);
  await assertValid(file, bytes);
  writeFileSync(new URL(`../../public/models/${file}`, import.meta.url), bytes);
  return report(file, document, bytes);
}

function primitivesOf(document) {
  return document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());
}

function roundAttribute(accessor, step) {
  // Adding zero turns -0 into 0: welding compares bits.
  const rounded = accessor.getArray().map((value) => Math.round(value / step) * step + 0);
  accessor.setArray(rounded);
}

/** Occlusion is a grey in the red, green and blue of COLOR_0, linear; a byte is enough for it. */
function packOcclusion(accessor) {
  const width = accessor.getElementSize();
  const bytes = new Uint8Array(accessor.getCount() * 4).fill(255);
  const pixel = [];
  for (let vertex = 0; vertex < accessor.getCount(); vertex++) {
    accessor.getElement(vertex, pixel);
    bytes.fill(Math.round(Math.min(1, pixel[0]) * 255), vertex * 4, vertex * 4 + 3);
  }
  if (width < 3) throw new Error("COLOR_0 is not a colour");
  accessor.setType("VEC4").setArray(bytes).setNormalized(true);
}

function paint(document) {
  for (const material of document.getRoot().listMaterials()) {
    const kind = materials[material.getName()];
    if (!kind) throw new Error(`No material "${material.getName()}" in cabin-materials.mjs`);
    material
      .setBaseColorFactor([...kind.baseColor, 1])
      .setRoughnessFactor(kind.roughness)
      .setMetallicFactor(kind.metallic)
      .setDoubleSided(false);
  }
}

/** Each texture is AVIF alone (Khronos, "EXT_texture_avif"), which the document model cannot say. */
function referToTextures(json) {
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
    const set = materials[material.name].textures;
    if (!set) continue;
    material.pbrMetallicRoughness ??= {};
    material.pbrMetallicRoughness.baseColorTexture = texture(`${set}-albedo`);
    material.pbrMetallicRoughness.metallicRoughnessTexture = texture(`${set}-orm`);
    material.occlusionTexture = texture(`${set}-orm`);
    material.normalTexture = texture(`${set}-normal`);
  }
}

/** The container of Khronos, "glTF 2.0 Specification", section 4.4, "Binary glTF Layout". */
function packed(json, binary) {
  const text = Buffer.from(JSON.stringify(json));
  const chunks = Buffer.concat([chunk("JSON", text, " "), chunk("BIN\0", binary, "\0")]);
  const header = Buffer.alloc(12);
  header.write("glTF", 0, "latin1");
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(header.length + chunks.length, 8);
  return Buffer.concat([header, chunks]);
}

function chunk(type, content, padding) {
  const length = Math.ceil(content.length / 4) * 4;
  const bytes = Buffer.alloc(8 + length, padding);
  bytes.writeUInt32LE(length, 0);
  bytes.write(type, 4, "latin1");
  bytes.set(content, 8);
  return bytes;
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

const reports = [];
for (const model of MODELS) reports.push(await finish(model));
const sum = (key) => reports.reduce((total, report) => total + report[key], 0);
if (sum("triangles") > LIMITS.triangles) throw new Error(`${sum("triangles")} triangles`);
if (reports[0].draws > LIMITS.draws) throw new Error(`${reports[0].draws} draws`);
if (sum("bytes") > LIMITS.bytes) throw new Error(`${sum("bytes")} bytes gzipped`);
