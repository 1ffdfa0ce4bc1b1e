import { expect, test } from "vitest";
import { roundUp } from "../../../src/page/lab/flame-plot.ts";
import {
  BINS,
  candelaOf,
  photopic,
  spectrumOf,
  wavelengthOf,
} from "../../../src/page/lab/spectrum.ts";

const binOf = (wavelength: number) =>
  [...Array(BINS).keys()].find((bin) => wavelengthOf(bin) >= wavelength) ?? 0;

test("a spectrum gives the candela that it was made for", () => {
  expect(candelaOf(spectrumOf(1, 0, 1900))).toBeCloseTo(1, 6);
  expect(candelaOf(spectrumOf(0.9, 0.1, 1900))).toBeCloseTo(1, 6);
  expect(candelaOf(spectrumOf(0, 0, 293))).toBe(0);
});

test("soot's light rises towards the red, the faster the colder it is", () => {
  const share = (kelvin: number) => {
    const spectrum = spectrumOf(1, 0, kelvin);
    return (spectrum[binOf(700)] ?? 0) / (spectrum[binOf(450)] ?? 1);
  };
  expect(share(1900)).toBeGreaterThan(30); // Planck: 45
  expect(share(1900)).toBeLessThan(60);
  expect(share(1200)).toBeGreaterThan(4 * share(1900));
});

test("the blue base stands out at its bands", () => {
  const [with_, without] = [spectrumOf(1, 0.05, 1900), spectrumOf(1, 0, 1900)];
  const gain = (wavelength: number) =>
    (with_[binOf(wavelength)] ?? 0) / (without[binOf(wavelength)] ?? 1);
  expect(gain(432)).toBeGreaterThan(3);
  expect(gain(432)).toBeGreaterThan(2 * gain(450));
  expect(gain(650)).toBeCloseTo(1, 2);
});

test("the eye is most sensitive to green, and blind at the ends", () => {
  expect(photopic(555)).toBeGreaterThan(0.98);
  expect(photopic(400)).toBeLessThan(0.01);
  expect(photopic(720)).toBeLessThan(0.01);
});

test("scales end at round numbers", () => {
  expect([0.0011, 0.9, 1, 1.01, 3, 7].map(roundUp)).toEqual([0.002, 1, 1, 2, 5, 10]);
});
