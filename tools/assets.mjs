import { once } from "node:events";
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

async function make(names) {
  const waiting = [...names];
  const work = async () => {
    for (let name = waiting.shift(); name; name = waiting.shift()) {
      const workerData = { folder, name };
      await once(
        new Worker(new URL("./textures/worker.mjs", import.meta.url), { workerData }),
        "exit",
      );
      console.log(name);
    }
  };
  await Promise.all(Array.from({ length: WORKERS }, work));
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
