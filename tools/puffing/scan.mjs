// Measures how flames puff over sources of several widths, for tests/fixtures/puffing.json.
import { writeFileSync } from "node:fs";
import { isMainThread, parentPort, Worker } from "node:worker_threads";
import { measure } from "./measure.mjs";

const OUT = "tests/fixtures/puffing.json";
const EARTH = 9.81;
// A wide pool burns less for each area of it.
const TRIALS = [
  { diameter: 0.01, fuelSpeed: 0.018, gravity: EARTH, settling: 0.3, seconds: 0.5 },
  { diameter: 0.02, fuelSpeed: 0.018, gravity: EARTH, settling: 0.6, seconds: 1 },
  { diameter: 0.02, fuelSpeed: 0.018, gravity: 4 * EARTH, settling: 0.4, seconds: 0.6 },
  { diameter: 0.03, fuelSpeed: 0.018, gravity: EARTH, settling: 0.7, seconds: 1 },
  { diameter: 0.05, fuelSpeed: 0.009, gravity: EARTH, settling: 0.8, seconds: 1.2 },
];

if (isMainThread) {
  const results = new Array(TRIALS.length);
  let next = 0;
  const work = () =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL(import.meta.url));
      let index = 0;
      const give = () => {
        index = next++;
        if (index < TRIALS.length) worker.postMessage(TRIALS[index]);
        else worker.terminate().then(resolve);
      };
      worker.on("message", (result) => {
        results[index] = { ...TRIALS[index], ...result };
        console.log(JSON.stringify(results[index]));
        give();
      });
      worker.on("error", reject);
      give();
    });
  await Promise.all(Array.from({ length: TRIALS.length }, work));
  writeFileSync(OUT, `${JSON.stringify({ cellsPerDiameter: 16, trials: results }, null, 2)}\n`);
} else {
  parentPort.on("message", (trial) => parentPort.postMessage(measure(trial)));
}
