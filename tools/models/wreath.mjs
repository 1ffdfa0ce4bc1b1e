import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import {
  KHRMaterialsTransmission,
  KHRMaterialsVolume,
  KHRMeshQuantization,
} from "@gltf-transform/extensions";
import { dedup, prune, quantize, reorder, weld } from "@gltf-transform/functions";
import { MeshoptEncoder } from "meshoptimizer";
import { io } from "./write-glb.mjs";

/**
 * Finishes the wreath and the jar that wreath.py made, from work/models/ to public/models/: materials without
 * textures, by the extensions of glTF that any reader knows, and the wicks' diameters.
 */

/** Albedo in linear Rec. 709. */
const MATERIALS = {
  needles: { color: [0.04, 0.1, 0.036], roughness: 0.55, isDoubleSided: true },
  moss: { color: [0.012, 0.024, 0.009], roughness: 1 },
  bark: { color: [0.09, 0.055, 0.03], roughness: 0.9 },
  berry: { color: [0.42, 0.022, 0.018], roughness: 0.25 },
  brass: { color: [0.83, 0.6, 0.24], roughness: 0.28, metallic: 1 },
  label: { color: [0.36, 0.25, 0.15], roughness: 0.8 },
  print: { color: [0.06, 0.045, 0.035], roughness: 0.7 },
  wick: { color: [0.012, 0.011, 0.01], roughness: 0.9 },
  glass: { color: [1, 1, 1], roughness: 0.02, transmission: 1 },
};
/** Wax and its melted pool: albedo, and the color that light takes on over a distance within it. */
const WAX = {
  wreath: { color: [0.17, 0.01, 0.008], attenuation: [0.85, 0.1, 0.06], wickDiameter: 2.5 },
  jar: { color: [0.84, 0.78, 0.66], attenuation: [0.9, 0.75, 0.5], wickDiameter: 3 },
};
/** Metres. */
const ATTENUATION_DISTANCE = 0.012;

await MeshoptEncoder.ready;
io.registerExtensions([KHRMaterialsTransmission, KHRMaterialsVolume, KHRMeshQuantization]);

function paint(document, { color, attenuation }) {
  const transmission = document.createExtension(KHRMaterialsTransmission);
  const volume = document.createExtension(KHRMaterialsVolume);
  for (const material of document.getRoot().listMaterials()) {
    const name = material.getName();
    const isWax = name === "wax" || name === "pool";
    const kind = isWax
      ? { color, roughness: name === "wax" ? 0.45 : 0.04 }
      : (MATERIALS[name] ?? fail(name));
    material
      .setBaseColorFactor([...kind.color, 1])
      .setRoughnessFactor(kind.roughness)
      .setMetallicFactor(kind.metallic ?? 0)
      .setDoubleSided(kind.isDoubleSided ?? false);
    if (isWax) {
      const inside = volume
        .createVolume()
        .setThicknessFactor(0.02)
        .setAttenuationColor(attenuation)
        .setAttenuationDistance(ATTENUATION_DISTANCE);
      material.setExtension("KHR_materials_volume", inside);
    }
    if (kind.transmission) {
      const through = transmission.createTransmission().setTransmissionFactor(kind.transmission);
      material.setExtension("KHR_materials_transmission", through);
    }
  }
}

function fail(name) {
  throw new Error(`No material "${name}" in wreath.mjs`);
}

/** Materials without textures need no texture coordinates. */
function dropTexcoords(document) {
  for (const mesh of document.getRoot().listMeshes()) {
    for (const primitive of mesh.listPrimitives()) primitive.setAttribute("TEXCOORD_0", null);
  }
}

mkdirSync(new URL("../../public/models/", import.meta.url), { recursive: true });
for (const [name, wax] of Object.entries(WAX)) {
  const raw = readFileSync(new URL(`../../work/models/${name}.glb`, import.meta.url));
  const document = await io.readBinary(new Uint8Array(raw));
  dropTexcoords(document);
  paint(document, wax);
  for (const node of document.getRoot().listNodes()) {
    if (node.getName().startsWith("wick")) node.setExtras({ wickDiameter: wax.wickDiameter });
  }
  await document.transform(
    weld(),
    dedup(),
    prune({ keepLeaves: true }),
    quantize({ quantizationVolume: "scene" }),
    reorder({ encoder: MeshoptEncoder, target: "size" }),
  );
  const bytes = await io.writeBinary(document);
  writeFileSync(new URL(`../../public/models/${name}.glb`, import.meta.url), bytes);
  console.log(`${name}.glb: ${bytes.length} bytes`);
}
