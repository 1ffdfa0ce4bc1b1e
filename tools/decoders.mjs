import { mkdirSync, readFileSync, writeFileSync } from "node:fs";

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

/** Line before a decoder's own: the page hears of an exception, but not of a rejection that nobody handles. */
const REPORT =
  'addEventListener("unhandledrejection",({reason})=>setTimeout(()=>{throw reason}));' +
  " // added by candle-flame\n";

mkdirSync(TARGET, { recursive: true });
for (const file of FILES) {
  const name = file.split("/").at(-1);
  const bytes = readFileSync(new URL(file, SOURCE));
  writeFileSync(new URL(name, TARGET), name.endsWith(".js") ? REPORT + bytes : bytes);
  console.log(name);
}
