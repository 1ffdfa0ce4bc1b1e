import { describe, expect, test } from "vitest";
import { GROUPS, PAPER_LAYERS, withCount } from "../../../src/world/particles/particle-layer.ts";
import { layerKey, Particles } from "../../../src/world/particles/particles.ts";
import { HISTORY, TICK, Timeline } from "../../../src/world/timeline.ts";
import { chance } from "../chance.ts";
import { alive, burning, CORE, HAZE, KEY } from "./burning.ts";

describe("a flame is a pure function of the timeline's memory", () => {
  /** Walks the emitter about: wind, way and groups differ in every tick. */
  function stroll(timeline: Timeline, ticks: number): void {
    const between = chance(timeline.tick + 9999);
    for (let i = 0; i < ticks; i++) {
      const way = [between(-0.1, 0.1), between(-0.01, 0.01), between(-0.1, 0.1)];
      timeline.record(
        way,
        way.map((length) => -length / TICK),
        Math.floor(between(1, GROUPS + 1)),
      );
    }
  }

  const layers = [CORE, HAZE, { ...HAZE, follow: 0, drag: 2 }, ...withCount(PAPER_LAYERS, 3000)];

  test.each(layers)("one seen late is one seen all along: $name of $capacity", (layer) => {
    const timeline = new Timeline(-HISTORY);
    const faithful = new Particles(layer, KEY);
    for (let i = 0; i < 500; i++) {
      stroll(timeline, 1);
      faithful.follow(timeline);
    }
    const late = new Particles(layer, KEY);
    late.follow(timeline);
    expect(alive(late).length).toBeGreaterThan(layer.rate * layer.life * 0.3);
    expect(alive(late)).toEqual(alive(faithful));
  });

  test("one that looked away for longer than the memory catches up", () => {
    const timeline = new Timeline(0);
    const napping = new Particles(CORE, KEY);
    stroll(timeline, 300);
    napping.follow(timeline);
    stroll(timeline, 10 * HISTORY);
    napping.follow(timeline);
    const late = new Particles(CORE, KEY);
    late.follow(timeline);
    expect(alive(late)).toEqual(alive(napping));
  });

  test("in steps of one tick or of many, the particles are the same", () => {
    const timeline = new Timeline(0);
    const often = new Particles(HAZE, KEY);
    const seldom = new Particles(HAZE, KEY);
    for (let i = 0; i < 240; i++) {
      stroll(timeline, 1);
      often.follow(timeline);
      if (i % 8 === 7) seldom.follow(timeline);
    }
    expect(seldom.state).toEqual(often.state);
  });

  test("following twice changes nothing", () => {
    const { timeline, particles } = burning(CORE);
    const before = particles.state.slice();
    particles.follow(timeline);
    expect(particles.state).toEqual(before);
  });

  test("another seed or another layer is another flame", () => {
    expect(new Set([layerKey(1, 0), layerKey(1, 1), layerKey(2, 0), layerKey(2, 1)]).size).toBe(4);
    const other = burning(CORE, HISTORY, layerKey(2, 0)).particles.state;
    expect(other).not.toEqual(burning(CORE).particles.state);
    expect(burning(CORE).particles.state).toEqual(burning(CORE).particles.state);
  });

  test("no seed is out of range", () => {
    for (const seed of [0, 1, 0x7fffffff, 0xffffffff]) {
      const { particles } = burning(CORE, HISTORY, layerKey(seed, 1));
      expect(particles.state.every(Number.isFinite)).toBe(true);
    }
  });
});
