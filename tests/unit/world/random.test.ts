import { describe, expect, test } from "vitest";
import { pcg, signed, unit } from "../../../src/world/random.ts";

const COUNT = 1 << 16;
const counted = Array.from({ length: COUNT }, (_, i) => pcg(i));
const chained = counted.slice();
for (let i = 1; i < COUNT; i++) chained[i] = pcg(chained[i - 1]!);

/** Pearson's chi-squared of numbers in [0, 1) against equal chances for 256 bins. */
function chiSquared(numbers: readonly number[]): number {
  const bins = new Array<number>(256).fill(0);
  for (const number of numbers) bins[Math.floor(number * 256)]!++;
  const expected = numbers.length / 256;
  return bins.reduce((sum, count) => sum + (count - expected) ** 2 / expected, 0);
}

describe("pcg", () => {
  // Worked out with unbounded integers from the formula in Jarzynski and Olano 2020.
  test.each([
    [0, 129708002],
    [1, 2831084092],
    [2, 2055130248],
    [42, 1223963391],
    [0x7fffffff, 3919530446],
    [0x80000000, 566699590],
    [0xdeadbeef, 1730779506],
    [0xffffffff, 3861530882],
  ])("hashes %i to the published function's value", (value, hash) => {
    expect(pcg(value)).toBe(hash);
  });

  test("stays on the published sequence for a thousand links of a chain", () => {
    expect(Array.from({ length: 1000 }).reduce<number>((hash) => pcg(hash), 0)).toBe(1064707366);
  });

  test("gives different numbers different hashes", () => {
    expect(new Set(counted).size).toBe(COUNT);
  });

  test("turns half of the bits when one bit of the number turns", () => {
    let turned = 0;
    for (let value = 0; value < 1000; value++) {
      for (let bit = 0; bit < 32; bit++) {
        let difference = (pcg(value) ^ pcg((value ^ (1 << bit)) >>> 0)) >>> 0;
        for (; difference !== 0; difference >>>= 1) turned += difference & 1;
      }
    }
    expect(turned / 32_000).toBeCloseTo(16, 0);
  });
});

describe.each([
  ["consecutive numbers", counted],
  ["hashes of hashes", chained],
])("chances from %s", (_, hashes) => {
  const units = hashes.map(unit);

  test("lie in [0, 1), or in [-1, 1) when signed", () => {
    expect(Math.min(...units)).toBeGreaterThanOrEqual(0);
    expect(Math.max(...units)).toBeLessThan(1);
    const both = hashes.map(signed);
    expect(Math.min(...both)).toBeGreaterThanOrEqual(-1);
    expect(Math.min(...both)).toBeLessThan(-0.999);
    expect(Math.max(...both)).toBeLessThan(1);
    expect(Math.max(...both)).toBeGreaterThan(0.999);
  });

  test("are uniform", () => {
    // 255 degrees of freedom: beyond these bounds once in ten thousand.
    expect(chiSquared(units)).toBeGreaterThan(178);
    expect(chiSquared(units)).toBeLessThan(347);
  });

  test("know nothing of the one before", () => {
    let sum = 0;
    for (let i = 1; i < COUNT; i++) sum += (units[i]! - 0.5) * (units[i - 1]! - 0.5);
    expect(Math.abs((sum / COUNT) * 12)).toBeLessThan(0.02);
  });
});

test("the extreme hashes are exact as floats", () => {
  expect(unit(0)).toBe(0);
  expect(unit(0xffffffff)).toBe(1 - 2 ** -24);
  expect(Math.fround(unit(0xffffffff))).toBe(unit(0xffffffff));
  expect(signed(0)).toBe(-1);
  expect(signed(0x80000000)).toBe(0);
});
