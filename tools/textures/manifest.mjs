import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { openGlb } from "../models/glb-builder.mjs";
import { CHANNELS } from "./image-files.mjs";

function entry(file) {
  const bytes = readFileSync(file);
  return { bytes: bytes.length, sha256: createHash("sha256").update(bytes).digest("hex") };
}

function textureEntry(folder, material) {
  const files = {};
  for (const channel of CHANNELS) {
    const file = `${material.name}-${channel}.avif`;
    if (existsSync(join(folder, file))) files[file] = entry(join(folder, file));
  }
  return { size: material.size, tile: material.tile, seed: material.seed, files };
}

const TRIANGLES = 4;

function modelEntry(file) {
  const { asset, meshes, accessors } = openGlb(readFileSync(file)).json;
  const primitives = meshes.flatMap((mesh) => mesh.primitives);
  let [triangles, reduced] = [0, 0];
  for (const { mode = TRIANGLES, indices, attributes, extras } of primitives) {
    if (mode === TRIANGLES) triangles += accessors[indices ?? attributes.POSITION].count / 3;
    reduced += (accessors[extras?.reducedIndices]?.count ?? 0) / 3;
  }
  const seed = asset.extras?.seed;
  return {
    ...(seed === undefined ? {} : { seed }),
    triangles,
    ...(reduced > 0 ? { reducedTriangles: reduced } : {}),
    ...entry(file),
  };
}

/** Rewrites manifest.json: what every baked file weighs, its hash, and the seed it grew from. */
export function writeManifest(publicFolder, materials) {
  const textures = {};
  for (const material of materials) {
    textures[material.name] = textureEntry(join(publicFolder, "textures"), material);
  }
  const models = {};
  const modelFolder = join(publicFolder, "models");
  const names = existsSync(modelFolder) ? readdirSync(modelFolder).sort() : [];
  for (const name of names.filter((file) => file.endsWith(".glb"))) {
    models[name] = modelEntry(join(modelFolder, name));
  }
  writeFileSync(
    join(publicFolder, "manifest.json"),
    `${JSON.stringify({ textures, models }, null, 2)}\n`,
  );
}
