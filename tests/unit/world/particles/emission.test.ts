import { describe, expect, test } from "vitest";
import {
  ORIGINAL_LAYERS,
  PAPER_LAYERS,
  withCount,
} from "../../../../src/world/particles/particle-layer.ts";
import { emissionOf } from "../../../../src/world/particles/particles.ts";
import { HISTORY, TICK } from "../../../../src/world/timeline.ts";
import { alive, burning, CORE, HAZE, type Particle, pass } from "../burning.ts";

/** Floats hold about seven digits; the kernel's state is floats. */
const FLOAT = 3e-7;

describe("births (P2, P7)", () => {
  const RATES = [1 / 3, 0.7, 7, 59.94, 100, 120, 300, 1000, 123_456.7, 1e6];

  test.each(RATES)("at %d/s number rate times time, to within one, at any time", (rate) => {
    const layer = { ...CORE, rate };
    let count = 0;
    let worst = 0;
    for (let tick = -HISTORY; tick < 3000; tick++) {
      count += emissionOf(layer, tick).count;
      worst = Math.max(worst, Math.abs(count - rate * (tick + 1 + HISTORY) * TICK));
    }
    expect(worst).toBeLessThan(1 + 1e-6);
    expect(count).toBeGreaterThan(0);
  });

  test.each(RATES)("at %d/s are numbered without gap or repetition", (rate) => {
    const layer = { ...CORE, rate };
    let next = 1;
    for (let tick = -HISTORY; tick < 1000; tick++) {
      const { first, count } = emissionOf(layer, tick);
      expect(first).toBe(next);
      next += count;
    }
    expect(next).toBeGreaterThan(1);
  });

  test.each(RATES)("at %d/s are evenly spaced, each within its tick", (rate) => {
    const layer = { ...CORE, rate };
    let last = Number.NaN;
    for (let tick = 0; tick < 1000; tick++) {
      const { count, age } = emissionOf(layer, tick);
      if (count === 0) continue;
      const eldest = (tick + 1) * TICK - age;
      if (!Number.isNaN(last)) expect(eldest - last).toBeCloseTo(1 / rate, 8);
      last = eldest + (count - 1) / rate;
      expect(eldest).toBeGreaterThan(tick * TICK - 1e-9);
      expect(last).toBeLessThan((tick + 1) * TICK + 1e-9);
    }
    expect(last).toBeGreaterThan(0);
  });

  test.each([
    ["7/s", { ...CORE, rate: 7, capacity: 8 }, 5],
    ["the paper's core", CORE, 210],
    ["the paper's haze", HAZE, 150],
    ["a million a second", { ...CORE, rate: 1e6, life: 0.01, capacity: 10_004 }, 10_000],
    ["a flame of one particle", { ...CORE, rate: 1 / 0.7, capacity: 4 }, 1],
    ...withCount(PAPER_LAYERS, 5000).map(
      (layer) => [`5000, ${layer.name}`, layer, layer.rate * layer.life] as const,
    ),
  ] as const)("keep rate times life alive: %s", (_, layer, expected) => {
    const { timeline, particles } = burning(layer, Math.ceil(layer.life / TICK) + 1);
    for (let i = 0; i < 3; i++) {
      expect(Math.abs(alive(particles).length - expected)).toBeLessThanOrEqual(1);
      pass(timeline, 17);
      particles.follow(timeline);
    }
  });

  test("use the slots of the dead again", () => {
    const { timeline, particles } = burning(CORE);
    const seen = new Set<number>();
    for (let i = 0; i < 3 * 120; i++) {
      pass(timeline, 1);
      particles.follow(timeline);
      for (const { slot, age } of alive(particles)) if (age <= TICK) seen.add(slot);
    }
    // 900 births in 3 s, in 500 slots.
    expect(seen.size).toBe(CORE.capacity);
  });
});

describe.each([CORE, HAZE, ...ORIGINAL_LAYERS])(
  "a newborn particle (P2): $name of $capacity",
  (layer) => {
    const { timeline, particles } = burning(layer);
    const [slow, fast] = layer.speed;
    const newborn: Particle[] = [];
    for (let i = 0; i < 20 * 120; i++) {
      pass(timeline, 1);
      particles.follow(timeline);
      newborn.push(...alive(particles).filter(({ age }) => age < TICK - 1e-6));
    }
    // Where it was at its very moment of birth, before it rose for the rest of its tick.
    const births = newborn.map(({ position, velocity, age }) =>
      position.map((coordinate, axis) => coordinate - velocity[axis]! * age),
    );
    const range = (numbers: number[]) => [Math.min(...numbers), Math.max(...numbers)] as const;

    test("begins in the square around the emitter, and fills it", () => {
      expect(births.length).toBeGreaterThan(15 * layer.rate);
      for (const axis of [0, 2]) {
        const [least, most] = range(births.map((birth) => birth[axis]!));
        expect(least).toBeGreaterThanOrEqual(-layer.spawnRadius - FLOAT);
        expect(least).toBeLessThan(-0.98 * layer.spawnRadius);
        expect(most).toBeLessThanOrEqual(layer.spawnRadius + FLOAT);
        expect(most).toBeGreaterThan(0.98 * layer.spawnRadius);
      }
    });

    test("begins at the one height of birth", () => {
      for (const birth of births) expect(birth[1]).toBeCloseTo(layer.spawnHeight, 6);
    });

    test("rises at a speed out of the layer's range, and all of it occurs", () => {
      const [least, most] = range(newborn.map(({ velocity }) => velocity[1]));
      expect(least).toBeGreaterThanOrEqual(slow - FLOAT);
      expect(most).toBeLessThanOrEqual(fast + FLOAT);
      expect(most - least).toBeGreaterThanOrEqual(0.98 * (fast - slow));
    });

    test("goes sideways by 0.05 at most, in every direction", () => {
      for (const axis of [0, 2] as const) {
        const [least, most] = range(newborn.map(({ velocity }) => velocity[axis]));
        expect(Math.max(-least, most)).toBeLessThanOrEqual(0.05 + FLOAT);
        expect(least).toBeLessThan(-0.049);
        expect(most).toBeGreaterThan(0.049);
      }
    });

    test("has its whole life before it, less what has passed of its tick", () => {
      for (const { age } of newborn) expect(age).toBeGreaterThan(-FLOAT);
    });

    test("keeps no secret between any two of its chances", () => {
      const chances = newborn.map(({ velocity: [vx, vy, vz] }, i) => [
        births[i]![0]! / layer.spawnRadius,
        births[i]![2]! / layer.spawnRadius,
        vx / layer.sideSpeed,
        fast > slow ? (2 * (vy - slow)) / (fast - slow) - 1 : 0,
        vz / layer.sideSpeed,
      ]);
      for (let a = 0; a < 5; a++) {
        for (let b = 0; b < a; b++) {
          const sum = chances.reduce((total, numbers) => total + numbers[a]! * numbers[b]!, 0);
          // Numbers uniform in [-1, 1) have a mean square of a third.
          expect(Math.abs((3 * sum) / chances.length)).toBeLessThan(0.1);
        }
      }
    });
  },
);
