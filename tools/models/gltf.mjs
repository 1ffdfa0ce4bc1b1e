import { Document, Logger } from "@gltf-transform/core";
import { tangents, weld } from "@gltf-transform/functions";
import { assertSoundSurface } from "./sound-surface.mjs";
import { generateTangents, writeGlb } from "./write-glb.mjs";

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

  const setOf = new Map(materials.map(({ name, textures }) => [name, textures]));
  await writeGlb(file, document, (name) => setOf.get(name));
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
