import { expect, test } from "vitest";
import { flip } from "../support/flip.ts";

const SIZE = { width: 24, height: 16 };

/** A slope of light with stripes, and what makes the other picture another. */
function picture(gain: number, stripe: number) {
  const linear = new Float32Array(SIZE.width * SIZE.height * 3);
  for (let i = 0; i < SIZE.width * SIZE.height; i++) {
    const [x, y] = [i % SIZE.width, Math.floor(i / SIZE.width)];
    const level = 0.02 + (0.6 * x) / SIZE.width + (y % 4 === 0 ? stripe : 0);
    linear.set([level * gain, level * 0.6, level * 0.2], i * 3);
  }
  return { ...SIZE, linear };
}

const mean = (values: Float32Array) => values.reduce((sum, x) => sum + x, 0) / values.length;

test("A picture is like itself", () => {
  expect(mean(flip(picture(1, 0.1), picture(1, 0.1)))).toBe(0);
});

test("Pictures differ as much as the authors' own program says", () => {
  // flip-evaluator 1.7, of the same pictures in sRGB, 67.02 pixels a degree.
  expect(mean(flip(picture(1, 0), picture(1, 0.1)))).toBeCloseTo(0.158276, 4);
  expect(mean(flip(picture(1, 0.1), picture(1.2, 0.05)))).toBeCloseTo(0.173612, 4);
});
