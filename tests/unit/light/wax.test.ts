import { expect, test } from "vitest";
import { textOf } from "../sources.js";

// No measured coefficients of candle wax were found: the band is what pillars look like.
test("wax glows down to 1/e in 6 to 16 mm of red light, and 1.3 to 2.5 times as far as in blue", () => {
  const shader = textOf("shaders/physical/wax.glsl");
  expect(shader).toContain("exp(-depth / DIFFUSION_LENGTH)");
  const [, text = ""] = /DIFFUSION_LENGTH = vec3\(([^)]*)\)/.exec(shader) ?? [];
  const [red = 0, , blue = 0] = text.split(",").map(Number);
  expect(red).toBeGreaterThan(0.006);
  expect(red).toBeLessThan(0.016);
  expect(red / blue).toBeGreaterThan(1.3);
  expect(red / blue).toBeLessThan(2.5);
});
