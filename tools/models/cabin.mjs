import { readFileSync } from "node:fs";
import { Logger, PropertyType } from "@gltf-transform/core";
import { dedup, prune, reorder, tangents, unweld, weld } from "@gltf-transform/functions";
import { MeshoptEncoder } from "meshoptimizer";
import { materials } from "./cabin-materials.mjs";
import { withLowerLevels } from "./reduce.mjs";
import { generateTangents, io, writeGlb } from "./write-glb.mjs";

/**
 * Finishes what Blender exported, from work/models/ to public/models/: tangents, materials that refer
 * to the shared textures, numbers rounded to what the eye can tell, the order of triangles that packs and
 * caches best, and the lower level of detail. Run after cabin.py and chamberstick.py.
 */

const MODELS = [
  // Steps in metres that positions are rounded to.
  { file: "cabin.glb", step: 2 ** -14 },
  { file: "chamberstick.glb", step: 2 ** -17 },
];
const NORMAL_STEP = 2 ** -9;
const TANGENT_STEP = 2 ** -8;
const TEXCOORD_STEP = 2 ** -12;

const LIMITS = { triangles: 64_000, draws: 40, bytes: 1_250_000 };

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
  return writeGlb(
    new URL(`../../public/models/${file}`, import.meta.url),
    document,
    (name) => materials[name].textures,
    (glb) => withLowerLevels(file, glb),
  );
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

const reports = [];
for (const model of MODELS) reports.push(await finish(model));
const sum = (key) => reports.reduce((total, report) => total + report[key], 0);
if (sum("triangles") > LIMITS.triangles) throw new Error(`${sum("triangles")} triangles`);
if (reports[0].draws > LIMITS.draws) throw new Error(`${reports[0].draws} draws`);
if (sum("bytes") > LIMITS.bytes) throw new Error(`${sum("bytes")} bytes gzipped`);
