import { expect, test } from "vitest";
import { Puffing, puffingFrequency } from "../../../src/world/flame/puffing.js";
import { TICK } from "../../../src/world/timeline.js";
import { strongest } from "../../../tools/puffing/measure.mjs";
import measured from "../../fixtures/puffing.json" with { type: "json" };

/** Pulse of a flame that has puffed for ten seconds, for ten more. */
function watch(width: number, gravity?: number): number[] {
  const puffing = new Puffing();
  for (let t = 0; t < 10; t += TICK) puffing.advance(width, TICK, gravity);
  return Array.from({ length: Math.round(10 / TICK) }, () => {
    puffing.advance(width, TICK, gravity);
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
  puffing.advance(0.01, 0.25);
  const left = Math.hypot(puffing.real, puffing.imaginary) / begin;
  expect(Math.abs(left / (solved?.growth ?? 0) - 1)).toBeLessThan(0.25);
});

test("it puffs alike at any step", () => {
  const [fine, coarse] = [new Puffing(), new Puffing()];
  for (let i = 0; i < 1200; i++) fine.advance(0.03, 1 / 240);
  for (let i = 0; i < 300; i++) coarse.advance(0.03, 1 / 60);
  expect(fine.pulse).toBeCloseTo(coarse.pulse, 6);
});
