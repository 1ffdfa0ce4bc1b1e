import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
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
const GLB_HEADER = 12;
const CHUNK_HEADER = 8;

/** The JSON chunk of a binary glTF; the textures it names need not be there. */
function jsonOf(glb) {
  const length = glb.readUInt32LE(GLB_HEADER);
  const start = GLB_HEADER + CHUNK_HEADER;
  return JSON.parse(glb.toString("utf8", start, start + length));
}

function modelEntry(file) {
  const { asset, meshes = [], accessors } = jsonOf(readFileSync(file));
  let triangles = 0;
  for (const { mode = TRIANGLES, indices, attributes } of meshes.flatMap((m) => m.primitives)) {
    if (mode === TRIANGLES) triangles += accessors[indices ?? attributes.POSITION].count / 3;
  }
  const seed = asset.extras?.seed;
  return { ...(seed === undefined ? {} : { seed }), triangles, ...entry(file) };
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
