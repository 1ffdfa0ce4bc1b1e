import { expect, test } from "vitest";
import { Air, CALM, type Wind } from "../../../src/world/air/air.js";
import { Flame } from "../../../src/world/flame/flame.js";
import { TICK } from "../../../src/world/timeline.js";

const RATE = 1 / TICK;
const STANDING = [0, 0, 0] as const;

/** Light of a flame that stands in this air, over half a minute: as the room sees it, and unlimited. */
function lights(wick: number, wind: Wind, seed = 7) {
  const air = new Air(seed, wind);
  const flame = new Flame(wick, true);
  const [shown, unlimited]: [number[], number[]] = [[], []];
  for (let i = 0; i < 32 * RATE; i++) {
    air.advance(i + 1, [0, 1.6, 2], [0, 0, 0], [0, 1, 0], [0, 0, 0]);
    flame.advance([0, 1, 0], [...STANDING], air, false, TICK);
    if (i < 2 * RATE) continue;
    shown.push(flame.glow);
    unlimited.push(flame.measure().light);
  }
  return { shown, unlimited };
}

/** Mean, and rms and skewness of what differs from it, as shares. */
function moments(values: readonly number[]) {
  const average = (power: number, middle: number) =>
    values.reduce((sum, value) => sum + (value - middle) ** power, 0) / values.length;
  const mean = average(1, 0);
  const deviation = Math.sqrt(average(2, mean));
  return { rms: deviation / mean, skewness: average(3, mean) / deviation ** 3 };
}

/** Power at a frequency (Hz), averaged over windows of two seconds after Hann. */
function power(values: readonly number[], frequency: number): number {
  const length = 2 * RATE;
  let sum = 0;
  for (let begin = 0; begin + length <= values.length; begin += length / 2) {
    const window = values.slice(begin, begin + length);
    const mean = window.reduce((total, value) => total + value, 0) / length;
    let [real, imaginary] = [0, 0];
    for (const [n, value] of window.entries()) {
      const weight = (0.5 - 0.5 * Math.cos((2 * Math.PI * n) / length)) * (value - mean);
      real += weight * Math.cos((2 * Math.PI * frequency * n) / RATE);
      imaginary += weight * Math.sin((2 * Math.PI * frequency * n) / RATE);
    }
    sum += real * real + imaginary * imaginary;
  }
  return sum;
}

/** Exponent of the power spectrum from 1 to 10 Hz. */
function slope(values: readonly number[]): number {
  const points = Array.from({ length: 19 }, (_, i) => 1 + i / 2).map(
    (frequency) => [Math.log(frequency), Math.log(power(values, frequency))] as const,
  );
  const meanX = points.reduce((sum, [x]) => sum + x, 0) / points.length;
  const meanY = points.reduce((sum, [, y]) => sum + y, 0) / points.length;
  const both = points.reduce((sum, [x, y]) => sum + (x - meanX) * (y - meanY), 0);
  return both / points.reduce((sum, [x]) => sum + (x - meanX) ** 2, 0);
}

test("in still air a candle's flame stands still, without any tone", () => {
  for (const wick of [0.002, 0.01]) {
    const { shown, unlimited } = lights(wick, CALM);
    expect(moments(shown).rms, `${wick} m`).toBeLessThan(1e-6);
    expect(moments(unlimited).rms, `${wick} m`).toBeLessThan(1e-6);
  }
});

test("in gusts of 0.1 to 0.4 m/s it flickers as photodiodes see it, with a tail towards bright", () => {
  const seen = [1, 2, 3, 7].map((seed) => {
    const { shown, unlimited } = lights(0.002, { speed: 0.25, direction: 0, gustiness: 1 }, seed);
    const { rms, skewness } = moments(unlimited);
    return { rms, skewness, exponent: slope(unlimited), left: moments(shown), soft: slope(shown) };
  });
  for (const { rms, exponent, left, soft } of seen) {
    expect(rms).toBeGreaterThan(0.05);
    expect(rms).toBeLessThan(0.25);
    expect(exponent).toBeGreaterThan(-2.5);
    expect(exponent).toBeLessThan(-1);
    // What keeps it from flashing takes some of its fast unrest; what is left is like nature's all the same.
    expect(left.rms).toBeGreaterThan(0.05);
    expect(left.rms).toBeLessThan(rms);
    expect(soft).toBeGreaterThan(-2.8);
    expect(soft).toBeLessThan(-1);
  }
  // Half a minute is short for a third moment, and for a spectrum at its limit, so rooms are averaged.
  const average = (of: (light: (typeof seen)[number]) => number) =>
    seen.reduce((sum, light) => sum + of(light) / seen.length, 0);
  console.log(
    `shown: rms ${average(({ left }) => left.rms)}, slope ${average(({ soft }) => soft)}, ` +
      `skewness ${average(({ left }) => left.skewness)}`,
  );
  expect(average(({ soft }) => soft)).toBeGreaterThan(-2.5);
  expect(average(({ skewness }) => skewness)).toBeGreaterThan(0);
  expect(average(({ left }) => left.skewness)).toBeGreaterThan(0);
});
