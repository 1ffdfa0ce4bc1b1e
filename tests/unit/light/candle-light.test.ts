import { describe, expect, test } from "vitest";
import { candleLight, type PointLight, sampleOf } from "../../../src/light/candle-light.ts";
import { allFeatures } from "../../../src/settings.ts";
import { advance } from "../../../src/world/advance.ts";
import { moveCamera } from "../../../src/world/commands.ts";
import { PARTICLE_FLOATS } from "../../../src/world/particles/particles.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { TICK } from "../../../src/world/timeline.ts";
import type { World } from "../../../src/world/world.ts";
import { FlashMeter } from "../../support/flash.ts";
import { createWorld } from "../../support/world.ts";

const ALL = allFeatures();
const lightOf = (world: World, isStill = false) => candleLight(world, ALL, isStill);
const luma = ([r, g, b]: PointLight["color"]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** The light at each of the next ticks. */
function lights(world: World, ticks: number, features = ALL, isStill = false): PointLight[] {
  return Array.from({ length: ticks }, () => {
    advance(world, STILL, TICK);
    return candleLight(world, features, isStill);
  });
}

/** Box around the living particles of the sample, in the room. */
function boxOfParticles(world: World) {
  const { setup, interpolated } = world;
  const { state } = sampleOf(world);
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < state.length; i += PARTICLE_FLOATS) {
    if (state[i + 3]! <= 0) continue;
    for (const axis of [0, 1, 2] as const) {
      const at = interpolated.flame[axis] + state[i + axis]! * setup.flameScale;
      min[axis] = Math.min(min[axis]!, at);
      max[axis] = Math.max(max[axis]!, at);
    }
  }
  return { min, max };
}

describe("where the light is (L1)", () => {
  test("it is amid the flame's particles, still or carried", () => {
    const world = createWorld("paper", 2);
    for (let i = 0; i < 120; i++) {
      advance(world, { ...STILL, forward: 1, turn: 1 }, 1 / 60);
      const { position } = lightOf(world);
      const { min, max } = boxOfParticles(world);
      for (const axis of [0, 1, 2] as const) {
        expect(position[axis]).toBeGreaterThan(min[axis]!);
        expect(position[axis]).toBeLessThan(max[axis]!);
      }
    }
  });

  test("it goes where the candle is carried, whole", () => {
    const world = createWorld("paper", 2);
    moveCamera(world, [0, 1.6, 0], 0, 0);
    const [x, y, z] = lightOf(world).position;
    moveCamera(world, [1, 1.7, -2], 0, 0);
    const moved = lightOf(world).position;
    expect(moved[0] - x).toBeCloseTo(1, 9);
    expect(moved[1] - y).toBeCloseTo(0.1, 9);
    expect(moved[2] - z).toBeCloseTo(-2, 9);
  });

  test("it moves with the particles while the candle stands", () => {
    const heights = lights(createWorld("paper", 2), 240).map(({ position }) => position[1]);
    expect(new Set(heights).size).toBeGreaterThan(200);
    expect(Math.max(...heights) - Math.min(...heights)).toBeLessThan(0.02);
  });

  test("it lags behind a walker", () => {
    const world = createWorld("paper", 2);
    moveCamera(world, [0, 1.6, 4], 0, 0);
    advance(world, { ...STILL, forward: 1, runs: true }, 1);
    expect(lightOf(world).position[2]).toBeGreaterThan(world.interpolated.flame[2] + 0.01);
  });
});

describe("what colour it has (L1)", () => {
  test("it is the paper's warm (2.0, 1.0, 0.5), whatever it flickers", () => {
    for (const { color } of lights(createWorld("paper", 1), 120)) {
      expect(color[0] / color[1]).toBeCloseTo(2, 9);
      expect(color[1] / color[2]).toBeCloseTo(2, 9);
    }
  });

  test("it falls off with distance, unless that is switched off", () => {
    const world = createWorld("paper", 1);
    expect(lightOf(world).attenuates).toBe(true);
    expect(candleLight(world, { ...ALL, attenuation: false }, false).attenuates).toBe(false);
  });
});

describe("how it goes out, and comes again", () => {
  test.each(["paper", "original"] as const)("%s: with its particles, not before", (look) => {
    const world = createWorld(look, 1);
    const { life } = sampleOf(world).layer;
    const most = lights(world, 60, ALL, true).at(-1)!.color[0];
    world.flame.extinguish();
    const shares = lights(world, 120, ALL, true).map(({ color }) => color[0] / most);
    // Of particles of all ages none is born any more: those left, and the life left of each.
    for (const [i, share] of shares.entries()) {
      const left = Math.max(1 - ((i + 1) * TICK) / life, 0) ** 2;
      expect(share).toBeGreaterThan(left - 0.05);
    }
    expect(shares.at(-1)).toBe(0);
    world.flame.light();
    const again = lights(world, 240, ALL, true).map(({ color }) => color[0] / most);
    const steps = again.map((share, i) => share - (again[i - 1] ?? 0));
    expect(Math.max(...steps)).toBeLessThan(0.05);
    expect(again.at(-1)).toBeCloseTo(1, 2);
  });
});

test.each(["paper", "original"] as const)(
  "%s: lit and put out quickly it does not flash",
  (look) => {
    for (const hertz of [2, 3, 4, 5, 7, 10]) {
      const world = createWorld(look, 1);
      const { flame } = world;
      const walls = [0.2, 0.5, 0.8, 1].map((wall) => ({ wall, meter: new FlashMeter(1, 1) }));
      for (let frame = 0; frame < 300; frame++) {
        const isOn = Math.floor((frame / 60) * 2 * hertz) % 2 === 0;
        if (isOn !== flame.isLit) (isOn ? flame.light : flame.extinguish).call(flame);
        advance(world, STILL, 1 / 60);
        const share = lightOf(world, true).color[0] / (look === "paper" ? 2 : 1.2);
        for (const { wall, meter } of walls) {
          const level = 255 * (wall * share) ** (1 / 2.2);
          meter.look([level, level, level, 255], frame / 60);
        }
      }
      for (const { wall, meter } of walls) {
        expect(Math.max(...Object.values(meter.worst)), `${hertz} Hz, ${wall}`).toBe(0);
      }
    }
  },
);

describe("how it flickers (L2)", () => {
  const SECONDS = 10; // whole periods of any frequency in tenths of a hertz
  const reds = lights(createWorld("paper", 1), SECONDS * 120).map(({ color }) => color[0]);
  const mean = reds.reduce((sum, red) => sum + red, 0) / reds.length;
  const swings = reds.map((red) => red / mean - 1);
  const amplitude = Math.max(...swings);

  test("it swings about its mean, as far up as down", () => {
    expect(mean).toBeCloseTo(2, 3);
    expect(amplitude).toBeGreaterThan(0.01);
    expect(amplitude).toBeCloseTo(-Math.min(...swings), 3);
  });

  test("it is a sine: the sum of its neighbours is proportional to each value", () => {
    const factors = swings
      .map((swing, i) => ({ swing, sum: (swings[i - 1] ?? 0) + (swings[i + 1] ?? 0), i }))
      .filter(({ swing, i }) => i > 0 && i < swings.length - 1 && Math.abs(swing) > amplitude / 4)
      .map(({ swing, sum }) => sum / swing);
    expect(factors.length).toBeGreaterThan(500);
    expect(Math.max(...factors) - Math.min(...factors)).toBeLessThan(1e-3);
    const hertz = Math.acos(factors[0]! / 2) / (2 * Math.PI * TICK);
    expect(hertz).toBeGreaterThan(0.5);
    expect(hertz).toBeLessThan(3);
  });

  test("it never swings as far as a flash of WCAG 2.3.1, a tenth of white", () => {
    expect(2 * amplitude).toBeLessThan(0.1);
  });

  test("it is at its mean at time 0, and follows time through any frame rate", () => {
    expect(lightOf(createWorld("paper", 1)).color).toEqual([2, 1, 0.5]);
    const coarse = createWorld("paper", 1);
    for (let i = 0; i < 30; i++) advance(coarse, STILL, 1 / 30);
    expect(lightOf(coarse).color[0]).toBeCloseTo(reds[119]!, 9);
  });

  test.each([
    ["the visitor asked for less motion", ALL, true],
    ["the feature is off", { ...ALL, flicker: false }, false],
  ])("it is steady where %s", (_, features, isStill) => {
    for (const { color } of lights(createWorld("paper", 1), 60, features, isStill)) {
      expect(color).toEqual([2, 1, 0.5]);
    }
  });
});

describe("the original's light (T2)", () => {
  const seen = lights(createWorld("original", 1), 120);

  test("is static", () => {
    expect(new Set(seen.map((light) => JSON.stringify(light))).size).toBe(1);
  });

  test("is white, as bright to the eye as the paper's", () => {
    const { color } = seen[0]!;
    expect(new Set(color).size).toBe(1);
    expect(luma(color) / luma([2, 1, 0.5])).toBeCloseTo(1, 1);
  });

  test("does not fall off with distance", () => {
    expect(seen[0]!.attenuates).toBe(false);
  });

  test("stays with the candle when the visitor walks away", () => {
    const world = createWorld("original", 1);
    const before = lightOf(world).position;
    advance(world, { ...STILL, forward: 1 }, 3);
    expect(lightOf(world).position).toEqual(before);
    expect(before[1]).toBeGreaterThan(world.emitter[1]);
  });
});
