import { describe, expect, test } from "vitest";
import { Air, CALM } from "../../../../src/world/air/air.js";
import { Flame } from "../../../../src/world/flame/flame.js";
import { Puffing, puffingFrequency } from "../../../../src/world/flame/puffing.js";
import { TICK } from "../../../../src/world/timeline.js";
import { strongest } from "../../../../tools/puffing/measure.mjs";
import measured from "../../../fixtures/puffing.json" with { type: "json" };

/** Pulse of a flame that has puffed for ten seconds, for ten more. */
function watch(width: number, gravity?: number): number[] {
  const puffing = new Puffing();
  for (let t = 0; t < 10; t += TICK) puffing.advance({ width }, TICK, gravity);
  return Array.from({ length: Math.round(10 / TICK) }, () => {
    puffing.advance({ width }, TICK, gravity);
    return puffing.pulse;
  });
}

const rms = (pulses: readonly number[]) =>
  Math.sqrt(pulses.reduce((sum, pulse) => sum + (pulse - 1) ** 2, 0) / pulses.length);

test("a wide flame puffs as the solved one does: its frequency within 10 %, its swing within a third", () => {
  for (const { diameter, gravity, frequency, rms: swing, growth } of measured.trials) {
    if (growth < 0.6) continue;
    const pulses = watch(diameter, gravity);
    const name = `${diameter} m at ${gravity} m/s²`;
    expect(Math.abs(strongest(pulses, 1 / TICK) / frequency - 1), name).toBeLessThan(0.1);
    if (gravity < 10) expect(Math.abs(rms(pulses) / swing - 1), name).toBeLessThan(1 / 3);
  }
});

test("its frequency is within a fifth of 1.5 / √D, and doubles under four times the gravity", () => {
  for (const width of [0.02, 0.03, 0.05]) {
    const frequency = strongest(watch(width), 1 / TICK);
    expect(Math.abs((frequency * Math.sqrt(width)) / 1.5 - 1)).toBeLessThan(0.2);
    expect(puffingFrequency(width, 4 * 9.81) / puffingFrequency(width)).toBeCloseTo(2);
  }
});

test("a single candle has no tone of its own, and loses one that it was given", () => {
  for (const width of [0.001, 0.002, 0.01]) {
    const pulses = watch(width);
    expect(Math.max(...pulses)).toBe(1);
    expect(Math.min(...pulses)).toBe(1);
  }
});

test("below the threshold it calms down as fast as the solved flame does", () => {
  const solved = measured.trials.find(({ diameter }) => diameter === 0.01);
  const puffing = new Puffing();
  const begin = puffing.real;
  // Its swing was compared between the halves of half a second.
  puffing.advance({ width: 0.01 }, 0.25);
  const left = Math.hypot(puffing.real, puffing.imaginary) / begin;
  expect(Math.abs(left / (solved?.growth ?? 0) - 1)).toBeLessThan(0.25);
});

test("it puffs alike at any step", () => {
  const [fine, coarse] = [new Puffing(), new Puffing()];
  for (let i = 0; i < 1200; i++) fine.advance({ width: 0.03 }, 1 / 240);
  for (let i = 0; i < 300; i++) coarse.advance({ width: 0.03 }, 1 / 60);
  expect(fine.pulse).toBeCloseTo(coarse.pulse, 6);
});

describe("a flame over a wide wick in still air", () => {
  /** Height and light, ten seconds of them. */
  function burn(wick: number) {
    const air = new Air(1, CALM);
    const flame = new Flame(wick, true);
    const seen = { heights: [] as number[], lights: [] as number[], necks: [] as number[] };
    for (let tick = 0; tick < 20 / TICK; tick++) {
      flame.advance([0, 1, 0], [0, 0, 0], air, false, TICK);
      if (tick < 10 / TICK) continue;
      seen.heights.push(flame.height);
      seen.lights.push(flame.glow);
      seen.necks.push(flame.neck(flame.height));
    }
    return seen;
  }
  test("has no neck once it is out", () => {
    const air = new Air(1, CALM);
    const flame = new Flame(0.05, true);
    const burn = (seconds: number) => {
      for (let tick = 0; tick < seconds / TICK; tick++) {
        flame.advance([0, 1, 0], [0, 0, 0], air, false, TICK);
      }
    };
    burn(5);
    flame.extinguish();
    burn(5);
    expect([flame.height, flame.neck(0)]).toEqual([0, 1]);
  });

  const spread = (values: readonly number[]) => Math.max(...values) / Math.min(...values);

  test("puffs at 1.5 / √D within a fifth, as D^-0.5", () => {
    const widths = [0.02, 0.03, 0.05];
    const frequencies = widths.map((width) => strongest(burn(width).heights, 1 / TICK));
    for (const [i, width] of widths.entries()) {
      expect(Math.abs(((frequencies[i] ?? 0) * Math.sqrt(width)) / 1.5 - 1)).toBeLessThan(0.2);
    }
    const exponent = Math.log((frequencies[2] ?? 0) / (frequencies[0] ?? 1)) / Math.log(2.5);
    expect(Math.abs(exponent + 0.5)).toBeLessThan(0.1);
  });

  test("rises and falls, necks at its tip, and lights the room all but evenly", () => {
    const { heights, lights, necks } = burn(0.05);
    expect(spread(heights)).toBeGreaterThan(1.3);
    expect(spread(necks)).toBeGreaterThan(1.5);
    expect(spread(lights)).toBeLessThan(1.1);
  });

  test("does not puff as a candle, or where motion is reduced", () => {
    const { heights, necks } = burn(0.002);
    expect(spread(heights)).toBe(1);
    expect(spread(necks)).toBe(1);
    const flame = new Flame(0.05, true);
    for (let tick = 0; tick < 500; tick++) {
      flame.advance([0, 1, 0], [0, 0, 0], new Air(1, CALM), true, TICK);
      expect(flame.pulse).toBe(1);
    }
  });
});
