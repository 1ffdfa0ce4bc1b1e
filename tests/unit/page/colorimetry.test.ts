import { describe, expect, test } from "vitest";
import { readingOf } from "../../../src/page/lab/colorimetry.ts";

/** Linear Rec. 709 of a chromaticity, with luminance 1. */
function rgbOf(x: number, y: number): [number, number, number] {
  const [X, Z] = [x / y, (1 - x - y) / y];
  return [
    3.2404542 * X - 1.5371385 - 0.4985314 * Z,
    -0.969266 * X + 1.8760108 + 0.041556 * Z,
    0.0556434 * X - 0.2040259 + 1.0572252 * Z,
  ];
}

describe("the spot meter", () => {
  test.each([
    ["illuminant A", 0.44758, 0.40745, 2856],
    ["illuminant D65", 0.31272, 0.32903, 6504],
    ["a black body of 1900 K", 0.5374, 0.4117, 1900],
    ["equal energy", 1 / 3, 1 / 3, 5455],
  ])("gives %s its temperature and chromaticity", (_, x, y, kelvin) => {
    const reading = readingOf(rgbOf(x, y), 0.5);
    expect(reading?.luminance).toBeCloseTo(1, 5);
    expect(reading?.x).toBeCloseTo(x, 4);
    expect(reading?.y).toBeCloseTo(y, 4);
    expect(Math.abs((reading?.temperature ?? 0) / kelvin - 1)).toBeLessThan(0.015);
  });

  test("takes a matt surface: pi times the luminance, over the albedo", () => {
    expect(readingOf([0.5, 0.5, 0.5], 0.5)?.illuminance).toBeCloseTo(Math.PI, 5);
    expect(readingOf([0.5, 0.5, 0.5], 0.25)?.illuminance).toBeCloseTo(2 * Math.PI, 5);
  });

  test("gives no temperature to what is no white, and no reading of darkness", () => {
    expect(readingOf([0, 1, 0], 0.5)?.temperature).toBeNull();
    expect(readingOf([0, 0, 1], 0.5)?.temperature).toBeNull();
    expect(readingOf([0, 0, 0], 0.5)).toBeNull();
  });
});
