import { expect, test } from "vitest";
import { wickEnd } from "../../../src/render/lone-candle/wick-end.ts";

const wick = (...positions: number[]) => ({ positions: Float32Array.from(positions) });

test("a wick ends at its highest vertex near the flame's axis", () => {
  const wicks = [wick(0, 0.1, 0, 0, 0.109, 0.004), wick(0.05, 0.115, 0), wick(0, 0.2, 0)];
  expect(wickEnd([0, 0.1, 0], wicks)).toBeCloseTo(0.009, 6);
  expect(wickEnd([0.05, 0.1, 0], wicks)).toBeCloseTo(0.015, 6);
});

test("a flame without a wick has one that ends as a taper's does", () => {
  expect(wickEnd([0, 0.1, 0], [])).toBe(0.0072);
  expect(wickEnd([0, 0.1, 0], [wick(0, 0.05, 0)])).toBe(0.0072);
});
