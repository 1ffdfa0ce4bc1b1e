import type { Page } from "playwright/test";
import type { Rgb } from "../../src/light/color.ts";
import { emberRadiance, TAPER } from "../../src/light/flame-light.ts";
import { EXPOSURE_LAW, exposureOf } from "../../src/world/player/exposure-adaptation.ts";
import { shown } from "../support/display-transform.ts";
import { openSources } from "../support/sources.ts";
import { expect, test } from "../support/test.ts";

type Eye = typeof import("../support/eye.ts");

/** The range of exposures, stops. */
const { most } = EXPOSURE_LAW;
const BRIGHT = 1;

let page: Page;
test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await openSources(page);
});
test.afterAll(() => page.close());

/** What the display makes of some colours, 8 bits each, and what a page sees that copies the canvas. */
function show(
  colors: readonly Rgb[],
  stops: number,
  gamut: PredefinedColorSpace = "srgb",
  usesToneLut = false,
): Promise<{ own: Rgb[]; seen: Rgb[] }> {
  return page.evaluate(
    async ({ colors, stops, gamut, usesToneLut }) => {
      const { Eye }: Eye = await import("/tests/support/eye.ts" as string);
      const [width, height] = [8, 8]; // of each: dither is averaged out, and no edge is near the middle
      const eye = new Eye(colors.length * width, height);
      const at = (x: number) => colors[Math.floor(x / width)] ?? ([0, 0, 0] as const);
      const pixels = eye.show(at, stops, gamut, usesToneLut);
      eye.dispose();
      const means = (of: readonly number[]) =>
        colors.map((_, color) => {
          const sum: [number, number, number] = [0, 0, 0];
          for (let y = 2; y < 6; y++) {
            for (let x = 2; x < 6; x++) {
              const from = (y * colors.length * width + color * width + x) * 4;
              for (const i of [0, 1, 2] as const) sum[i] += (of[from + i] ?? 0) / 16;
            }
          }
          return sum;
        });
      return { own: means(pixels.own), seen: means(pixels.seen) };
    },
    { colors, stops, gamut, usesToneLut },
  );
}

const linear = (byte: number) =>
  byte <= 10.31475 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;

/** Hue angle, degrees, and chroma in CIELAB: red is at 40, orange at 65, yellow at 100, pink below 25. */
function hueOf(shown: Rgb): { hue: number; chroma: number } {
  const [r, g, b] = shown.map(linear) as [number, number, number];
  const cube = (t: number) => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 / 116) * t + 16 / 116);
  const x = cube((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const y = cube(0.2126729 * r + 0.7151522 * g + 0.072175 * b);
  const z = cube((0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883);
  const [red, yellow] = [500 * (x - y), 200 * (y - z)];
  return { hue: (Math.atan2(yellow, red) * 180) / Math.PI, chroma: Math.hypot(red, yellow) };
}

const encoded = (x: number) =>
  255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * Math.max(x, 0) ** (1 / 2.4) - 0.055);

const scaled = ([r, g, b]: Rgb, by: number): Rgb => [r * by, g * by, b * by];

/** Steps of 255 by which what is left of dither in the mean of 16 pixels may move a colour; and the tone LUT. */
const DITHER = 1;
const TABULATED = 3.5;

test("The tests' display transform equals the renderer's, and that by a table nearly", async () => {
  const hues: Rgb[] = [
    TAPER.color,
    emberRadiance(1100),
    [0.2, 0.2, 0.9],
    [0.9, 0.5, 0.1],
    [1, 1, 1],
  ];
  const most = [0, 0];
  for (const hue of hues) {
    const ramp = Array.from({ length: 30 }, (_, i) => scaled(hue, 2 ** (i * 0.8 - 10)));
    for (const usesToneLut of [0, 1] as const) {
      const { own } = await show(ramp, BRIGHT, "srgb", usesToneLut === 1);
      for (const [i, color] of own.entries()) {
        const expected = shown(scaled(ramp[i] ?? hue, 2 ** BRIGHT)).map(encoded);
        const away = color.map((value, channel) => Math.abs(value - (expected[channel] ?? 0)));
        most[usesToneLut] = Math.max(most[usesToneLut]!, ...away);
        expect(Math.max(...away), `${ramp[i]}`).toBeLessThan(usesToneLut ? TABULATED : DITHER);
      }
    }
  }
  console.log(`display transform: off by ${most[0]} of 255, by the tone LUT ${most[1]}`);
});

test("Embers are shown red at any exposure, and never pink", async () => {
  const temperatures = [900, 950, 1000, 1050, 1100, 1150, 1200];
  for (const stops of [BRIGHT, most]) {
    const { own } = await show(
      temperatures.map((temperature) => emberRadiance(temperature)),
      stops,
    );
    for (const [i, shown] of own.entries()) {
      const { hue, chroma } = hueOf(shown);
      console.log(`${temperatures[i]} K: ${shown.map(Math.round)}, hue ${hue.toFixed(0)}`);
      expect(hue, `${temperatures[i]} K`).toBeGreaterThan(32);
      expect(hue, `${temperatures[i]} K`).toBeLessThan(72);
      expect(chroma).toBeGreaterThan(50);
    }
  }
});

test("The flame's core is near white, its light on a white thing is warm, and hues stay as it fades", async () => {
  const levels = [1.2e4, 5e3, 0.3, 0.1, 0.03, 0.01];
  const { own } = await show(
    levels.map((level) => scaled(TAPER.color, level)),
    most,
  );
  const [core, flame, ...surfaces] = own as [Rgb, Rgb, ...Rgb[]];
  console.log(own.map((shown) => shown.map(Math.round)).join("; "));
  for (const shown of [core, flame]) {
    expect(shown[0]).toBeGreaterThan(252);
    expect(shown[1]).toBeGreaterThan(242);
    expect(shown[2]).toBeGreaterThan(200);
    expect(shown[2]).toBeLessThan(shown[1]);
  }
  const hues = surfaces.map((shown) => hueOf(shown).hue);
  expect(Math.max(...hues) - Math.min(...hues)).toBeLessThan(4);
  expect(hues[0]).toBeGreaterThan(65); // gold, not salmon
  expect(hues[0]).toBeLessThan(90);
});

test("More light is never shown darker, in any channel", async () => {
  const hues: Rgb[] = [TAPER.color, emberRadiance(1100), [0.2, 0.2, 0.9], [1, 1, 1]];
  for (const hue of hues) {
    const peak = Math.max(...hue);
    const ramp = Array.from({ length: 60 }, (_, i) => scaled(hue, 2 ** (i * 0.4 - 9) / peak));
    const { own } = await show(ramp, 1);
    for (let i = 1; i < own.length; i++) {
      for (const channel of [0, 1, 2] as const) {
        // The dither's mean over 16 pixels is off by a third of a step.
        const rise = (own[i]?.[channel] ?? 0) - (own[i - 1]?.[channel] ?? 0);
        expect(rise).toBeGreaterThan(-0.5);
      }
    }
    expect(own.at(-1)?.[0]).toBeGreaterThan(own[0]?.[0] ?? 255);
  }
});

test("A smooth dark gradient shows no bands", async () => {
  const { rows, spread } = await page.evaluate(
    async ({ color }) => {
      const { Eye }: Eye = await import("/tests/support/eye.ts" as string);
      const [width, height] = [1280, 16];
      const eye = new Eye(width, height);
      const dark = (x: number) => 0.002 + 0.003 * (x / width);
      const { own } = eye.show(
        (x) => [color[0] * dark(x), color[1] * dark(x), color[2] * dark(x)],
        3,
      );
      eye.dispose();
      const rows: number[] = [];
      const spread: number[] = [];
      for (const channel of [0, 1, 2]) {
        const at = (x: number, y: number) => own[(y * width + x) * 4 + channel] ?? 0;
        spread.push(Math.abs(at(width - 1, 8) - at(0, 8)));
        for (let y = 0; y < height; y++) {
          let longest = 0;
          for (let x = 1, run = 1; x < width; x++) {
            run = at(x, y) === at(x - 1, y) && at(x, y) > 0 ? run + 1 : 1;
            longest = Math.max(longest, run);
          }
          rows.push(longest);
        }
      }
      return { rows, spread };
    },
    { color: TAPER.color },
  );
  console.log(`longest run ${Math.max(...rows)} px, over ${spread} steps`);
  expect(Math.max(...rows)).toBeLessThanOrEqual(24);
  // Without dither so few steps over so many pixels would be bands of 40 pixels and more.
  expect(Math.max(...spread)).toBeLessThan(1280 / 40);
});

test("Scattered light is as much as there was, wherever a flame stands in the picture", async () => {
  const shares = await page.evaluate(async () => {
    const { Eye }: Eye = await import("/tests/support/eye.ts" as string);
    const shares: number[] = [];
    for (const [width, height, levels, isFrugal, size] of [
      [320, 180, 5, false, 4],
      [852, 468, 3, true, 4],
      [853, 478, 3, true, 0.6], // of a pixel or two, between the texels of a quarter
    ] as const) {
      const eye = new Eye(width, height);
      for (const [fx, fy] of [
        [0.5, 0.5],
        [0.62, 0.35],
        [0.3, 0.7],
      ] as const) {
        const isFlame = (x: number, y: number) =>
          Math.abs(x - fx * width) < size && Math.abs(y - fy * height) < 2.5 * size;
        const [before, after] = eye.scatter(
          (x, y) => (isFlame(x, y) ? [9000, 4000, 300] : [0.02, 0.01, 0.002]),
          levels,
          isFrugal,
        );
        shares.push(after / before);
      }
      eye.dispose();
    }
    return shares;
  });
  console.log(`scattered: ${shares.map((share) => share.toFixed(4))}`);
  // What falls on the picture's edge is reflected, not lost, but not to the last bit.
  for (const share of shares) expect(Math.abs(share - 1)).toBeLessThan(0.02);
});

test("An earlier frame's glare moves with the first flame that burns in the frame, and else with none", async () => {
  const shifts = await page.evaluate(async () => {
    const { Eye }: Eye = await import("/tests/support/eye.ts" as string);
    const eye = new Eye(320, 180);
    const [aside, fartherAside] = [
      [-3, 0.5],
      [-9, 0.5],
    ] as const;
    const [middle, beside] = [
      [0.4, 0.5],
      [0.42, 0.45],
    ] as const;
    const shifts = [
      eye.shift([middle, aside], [beside, fartherAside]),
      eye.shift([aside, middle], [fartherAside, beside]),
      eye.shift([null, middle], [middle, beside]),
      eye.shift([aside, null], [fartherAside, beside]),
      eye.shift([middle], [null]),
    ];
    eye.dispose();
    return shifts;
  });
  const moved = [expect.closeTo(-0.02), expect.closeTo(0.05)];
  expect(shifts).toEqual([moved, moved, moved, [0, 0], [0, 0]]);
});

test("The meter takes no notice of the flame, lags as set, and keeps to its limits", async () => {
  const stops = await page.evaluate(async () => {
    const { Eye }: Eye = await import("/tests/support/eye.ts" as string);
    const eye = new Eye(128, 72);
    const wall = (level: number) => () => [level, level, level] as const;
    const withFlame = (x: number, y: number) =>
      x > 50 && x < 60 && y > 20 && y < 50
        ? ([9e3, 4e3, 300] as const)
        : ([0.02, 0.02, 0.02] as const);
    const stops = {
      plain: eye.meter(wall(0.02)),
      withFlame: eye.meter(withFlame),
      // Cloth beside a flame.
      withCloth: eye.meter((x) => wall(x < 64 ? 0.02 : 30)()),
      bright: eye.meter(wall(0.08)),
      lagging: eye.meter(wall(0.08), 0.5),
      dark: eye.meter(wall(0.001)),
      darker: eye.meter(wall(0), 1),
    };
    eye.dispose();
    return stops;
  });
  expect(stops.plain).toBeCloseTo(exposureOf(Math.log2(0.02)), 2);
  expect(stops.withFlame).toBeCloseTo(stops.plain, 2);
  expect(stops.withCloth).toBeCloseTo(exposureOf(0.5 * Math.log2(0.02 * 30)), 2);
  expect(stops.bright).toBeCloseTo(exposureOf(Math.log2(0.08)), 2);
  expect(stops.lagging).toBeCloseTo(stops.bright + 0.5, 2);
  expect(stops.dark).toBeCloseTo(most, 2);
  expect(stops.darker).toBeCloseTo(most, 2);
});

test("On a Display P3 screen the same colours are shown, by other values", async () => {
  const colors: Rgb[] = [
    scaled(TAPER.color, 0.05),
    [0.05, 0.04, 0.01],
    [0.01, 0.04, 0.3],
    [0.06, 0.03, 0.02],
  ];
  const [usual, wide] = [await show(colors, 2), await show(colors, 2, "display-p3")];
  for (const i of colors.keys()) {
    const difference = ([a, b]: readonly (Rgb | undefined)[]) =>
      Math.max(...(a ?? []).map((value, channel) => Math.abs(value - (b?.[channel] ?? 255))));
    expect(difference([usual.own[i], wide.seen[i]]), `colour ${i}`).toBeLessThan(1.5);
    expect(difference([usual.own[i], wide.own[i]]), `numbers of ${i}`).toBeGreaterThan(2);
  }
});
