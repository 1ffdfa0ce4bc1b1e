import { writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Document, Format, GLB_BUFFER, Logger, NodeIO } from "@gltf-transform/core";
import { tangents, weld } from "@gltf-transform/functions";
import validator from "gltf-validator";
import { assertSoundSurface } from "./sound-surface.mjs";

// Node does not load the WebAssembly of the package's module entry; its CommonJS entry does it by hand.
const { generateTangents } = createRequire(import.meta.url)("mikktspace");

/**
 * Writes a binary glTF whose textures stay outside the file, shared between models.
 *
 * @param {URL} file
 * @param {object} model
 * @param {object[]} model.materials each `{ name, textures }`, a set in public/textures/, or
 *   `{ name, baseColor, roughness }`
 * @param {object[]} model.meshes each `{ name, material, triangles, centre, facing }`: unwelded
 *   triangles that face away from the centre (facing 1) or towards it (facing -1)
 * @param {object[]} [model.anchors] empty nodes, each `{ name, translation }`
 */
export async function writeModel(file, { materials, meshes, anchors = [] }) {
  const document = documentOf(materials, meshes, anchors);
  await document.transform(tangents({ generateTangents }), weld());
  for (const mesh of meshes) assertSoundSurface(mesh, arraysOf(document, mesh.name));

  const { json, resources } = await new NodeIO().writeJSON(document, { format: Format.GLB });
  referToTextures(json, materials);
  const bytes = packed(json, resources[GLB_BUFFER]);
  await assertValid(bytes);
  writeFileSync(file, bytes);
  report(file, document, bytes);
}

function documentOf(materials, meshes, anchors) {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.WARN));
  const buffer = document.createBuffer();
  const scene = document.createScene();
  document.getRoot().setDefaultScene(scene);

  const accessor = (type, values) =>
    document
      .createAccessor()
      .setType(type)
      .setArray(Float32Array.from(values, withoutNegativeZero))
      .setBuffer(buffer);

  const materialNamed = new Map();
  for (const { name, baseColor = 1, roughness = 1 } of materials) {
    const material = document
      .createMaterial(name)
      .setBaseColorFactor([baseColor, baseColor, baseColor, 1])
      .setRoughnessFactor(roughness)
      .setMetallicFactor(0);
    materialNamed.set(name, material);
  }

  for (const { name, material, triangles } of meshes) {
    const primitive = document
      .createPrimitive()
      .setMaterial(materialNamed.get(material))
      .setAttribute("POSITION", accessor("VEC3", triangles.positions))
      .setAttribute("NORMAL", accessor("VEC3", triangles.normals))
      .setAttribute("TEXCOORD_0", accessor("VEC2", triangles.texcoords));
    const mesh = document.createMesh(name).addPrimitive(primitive);
    scene.addChild(document.createNode(name).setMesh(mesh));
  }
  for (const { name, translation } of anchors) {
    scene.addChild(document.createNode(name).setTranslation(translation));
  }
  return document;
}

// Welding compares bits, and -0 and 0 are the same place.
const withoutNegativeZero = (value) => value + 0;

function primitiveNamed(document, name) {
  const meshes = document.getRoot().listMeshes();
  return meshes.find((mesh) => mesh.getName() === name).listPrimitives()[0];
}

function arraysOf(document, name) {
  const primitive = primitiveNamed(document, name);
  const attribute = (semantic) => primitive.getAttribute(semantic).getArray();
  return {
    positions: attribute("POSITION"),
    normals: attribute("NORMAL"),
    tangents: attribute("TANGENT"),
    texcoords: attribute("TEXCOORD_0"),
    indices: primitive.getIndices().getArray(),
  };
}

/** Each texture is AVIF alone (Khronos, "EXT_texture_avif"), which the document model cannot say. */
function referToTextures(json, materials) {
  const textured = materials.filter((material) => material.textures);
  if (textured.length === 0) return;

  json.extensionsUsed = ["EXT_texture_avif"];
  json.extensionsRequired = ["EXT_texture_avif"];
  json.samplers = [{ magFilter: 9729, minFilter: 9987, wrapS: 10497, wrapT: 10497 }];
  json.images = [];
  json.textures = [];

  const texture = (name) => {
    const image = { name, mimeType: "image/avif", uri: `../textures/${name}.avif` };
    const extensions = { EXT_texture_avif: { source: json.images.push(image) - 1 } };
    return json.textures.push({ name, sampler: 0, extensions }) - 1;
  };

  for (const { name, textures } of textured) {
    const material = json.materials.find((candidate) => candidate.name === name);
    const albedo = { index: texture(`${textures}-albedo`) };
    const normal = { index: texture(`${textures}-normal`) };
    const occlusionRoughnessMetallic = { index: texture(`${textures}-orm`) };
    material.pbrMetallicRoughness ??= {};
    material.pbrMetallicRoughness.baseColorTexture = albedo;
    material.pbrMetallicRoughness.metallicRoughnessTexture = occlusionRoughnessMetallic;
    material.normalTexture = normal;
    material.occlusionTexture = occlusionRoughnessMetallic;
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

async function assertValid(bytes) {
  // The textures are another script's work, and need not be there yet.
  const { issues } = await validator.validateBytes(new Uint8Array(bytes), {
    ignoredIssues: ["IO_ERROR"],
  });
  const errors = issues.messages.filter((message) => message.severity === 0);
  if (errors.length > 0) {
    throw new Error(errors.map((error) => `${error.pointer}: ${error.message}`).join("\n"));
  }
  console.log(`validator: 0 errors, ${issues.numWarnings} warnings, ${issues.numInfos} infos`);
}

function report(file, document, bytes) {
  let total = 0;
  for (const node of document.getRoot().listNodes()) {
    const triangles = node.getMesh()
      ? primitiveNamed(document, node.getName()).getIndices().getCount() / 3
      : 0;
    total += triangles;
    console.log(`  ${node.getName()}: ${triangles} triangles`);
  }
  console.log(`${file.pathname.split("/").at(-1)}: ${total} triangles, ${bytes.length} bytes`);
}
