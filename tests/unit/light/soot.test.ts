import { expect, test } from "vitest";
import { chromaticity, LEAST_BLUE, luma, type Rgb } from "../../../src/light/color.js";
import { emberOverPage, emberRadiance, flameLight, TAPER } from "../../../src/light/flame-light.js";
import { sootRadiance } from "../../../src/light/soot.js";
import { Flame } from "../../../src/world/flame/flame.js";

/** CIE 1931, 2°: x, y and z, each times 10,000, every 10 nm from 380 nm to 780 nm. CIE 15:2004, table T.4. */
const OBSERVER = [
  [14, 0, 65],
  [42, 1, 201],
  [143, 4, 679],
  [435, 12, 2074],
  [1344, 40, 6456],
  [2839, 116, 13856],
  [3483, 230, 17471],
  [3362, 380, 17721],
  [2908, 600, 16692],
  [1954, 910, 12876],
  [956, 1390, 8130],
  [320, 2080, 4652],
  [49, 3230, 2720],
  [93, 5030, 1582],
  [633, 7100, 782],
  [1655, 8620, 422],
  [2904, 9540, 203],
  [4334, 9950, 87],
  [5945, 9950, 39],
  [7621, 9520, 21],
  [9163, 8700, 17],
  [10263, 7570, 11],
  [10622, 6310, 8],
  [10026, 5030, 3],
  [8544, 3810, 2],
  [6424, 2650, 0],
  [4479, 1750, 0],
  [2835, 1070, 0],
  [1649, 610, 0],
  [874, 320, 0],
  [468, 170, 0],
  [227, 82, 0],
  [114, 41, 0],
  [58, 21, 0],
  [29, 10, 0],
  [14, 5, 0],
  [7, 3, 0],
  [3, 1, 0],
  [2, 1, 0],
  [1, 0, 0],
  [0, 0, 0],
] as const;
const STEP = 10;

/** CIE XYZ of soot at a temperature, by Planck's law and an emissivity of 550 nm / λ; Y in cd/m². */
function planck(temperature: number): Rgb {
  const xyz: [number, number, number] = [0, 0, 0];
  for (const [i, observer] of OBSERVER.entries()) {
    const nm = 380 + STEP * i;
    const metres = nm * 1e-9;
    const radiance =
      1.191042972e-16 / metres ** 5 / Math.expm1(0.01438776877 / (metres * temperature));
    for (const k of [0, 1, 2] as const) {
      xyz[k] += 683 * (observer[k] / 10000) * radiance * STEP * 1e-9 * (550 / nm);
    }
  }
  return xyz;
}

/** Linear Rec. 709 with as little blue as ours has where there would be less than none. */
function onScreen([x, y, z]: Rgb): Rgb {
  const red = 3.2404542 * x - 1.5371385 * y - 0.4985314 * z;
  const green = Math.max(-0.969266 * x + 1.8760108 * y + 0.041556 * z, 0);
  const blue = 0.0556434 * x - 0.2040259 * y + 1.0572252 * z;
  return [red, green, Math.max(blue, LEAST_BLUE * red)];
}

const away = (one: readonly [number, number], other: readonly [number, number]) =>
  Math.hypot(one[0] - other[0], one[1] - other[1]);

test("soot's colour and luminance follow Planck's law with an emissivity of 1/λ", () => {
  for (let temperature = 1200; temperature <= 2500; temperature += 50) {
    const xyz = planck(temperature);
    const soot = sootRadiance(temperature);
    const error = away(chromaticity(soot), chromaticity(onScreen(xyz)));
    expect(error, `${temperature} K`).toBeLessThan(0.003);
    expect(Math.abs(luma(soot) / xyz[1] - 1), `${temperature} K`).toBeLessThan(0.05);
  }
});

test("a glowing wick has the colour of soot at 900 to 1150 K, but for what a screen cannot show", () => {
  for (let temperature = 900; temperature <= 1150; temperature += 50) {
    const error = away(
      chromaticity(emberRadiance(temperature)),
      chromaticity(onScreen(planck(temperature))),
    );
    expect(error, `${temperature} K`).toBeLessThan(0.02);
  }
});

test("the flame's light has the colour of candles, 1780 to 1980 K", () => {
  expect(away(chromaticity(TAPER.color), [0.3159, 0.5398])).toBeLessThan(0.01);
});

test("an ember over a page is as much darker as the page's white is, and its light with it", () => {
  // As large an exposure as a lone candle's.
  const factor = emberOverPage(5);
  const [red] = emberRadiance(1120, factor);
  expect(red * 5, "as a multiple of white").toBeGreaterThan(2);
  expect(red * 5).toBeLessThan(20);
  const [later] = emberRadiance(293 + (1120 - 293) * Math.exp(-0.3), factor);
  expect(later * 5, "after three seconds").toBeLessThan(0.2);
  const flame = new Flame(0.002, false);
  flame.ember = 1120;
  const rooted = { root: [0, 0, 0], flame } as const;
  const [whole] = flameLight(rooted, TAPER).intensity;
  expect(flameLight(rooted, TAPER, factor).intensity[0]).toBeCloseTo(whole * factor, 12);
});
