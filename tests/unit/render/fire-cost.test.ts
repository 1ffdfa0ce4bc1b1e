import { expect, test } from "vitest";
import { TAPER } from "../../../src/light/flame-light.ts";
import { createShape, shapeFlame } from "../../../src/light/flame-shape.ts";
import { STEPS } from "../../../src/render/physical/flame-pass.ts";
import { STILL } from "../../../src/world/intent.ts";
import { COLUMN_FLOATS } from "../../../src/world/plume/plume.ts";
import { LINES, ROWS, SMOKE_FLOATS } from "../../../src/world/plume/smoke.ts";
import { advance, createWorld, type World } from "../../../src/world/world.ts";
import { codeOf } from "../sources.ts";

/** The picture, and how many of its pixels a metre takes at a metre's distance. */
const PICTURE = { width: 1280, height: 720 };
/** Most that flame, haze and smoke may take of a frame at medium on an integrated GPU, ms. */
const MOST = 1.5;
/**
 * An integrated GPU of 2017, Intel's UHD 620 at 1 GHz, at half of what its makers promise: texels of half floats, pixels
 * blended and operations, per millisecond.
 */
const GPU = { texels: 3e6, pixels: 1.5e6, operations: 190e6 };
/** Operations of one step through the flame, one pixel of haze or smoke, and one vertex of smoke: generously. */
const OPERATIONS = { step: 150, pixel: 60, vertex: 1500 };
/** Corners of the volume of probes around a vertex of smoke. */
const CORNERS = 8;
/** How far ribbons reach to each side, in breadths, and how narrow smoke gets: `haze.vert`, `smoke.vert`. */
const HAZE_REACH = 3;
const SMOKE_REACH = 2.4;
const NARROWEST = 0.55;

/** Looks into textures that a shader's code has. */
const taps = (file: string): number =>
  codeOf(`shaders/physical/${file}`).match(/\btex(ture|elFetch|tureLod)\(/g)?.length ?? 0;

function count(world: World): { readonly [what: string]: number } {
  const { eye, flame: foot } = world.shown;
  const away = Math.hypot(...eye.map((x, axis) => x - foot[axis]!));
  const { fieldOfView } = world.stage;
  const scale = PICTURE.height / (2 * Math.tan(fieldOfView / 2)) / away;
  const { fumes } = world;
  if (!fumes) throw new Error("A physical flame has hot air over it.");

  const shape = shapeFlame(world.flame, TAPER, createShape());
  let flame = 0;
  for (let ball = 3; ball < shape.balls.length; ball += 4) {
    flame += Math.PI * (shape.balls[ball]! * scale) ** 2;
  }

  const { y } = fumes.plume.grid;
  const column = new Float32Array(y.count * COLUMN_FLOATS);
  fumes.plume.column(column);
  let haze = 0;
  for (let level = 0; level < y.count; level++) {
    const breadth = column[level * COLUMN_FLOATS + 3]!;
    haze += 2 * HAZE_REACH * breadth * y.widths[level]! * scale * scale;
  }

  const { parcels, newest, count: rows } = fumes.smoke;
  let smoke = 0;
  for (let age = 1; age < rows; age++) {
    for (let line = 0; line < LINES; line++) {
      const [here, next] = [age, age - 1].map(
        (n) => (((newest - n + ROWS) % ROWS) * LINES + line) * SMOKE_FLOATS,
      ) as [number, number];
      const [dx, dy, dz] = [0, 1, 2].map((axis) => parcels[here + axis]! - parcels[next + axis]!);
      const breadth = Math.max(parcels[here + 4]! * scale, NARROWEST);
      smoke += Math.hypot(dx!, dy!, dz!) * scale * 2 * SMOKE_REACH * breadth;
    }
  }
  return { flame, haze, smoke, vertices: 2 * rows * LINES };
}

test("flame, haze and smoke take at most 1.5 ms of an integrated GPU at medium", () => {
  const world = createWorld("physical", 1);
  const burning = count(world);
  world.flame.extinguish();
  advance(world, STILL, 3);
  const smoking = count(world);
  expect(burning.flame).toBeGreaterThan(200);
  expect(burning.haze).toBeGreaterThan(10_000);
  expect(smoking.vertices).toBeGreaterThan(2000);
  // A flame that has just been put out has all three.
  const most = (what: string) => Math.max(burning[what] ?? 0, smoking[what] ?? 0);
  const [flame, haze, smoke, vertices] = ["flame", "haze", "smoke", "vertices"].map(most) as [
    number,
    number,
    number,
    number,
  ];
  const steps = flame * STEPS.medium;
  const texels =
    steps * taps("flame.frag") +
    haze * (taps("haze.frag") + taps("copy.frag")) +
    smoke * (taps("smoke.frag") + taps("depth.glsl")) +
    vertices * (taps("smoke.vert") + CORNERS * taps("volume.glsl"));
  const pixels = flame + 2 * haze + smoke;
  const operations =
    steps * OPERATIONS.step + (2 * haze + smoke) * OPERATIONS.pixel + vertices * OPERATIONS.vertex;
  const cost = texels / GPU.texels + pixels / GPU.pixels + operations / GPU.operations;
  const million = (n: number) => `${(n / 1e6).toFixed(2)} million`;
  console.log(
    `${million(steps)} steps, ${million(texels)} texels, ${million(pixels)} pixels, ` +
      `${million(operations)} operations: ${cost.toFixed(2)} ms`,
  );
  expect(cost).toBeLessThan(MOST);
});
