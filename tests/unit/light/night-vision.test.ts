import { expect, test } from "vitest";
import { adaptation, luma } from "../../../src/light/color.ts";
import { TAPER } from "../../../src/light/flame-light.ts";
import { adaptedMoonlight, moonLuma } from "../../../src/light/moonlight.ts";
import { nightVision } from "../../../src/light/night-vision.ts";

test("rods take over late, and contrast falls all the way", () => {
  expect(nightVision(0)).toEqual({ contrast: 1.5, rods: 0 });
  expect(nightVision(0.25).rods).toBe(0);
  let before = nightVision(0);
  for (let i = 1; i <= 96; i++) {
    const here = nightVision(i / 96);
    expect(here.contrast).toBeLessThan(before.contrast);
    expect(here.rods).toBeGreaterThanOrEqual(before.rods);
    before = here;
  }
  expect(before.rods).toBeGreaterThan(0.5);
  expect(before.rods).toBeLessThan(1);
});

test("moonlight is cool beside candlelight, and no neon", () => {
  const gains = adaptation(TAPER.color);
  const light = adaptedMoonlight(0.15);
  const shown = light.map((x, i) => x * (gains[i] ?? 1)) as [number, number, number];
  expect(luma(shown)).toBeCloseTo(0.15, 6);
  const [red, green, blue] = shown.map((x) => x / 0.15) as [number, number, number];
  expect(red).toBeLessThan(green);
  expect(green).toBeLessThan(blue);
  expect(blue).toBeLessThan(1.75);
});

test("luma's weights for moonlight are those of its light before the adaptation: warm, and 1 together", () => {
  const weights = moonLuma();
  expect(weights.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 9);
  const color = [0.4, 0.25, 0.1] as const;
  const light = adaptedMoonlight(1);
  const reflected = luma([color[0] * light[0], color[1] * light[1], color[2] * light[2]]);
  const weighted = color.reduce((sum, channel, i) => sum + channel * weights[i]!, 0);
  expect(weighted).toBeCloseTo(reflected / luma(light), 9);
  expect(weighted).toBeGreaterThan(1.03 * luma(color));
});
