import { expect, test } from "vitest";
import { Air, CALM, type Wind } from "../../../../src/world/air/air.ts";
import { Flame } from "../../../../src/world/flame/flame.ts";
import { Limiter } from "../../../../src/world/flame/limiter.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { TICK } from "../../../../src/world/timeline.ts";
import { FlashMeter } from "../../../support/flash.ts";

const FOOT: Vec3 = [0, 1, 0];
const AT_REST: Vec3 = [0, 0, 0];
const EYE: Vec3 = [0, 1.6, 2];
/** Gold as candlelight shows on white things, linear, with a luminance of 1. */
const GOLD = [1.55, 0.87, 0.4] as const;
/** Exponent of the display's contrast around middle grey. */
const CONTRAST = 1.5;
/** Luminance that walls have in the light of the flame at its usual: dark ones, and ones burnt out. */
const WALLS = [0.2, 0.5, 0.64, 0.79, 0.95, 1.5];

/** sRGB, not rounded: the darkest golds of 8 bits are red. */
const encode = (linear: number) => {
  const x = Math.min(Math.max(linear, 0), 1);
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
};

type Deed = (flame: Flame, air: Air, seconds: number) => void;

/** Worst share of any wall that flashes in ten seconds at 60 Hz, by the light `of` the flame. */
function watch(wick: number, wind: Wind, deed: Deed, of: (flame: Flame) => number): number {
  const air = new Air(5, wind);
  const flame = new Flame(wick, true);
  for (let i = 0; i < 2 / TICK; i++) flame.advance(FOOT, AT_REST, air, false, TICK);
  const usual = flame.glow;
  const meters = WALLS.map(() => new FlashMeter(1, 1));
  for (let tick = 0; tick < 10 / TICK; tick++) {
    const seconds = tick * TICK;
    deed(flame, air, seconds);
    air.advance(2 / TICK + tick, EYE, AT_REST, FOOT, AT_REST);
    flame.advance(FOOT, AT_REST, air, false, TICK);
    if (tick % 2 === 0) continue;
    for (const [i, wall] of WALLS.entries()) {
      const luminance = (wall * of(flame)) / usual;
      const level = wall * (luminance / wall) ** CONTRAST;
      meters[i]?.look([...GOLD.map((channel) => encode(channel * level)), 255], seconds);
    }
  }
  return Math.max(...meters.flatMap(({ worst }) => Object.values(worst)));
}

const leave: Deed = () => {};
const toggle =
  (hertz: number): Deed =>
  (flame, _, seconds) => {
    const isOn = Math.floor(seconds * 2 * hertz) % 2 === 0;
    if (isOn !== flame.isLit) (isOn ? flame.light : flame.extinguish).call(flame);
  };
const squalls =
  (hertz: number, speed: number): Deed =>
  (_, air, seconds) => {
    air.wind = { ...air.wind, speed: (seconds * hertz) % 1 < 0.5 ? speed : 0 };
  };
const gale = (speed: number): Wind => ({ speed, direction: 0, gustiness: 1 });
const shown = (flame: Flame) => flame.glow;

test("no flame flashes, however wide, in gusts, as it puffs, goes out and is lit quickly", () => {
  const cases: [name: string, wick: number, wind: Wind, deed: Deed][] = [];
  for (const wick of [0.002, 0.02, 0.03, 0.05]) cases.push([`${wick} m`, wick, CALM, leave]);
  for (const speed of [0.25, 0.6, 1, 1.6]) {
    cases.push([`${speed} m/s`, 0.002, gale(speed), leave]);
    cases.push([`50 mm in ${speed} m/s`, 0.05, gale(speed), leave]);
  }
  for (const hertz of [1, 2, 3, 4, 5, 7, 10]) {
    cases.push([`toggled ${hertz} times a second`, 0.002, CALM, toggle(hertz)]);
    cases.push([`50 mm toggled ${hertz} times a second`, 0.05, CALM, toggle(hertz)]);
    cases.push([`squalls ${hertz} times a second`, 0.002, CALM, squalls(hertz, 2)]);
  }
  for (const [name, wick, wind, deed] of cases) {
    expect(watch(wick, wind, deed, shown), name).toBe(0);
  }
});

test("without the limiter a wide wick's puffing would flash", () => {
  expect(watch(0.05, CALM, leave, (flame) => flame.measure().light)).toBe(1);
});

test("slow changes pass, fast ones all but vanish", () => {
  const swing = (hertz: number) => {
    const limiter = new Limiter();
    limiter.settle(1);
    let [least, most] = [2, 0];
    for (let tick = 0; tick < 960; tick++) {
      limiter.target = 1 + 0.3 * Math.sin(2 * Math.PI * hertz * tick * TICK);
      limiter.advance(TICK);
      if (tick < 480) continue;
      least = Math.min(least, limiter.light);
      most = Math.max(most, limiter.light);
    }
    return (most - least) / 0.6;
  };
  expect(swing(0.25)).toBeGreaterThan(0.95);
  expect(swing(8)).toBeLessThan(0.19);
});

test("put out, it shrinks onto its wick, and is dark within half a second", () => {
  const flame = new Flame(0.002, true);
  const air = new Air(1, CALM);
  const { height } = flame;
  flame.extinguish();
  for (let i = 0; i < 0.2 / TICK; i++) flame.advance(FOOT, AT_REST, air, false, TICK);
  expect(flame.height).toBeLessThan(0.6 * height);
  for (let i = 0; i < 0.3 / TICK; i++) flame.advance(FOOT, AT_REST, air, false, TICK);
  expect(flame.glow).toBeLessThan(0.005);
  for (let i = 0; i < 0.5 / TICK; i++) flame.advance(FOOT, AT_REST, air, false, TICK);
  expect(flame.glow).toBe(0);
});
