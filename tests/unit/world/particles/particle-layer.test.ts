import { describe, expect, test } from "vitest";
import {
  GROUPS,
  ORIGINAL_LAYERS,
  PAPER_LAYERS,
  type ParticleLayer,
  withCount,
} from "../../../../src/world/particles/particle-layer.ts";
import { HISTORY, TICK } from "../../../../src/world/timeline.ts";

const layerOf = (layers: readonly ParticleLayer[], name: ParticleLayer["name"]) => {
  const layer = layers.find((candidate) => candidate.name === name);
  if (!layer) throw new Error(`no layer ${name}`);
  return layer;
};
const alive = (layers: readonly ParticleLayer[]) =>
  layers.reduce((sum, { rate, life }) => sum + rate * life, 0);
const glowingArea = ({ rate, life, size }: ParticleLayer) => rate * life * size ** 2;

// Of 720, the core's 420 fill its groups without remainder.
const COUNTS = [1, 7, 720, 800, 10_000, 100_000, 1_000_000];
const layerSets = [
  ["the paper", PAPER_LAYERS],
  ["the original", ORIGINAL_LAYERS],
  ...COUNTS.map((count) => [`${count} particles`, withCount(PAPER_LAYERS, count)] as const),
] as const;

describe("the paper's flame (P1, P2, P3)", () => {
  test("has a core and a haze, and nothing else", () => {
    expect(PAPER_LAYERS.map(({ name }) => name).toSorted()).toEqual(["core", "haze"]);
  });

  test("has a core of 500 at most, 300 a second, small, fast and short-lived", () => {
    expect(layerOf(PAPER_LAYERS, "core")).toMatchObject({
      capacity: 500,
      rate: 300,
      spawnRadius: 0.01,
      speed: [1.0, 1.5],
      life: 0.7,
    });
  });

  test("has a haze of 300 at most, 100 a second, wide, slow and long-lived", () => {
    expect(layerOf(PAPER_LAYERS, "haze")).toMatchObject({
      capacity: 300,
      rate: 100,
      spawnRadius: 0.05,
      speed: [0.5, 1.0],
      life: 1.5,
    });
  });

  test.each(PAPER_LAYERS)("drifts, rises and leaves the wick as published: $name", (layer) => {
    expect(layer).toMatchObject({ sideSpeed: 0.05, buoyancy: 0.5, drift: 0.1, follow: 1 });
  });

  test("has a haze of larger particles than its core", () => {
    expect(layerOf(PAPER_LAYERS, "haze").size).toBeGreaterThan(layerOf(PAPER_LAYERS, "core").size);
  });
});

test("the original is one layer with one speed and neither buoyancy nor drift", () => {
  expect(ORIGINAL_LAYERS).toHaveLength(1);
  const [layer] = ORIGINAL_LAYERS;
  expect(layer?.speed[0]).toBe(layer?.speed[1]);
  expect(layer).toMatchObject({ buoyancy: 0, drift: 0 });
});

describe.each(layerSets)("slots of %s", (_, layers) => {
  test.each(layers)("divide evenly among the groups: $name", ({ capacity }) => {
    expect(capacity % GROUPS).toBe(0);
    expect(capacity).toBeGreaterThan(0);
  });

  test.each(layers)("outnumber the particles that can be alive: $name", (layer) => {
    expect(layer.capacity).toBeGreaterThanOrEqual(layer.rate * layer.life + 1);
  });

  test.each(layers)("are remembered for longer than a life: $name", ({ life }) => {
    expect(HISTORY * TICK).toBeGreaterThan(life + TICK);
  });
});

describe.each(COUNTS)("a flame of %i particles", (count) => {
  const layers = withCount(PAPER_LAYERS, count);

  test("keeps that many alive", () => {
    expect(alive(layers)).toBeCloseTo(count, 6);
  });

  test("shares them among its layers as the paper does", () => {
    const share = (all: readonly ParticleLayer[]) => alive([layerOf(all, "core")]) / alive(all);
    expect(share(layers)).toBeCloseTo(share(PAPER_LAYERS), 9);
  });

  test.each(PAPER_LAYERS)("glows over the same area: $name", (layer) => {
    expect(glowingArea(layerOf(layers, layer.name))).toBeCloseTo(glowingArea(layer), 9);
  });

  test.each(PAPER_LAYERS)("moves as ever: $name", (layer) => {
    const { capacity, rate, size, ...motion } = layerOf(layers, layer.name);
    expect(layer).toMatchObject(motion);
    expect([capacity, rate, size].every((number) => number > 0)).toBe(true);
  });
});
