import { expect, test } from "vitest";
import { measure, strongest } from "../../../tools/puffing/measure.mjs";
import measured from "../../fixtures/puffing.json" with { type: "json" };

const EARTH = 9.81;
const { trials } = measured;
const onEarth = trials.filter(({ gravity }) => gravity === EARTH);
const puffing = onEarth.filter(({ diameter }) => diameter >= 0.02);
const trial = (diameter: number, gravity = EARTH) => {
  const found = trials.find((each) => each.diameter === diameter && each.gravity === gravity);
  if (!found) throw new Error(`Nobody measured a source of ${diameter} m.`);
  return found;
};

test("a spectrum finds the tone that is there", () => {
  const tone = Array.from({ length: 240 }, (_, i) => 5 + Math.sin((2 * Math.PI * 8.7 * i) / 240));
  expect(Math.abs(strongest(tone) - 8.7)).toBeLessThan(0.1);
});

// Cetegen and Ahmed 1993, "Experiments on the Periodic Instability of Buoyant Plumes and Pool Fires".
test("solved flames of 20, 30 and 50 mm puff at 1.5 / √D, within a fifth", () => {
  expect(puffing.map(({ diameter }) => diameter)).toEqual([0.02, 0.03, 0.05]);
  for (const { diameter, frequency } of puffing) {
    expect(Math.abs((frequency * Math.sqrt(diameter)) / 1.5 - 1), `${diameter} m`).toBeLessThan(
      0.2,
    );
  }
});

test("their frequency goes as the diameter's power of -0.5, within 0.1", () => {
  const points = puffing.map(({ diameter, frequency }) => [
    Math.log(diameter),
    Math.log(frequency),
  ]);
  const middle = [0, 1].map((k) => points.reduce((sum, p) => sum + (p[k] ?? 0), 0) / points.length);
  let [both, one] = [0, 0];
  for (const [x = 0, y = 0] of points) {
    const away = x - (middle[0] ?? 0);
    both += away * (y - (middle[1] ?? 0));
    one += away * away;
  }
  expect(Math.abs(both / one + 0.5)).toBeLessThan(0.1);
});

test("under four times the gravity a flame puffs twice as fast", () => {
  const ratio = trial(0.02, 4 * EARTH).frequency / trial(0.02).frequency;
  expect(Math.abs(ratio / 2 - 1)).toBeLessThan(0.1);
});

test("over a source of 10 mm what moves dies away", () => {
  const { growth, rms } = trial(0.01);
  expect(growth).toBeLessThan(0.6);
  expect(rms).toBeLessThan(0.1);
});

test("the solver's puffing agrees with the recorded one, on a coarser grid", () => {
  const { frequency, growth } = measure({
    ...trial(0.05),
    cellsPerDiameter: 10,
    settling: 0.6,
    seconds: 0.7,
  });
  expect(Math.abs(frequency / trial(0.05).frequency - 1)).toBeLessThan(0.1);
  expect(growth).toBeGreaterThan(1);
}, 60_000);
