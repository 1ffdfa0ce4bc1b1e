import { describe, expect, test } from "vitest";
import { BreathDetector, type Sound, soundOf } from "../../../src/page/breath.ts";
import { pcg, signed } from "../../../src/world/random.ts";
import { RATE, signal, vowel, wind } from "../../support/signals.ts";

const SAMPLES = 2048;

const hiss = (loudness: number) => signal(loudness, (i) => signed(pcg(i)));

/** Breaths heard in a second, in moments of 1/60 s. */
function breaths(samples: Float32Array): number[] {
  const detector = new BreathDetector();
  const found: number[] = [];
  for (let at = 0; at + SAMPLES <= RATE; at += RATE / 60) {
    const sound = soundOf(samples.subarray(at, at + SAMPLES), RATE);
    const strength = detector.hear(sound, 1 / 60);
    if (strength > 0) found.push(strength);
  }
  return found;
}

test("blowing is a breath, felt anew three times a second, and stronger the louder", () => {
  const soft = breaths(wind(0.1));
  const strong = breaths(wind(0.35));
  expect(strong).toHaveLength(3);
  expect(Math.max(...soft)).toBeLessThan(0.6);
  expect(Math.min(...strong)).toBeGreaterThan(0.6);
  expect(Math.max(...strong)).toBeLessThanOrEqual(1);
});

describe("no breath is", () => {
  test.each([
    ["a spoken a", vowel(0.3, [700, 1200])],
    ["a spoken e", vowel(0.3, [400, 2000])],
    ["a spoken o", vowel(0.3, [500, 900])],
    ["a spoken u", vowel(0.3, [300, 800])],
    ["humming", vowel(0.3, [250, 1000])],
    ["a hiss", hiss(0.3)],
    ["wind far away", wind(0.02)],
    ["silence", new Float32Array(RATE)],
    ["a microphone's offset", new Float32Array(RATE).fill(0.4)],
  ])("%s", (_, samples) => expect(breaths(samples)).toEqual([]));

  test("a knock", () => {
    const knock: Sound = { loudness: 0.8, lowShare: 0.9 };
    const pause: Sound = { loudness: 0.01, lowShare: 0.9 };
    const detector = new BreathDetector();
    for (let i = 0; i < 40; i++) {
      expect(detector.hear(i % 8 < 6 ? knock : pause, 1 / 60)).toBe(0);
    }
  });
});
