import { expect, test } from "vitest";
import { chromaticity, LEAST_BLUE, luma, type Rgb } from "../../../src/light/color.js";
import { TAPER } from "../../../src/light/flame-light.js";
import { sootRadiance } from "../../../src/light/soot.js";

/** Wyman, Sloan and Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Functions", JCGT 2(2). */
const lobe = (nanometres: number, peak: number, left: number, right: number) =>
  Math.exp(-0.5 * ((nanometres - peak) * (nanometres < peak ? left : right)) ** 2);
const OBSERVER = [
  (nm: number) =>
    1.056 * lobe(nm, 599.8, 0.0264, 0.0323) +
    0.362 * lobe(nm, 442, 0.0624, 0.0374) -
    0.065 * lobe(nm, 501.1, 0.049, 0.0382),
  (nm: number) => 0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322),
  (nm: number) => 1.217 * lobe(nm, 437, 0.0845, 0.0278) + 0.681 * lobe(nm, 459, 0.0385, 0.0725),
] as const;

/** CIE XYZ of soot at a temperature, by Planck's law and an emissivity of 550 nm / λ; Y in cd/m². */
function planck(temperature: number): Rgb {
  const xyz: [number, number, number] = [0, 0, 0];
  for (let nm = 360; nm <= 830; nm++) {
    const metres = nm * 1e-9;
    const radiance =
      1.191042972e-16 / metres ** 5 / Math.expm1(0.01438776877 / (metres * temperature));
    for (const k of [0, 1, 2] as const)
      xyz[k] += 683 * OBSERVER[k](nm) * radiance * 1e-9 * (550 / nm);
  }
  return xyz;
}

/** Linear Rec. 709 with as little blue as ours has where there would be less than none. */
function onScreen([x, y, z]: Rgb): Rgb {
  const red = 3.2404542 * x - 1.5371385 * y - 0.4985314 * z;
  const green = -0.969266 * x + 1.8760108 * y + 0.041556 * z;
  const blue = 0.0556434 * x - 0.2040259 * y + 1.0572252 * z;
  return [red, green, Math.max(blue, LEAST_BLUE * red)];
}

const away = (one: readonly [number, number], other: readonly [number, number]) =>
  Math.hypot(one[0] - other[0], one[1] - other[1]);

// The fit of the observer is itself off by up to 0.010 at 1200 K, and by 0.0025 from 1900 K on.
test("soot's colour and luminance follow Planck's law with an emissivity of 1/λ", () => {
  for (let temperature = 1200; temperature <= 2500; temperature += 50) {
    const xyz = planck(temperature);
    const soot = sootRadiance(temperature);
    const error = away(chromaticity(soot), chromaticity(onScreen(xyz)));
    expect(error, `${temperature} K`).toBeLessThan(temperature < 1700 ? 0.012 : 0.005);
    expect(Math.abs(luma(soot) / xyz[1] - 1), `${temperature} K`).toBeLessThan(0.05);
  }
});

test("the flame's light has the colour of candles, 1780 to 1980 K", () => {
  expect(away(chromaticity(TAPER.color), [0.3159, 0.5398])).toBeLessThan(0.01);
});
