import { expect, test } from "vitest";
import type { Gpu } from "../../../src/gl/gpu.ts";
import { measureSpeed, SOFTWARE_PIXEL, secondsPerPixel } from "../../../src/render/speed.ts";
import { chance } from "../chance.ts";

/** What a load takes: its pixels, and other tasks. Seconds. */
function machine(pixel: number, others: (load: number) => number) {
  const loads: number[] = [];
  const draw = async (pixels: number) => {
    loads.push(pixels);
    return pixel * pixels + others(loads.length);
  };
  return { loads, draw };
}

const quiet = () => 0.001;
const wait = async () => 0.2;

test.each([
  ["a desktop's GPU", 5e-11],
  ["a slow GPU", 1e-8],
  ["a processor", 2e-6],
  ["a processor a hundred times slower", 2e-4],
])("%s is measured within a third on an idle page, in half a second", async (_, pixel) => {
  const { draw, loads } = machine(pixel, quiet);
  const measured = await secondsPerPixel(draw, wait);
  expect(measured / pixel).toBeGreaterThan(0.9);
  expect(measured / pixel).toBeLessThan(1.33);
  const total = loads.reduce((sum, pixels) => sum + pixel * pixels + quiet(), 0);
  expect(total).toBeLessThan(0.5);
});

test("a page that loads makes no GPU a slow one", async () => {
  for (let visit = 0; visit < 200; visit++) {
    const random = chance(visit);
    // Tasks of up to 12 ms, from some load on or for all of them.
    const from = Math.floor(random(0, 20));
    const others = (load: number) => 0.001 + (load > from ? random(0, 0.012) : 0);
    const measured = await secondsPerPixel(machine(3e-10, others).draw, wait);
    expect(measured).toBeLessThan(1e-9);
  }
});

test("a busy processor is still one, and is measured in two seconds", async () => {
  for (let visit = 0; visit < 200; visit++) {
    const random = chance(visit);
    const { draw, loads } = machine(2e-6, () => random(0, 0.03));
    expect(await secondsPerPixel(draw, wait)).toBeGreaterThan(SOFTWARE_PIXEL);
    expect(loads.reduce((sum, pixels) => sum + 2e-6 * pixels, 0)).toBeLessThan(2);
  }
});

test("a lost context ends it", async () => {
  expect(await secondsPerPixel(async () => Number.NaN, wait)).toBeNaN();
});

test("a clock that stands still ends it before loads that take long without a GPU", async () => {
  const { draw, loads } = machine(0, () => 0);
  expect(await secondsPerPixel(draw, async () => 0)).toBeNaN();
  expect(loads.reduce((sum, pixels) => sum + pixels, 0)).toBeLessThan(1.2e6);
});

test.each([0.001, 1 / 60, 0.1])(
  "a GPU that is faster than a clock of %f s is no slow one",
  async (step) => {
    for (let visit = 0; visit < 50; visit++) {
      let now = chance(visit)(0, step);
      const draw = async (pixels: number) => {
        const begin = now;
        now += 0.0003 + 5e-11 * pixels;
        return (Math.floor(now / step) - Math.floor(begin / step)) * step;
      };
      expect(await secondsPerPixel(draw, wait)).toBeLessThan(5e-9);
    }
  },
);

test("a machine is measured again where the load was cleared meanwhile, and else once", async () => {
  let times = 0;
  const cleared = { isGone: true, pixel: async () => Number.NaN };
  const whole = { isGone: false, pixel: async () => 2e-7 };
  const gpu = { isLost: false, share: () => (times++ === 0 ? cleared : whole) } as unknown as Gpu;
  const measure = () => measureSpeed(gpu, () => 0);
  expect(await Promise.all([measure(), measure()])).toEqual([2e-7, 2e-7]);
  expect(await measure()).toBe(2e-7);
  expect(times).toBe(2);
});
