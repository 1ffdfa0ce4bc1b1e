import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";
import { writeLossless } from "./textures/image-files.mjs";
import { writeManifest } from "./textures/manifest.mjs";
import { materialNamed, materials } from "./textures/materials.mjs";
import { textureSet } from "./textures/texture-set.mjs";

/**
 * Makes public/textures/ from its seeds and lists what public/ holds in manifest.json:
 *
 *     node tools/assets.mjs               every set
 *     node tools/assets.mjs logs plaster  just these
 *     node tools/assets.mjs --manifest    none; only the list
 *     node tools/assets.mjs --fixture     the small set that a test makes again and compares
 */

const WORKERS = 2;
const publicFolder = fileURLToPath(new URL("../public/", import.meta.url));
const folder = `${publicFolder}textures`;

function chosen(names) {
  if (names.includes("--manifest") || names.includes("--fixture")) return [];
  if (names.length === 0) return materials.map((material) => material.name);
  return names.map((name) => materialNamed(name).name);
}

function make(names) {
  const waiting = [...names];
  const workers = Array.from({ length: Math.min(WORKERS, waiting.length) }, () => {
    const worker = new Worker(new URL("./textures/worker.mjs", import.meta.url), {
      workerData: { folder },
    });
    return new Promise((resolve, reject) => {
      const next = () => {
        const name = waiting.shift();
        if (name) worker.postMessage(name);
        else worker.terminate().then(resolve);
      };
      worker.on("error", reject);
      worker.on("message", (name) => {
        console.log(name);
        next();
      });
      next();
    });
  });
  return Promise.all(workers);
}

const FIXTURE = { name: "plaster", resolution: 256 };

async function writeFixture() {
  const fixtures = fileURLToPath(new URL("../tests/fixtures/", import.meta.url));
  mkdirSync(fixtures, { recursive: true });
  const { name, resolution } = FIXTURE;
  await writeLossless(fixtures, `${name}-${resolution}`, textureSet(name, resolution));
}

mkdirSync(folder, { recursive: true });
await make(chosen(process.argv.slice(2)));
if (process.argv.includes("--fixture")) await writeFixture();
writeManifest(publicFolder, materials);
