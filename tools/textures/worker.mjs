import { workerData } from "node:worker_threads";
import sharp from "sharp";
import { writeTextures } from "./image-files.mjs";
import { materialNamed } from "./materials.mjs";
import { textureSet } from "./texture-set.mjs";

// One thread to a worker: the pool is the parallelism.
sharp.concurrency(1);

const { folder, name } = workerData;
await writeTextures(folder, name, textureSet(name), materialNamed(name).quality);
