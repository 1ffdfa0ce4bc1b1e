import { expect, test } from "vitest";
import { Breath } from "../../../../src/world/air/breath.ts";
import type { Vec3 } from "../../../../src/world/geometry.ts";

const EYE: Vec3 = [0, 0, 0];
const AHEAD: Vec3 = [0, 0, -1];

/** Speeds at a place straight ahead in each hundredth of a second, m/s, of breaths that begin when asked. */
function speeds(distance: number, strength: number, begins: (i: number) => boolean): number[] {
  const breath = new Breath();
  return Array.from({ length: 600 }, (_, i) => {
    breath.time = i / 100;
    if (begins(i)) breath.begin(EYE, AHEAD, distance, strength, Infinity);
    const out: Vec3 = [0, 0, 0];
    breath.add([0, 0, -distance], out);
    return -out[2];
  });
}

const once = (i: number) => i === 0;

test.each([
  [0.6, 1],
  [1, 0.1],
  [1.5, 0.2],
])("at %f m one of strength %f arrives whole", (distance, strength) => {
  const felt = speeds(distance, strength, once);
  const full = (20 * strength * 6.2 * 0.015) / (distance - 0.25);
  expect(Math.max(...felt)).toBeCloseTo(full, 2);
  const drops = felt.map((speed, i) => (felt[i - 1] ?? 0) - speed);
  expect(Math.max(...drops)).toBeLessThan(full / 4);
});

test.each([1, 0.5])("one of strength %f in every frame is one that goes on", (strength) => {
  const one = Math.max(...speeds(0.6, strength, once));
  const felt = speeds(0.6, strength, (i) => i % 2 === 0);
  expect(Math.min(...felt.slice(50))).toBeCloseTo(one, 6);
});

test("a stronger one that follows at once counts", () => {
  const breath = new Breath();
  const out: Vec3 = [0, 0, 0];
  for (const strength of [0.2, 1, 0.5]) breath.begin(EYE, AHEAD, 0.6, strength, Infinity);
  breath.time = 0.3;
  breath.add([0, 0, -0.6], out);
  expect(-out[2]).toBeCloseTo(Math.max(...speeds(0.6, 1, once)), 6);
});

test("those that are over, and those that never began, leave the air alone", () => {
  const breath = new Breath();
  const addAt = (time: number) => () => {
    breath.time = time;
    breath.add([0, 0, -1], Object.freeze([0, 0, 0]) as unknown as Vec3); // throws if it is written to
  };
  expect(addAt(3)).not.toThrow();
  breath.begin(EYE, AHEAD, 0.6, 1, Infinity);
  expect(addAt(18)).toThrow();
  expect(addAt(18.1)).not.toThrow();
});
