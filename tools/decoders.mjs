import { copyFileSync, mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";

/**
 * Copies the decoders of compressed models from three's package to public/decoders/, whence the
 * element fetches them when a visitor's file needs them:
 *
 *     node tools/decoders.mjs
 */

const SOURCE = new URL("../node_modules/three/examples/jsm/libs/", import.meta.url);
const TARGET = new URL("../public/decoders/", import.meta.url);

const FILES = [
  "draco/gltf/draco_wasm_wrapper.js",
  "draco/gltf/draco_decoder.wasm",
  "basis/basis_transcoder.js",
  "basis/basis_transcoder.wasm",
];

mkdirSync(TARGET, { recursive: true });
for (const file of FILES) {
  const name = file.split("/").at(-1);
  copyFileSync(fileURLToPath(new URL(file, SOURCE)), fileURLToPath(new URL(name, TARGET)));
  console.log(name);
}
