// node tools/reference/chance.mjs [count] [seed]: views that nobody chose, in the form of views.json.
import { height, readSource, views, width } from "./room.mjs";

const [count = 16, seed = 1] = process.argv.slice(2).map(Number);
const { pcg, unit } = await readSource("/src/world/random.ts");

/** Where the eye may be and look, metres and radians; what stands in the way pushes it aside. */
const RANGES = {
  x: [-1.7, 1.7],
  y: [1.3, 1.6],
  z: [-1.2, 1.7],
  yaw: [-Math.PI, Math.PI],
  pitch: [-0.45, 0.15],
};
/** Of four views one has the candle on the table, one on the floor, and two in the hand. */
const places = ["table", "floor"].map((wanted) => views.find(({ name }) => name === wanted)?.place);

const chosen = Array.from({ length: count }, (_, number) => {
  const [x, y, z, yaw, pitch] = Object.values(RANGES).map(([low, high], axis) => {
    const chance = unit(pcg(pcg(seed) + number * 8 + axis));
    return Number((low + (high - low) * chance).toFixed(2));
  });
  const place = places[number % 4];
  const camera = { position: [x, y, z], yaw, pitch };
  return { name: `chance-${number}`, ...(place && { place }), camera };
});
process.stdout.write(`${JSON.stringify({ width, height, views: chosen }, null, 2)}\n`);
