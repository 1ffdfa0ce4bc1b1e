import { describe, expect, test } from "vitest";
import { GROUPS, type ParticleLayer } from "../../../../src/world/particles/particle-layer.ts";
import { Particles } from "../../../../src/world/particles/particles.ts";
import { HISTORY, TICK, Timeline } from "../../../../src/world/timeline.ts";
import { alive, all, burning, CORE, HAZE, KEY, oneTick, pass } from "../burning.ts";

describe("a particle's motion (P3)", () => {
  test("gains 0.5 m/s upward each second, whatever the air does sideways", () => {
    for (const [before, after] of oneTick(CORE, { wind: [3, 5, -2] })) {
      expect(after.velocity[1] - before.velocity[1]).toBeCloseTo(0.5 * TICK, 6);
    }
    const { timeline, particles } = burning(CORE);
    const young = alive(particles).filter(({ age }) => age < 0.15);
    pass(timeline, 60);
    particles.follow(timeline);
    const later = all(particles);
    expect(young.length).toBeGreaterThan(30);
    for (const { slot, velocity } of young) {
      expect(later[slot]!.velocity[1] - velocity[1]).toBeCloseTo(0.5 * 60 * TICK, 5);
    }
  });

  test("integrates its velocity", () => {
    const pairs = oneTick(CORE);
    expect(pairs.length).toBeGreaterThan(200);
    for (const [before, after] of pairs) {
      for (const axis of [0, 1, 2] as const) {
        const way = after.position[axis] - before.position[axis];
        expect(way).toBeCloseTo(after.velocity[axis] * TICK, 6);
      }
    }
  });

  test("uses up its life second by second", () => {
    for (const [before, after] of oneTick(HAZE)) {
      expect(before.remaining - after.remaining).toBeCloseTo(TICK, 6);
    }
  });

  test("drifts by a random walk of its velocity, a tick's step never beyond drift times dt", () => {
    const steps = oneTick({ ...CORE, drag: 0 }).flatMap(([before, after]) => [
      after.velocity[0] - before.velocity[0],
      after.velocity[2] - before.velocity[2],
    ]);
    const largest = CORE.drift * TICK;
    const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;
    const square = steps.reduce((sum, step) => sum + step ** 2, 0) / steps.length;
    for (const step of steps) expect(Math.abs(step)).toBeLessThanOrEqual(largest + 1e-7);
    // Uniform in ±largest: the mean square is a third of its square.
    expect(Math.abs(mean)).toBeLessThan(largest * 0.1);
    expect(square / largest ** 2).toBeCloseTo(1 / 3, 1);
  });

  test("drifts by far less than drift times t over its life, as a walk without memory does", () => {
    const layer = { ...CORE, drag: 0, sideSpeed: 0 };
    const drifts = alive(burning(layer).particles).filter(({ age }) => age > 0.35);
    expect(drifts.length).toBeGreaterThan(80);
    let ratio = 0;
    for (const { velocity, age } of drifts) {
      expect(Math.hypot(velocity[0], velocity[2])).toBeLessThanOrEqual(
        CORE.drift * age * Math.SQRT2,
      );
      const ticks = Math.round(age / TICK);
      const expected = (2 / 3) * ticks * (CORE.drift * TICK) ** 2;
      ratio += (velocity[0] ** 2 + velocity[2] ** 2) / expected / drifts.length;
    }
    expect(ratio).toBeGreaterThan(0.6);
    expect(ratio).toBeLessThan(1.5);
  });

  test("goes straight where the layer has no drift", () => {
    for (const [before, after] of oneTick({ ...CORE, drift: 0, drag: 0 })) {
      expect(after.velocity[0]).toBe(before.velocity[0]);
      expect(after.velocity[2]).toBe(before.velocity[2]);
    }
  });

  test("leaves a dead particle as it is, until it is born again", () => {
    const { timeline, particles } = burning(CORE);
    const dead = all(particles).filter(({ remaining }) => remaining <= 0);
    pass(timeline, 20, { groups: 0 });
    particles.follow(timeline);
    const later = all(particles);
    expect(dead.length).toBeGreaterThan(200);
    for (const particle of dead) expect(later[particle.slot]).toEqual(particle);
  });

  test("lets every particle die within a life once nothing is born", () => {
    const { timeline, particles } = burning(HAZE);
    pass(timeline, Math.ceil(HAZE.life / TICK) + 1, { groups: 0 });
    particles.follow(timeline);
    expect(alive(particles)).toHaveLength(0);
  });
});

describe("wind and the emitter's way", () => {
  const still = { ...CORE, drift: 0, sideSpeed: 0 };

  test.each([0.12, 1, 20])(
    "drag of %d/s brings the velocity to the wind's, exponentially",
    (drag) => {
      const layer = { ...still, drag };
      const timeline = new Timeline(0);
      const particles = new Particles(layer, KEY);
      pass(timeline, HISTORY, { wind: [2, 0, -1] });
      particles.follow(timeline);
      const some = alive(particles).filter(({ age }) => age > TICK);
      expect(some.length).toBeGreaterThan(200);
      for (const { velocity, age } of some) {
        // Air is felt from the first whole tick on.
        const share = 1 - Math.exp(-drag * TICK * Math.floor(age / TICK + 1e-4));
        expect(velocity[0]).toBeCloseTo(2 * share, 4);
        expect(velocity[2]).toBeCloseTo(-share, 4);
      }
    },
  );

  test("a layer without drag takes no notice of wind", () => {
    for (const { velocity } of alive(burning({ ...still, drag: 0 }).particles)) {
      expect([velocity[0], velocity[2]].map(Math.abs)).toEqual([0, 0]);
    }
    for (const [before, after] of oneTick({ ...still, drag: 0 }, { wind: [9, 9, 9] })) {
      expect(after.velocity[0] - before.velocity[0]).toBe(0);
    }
  });

  const way = [0.01, -0.02, 0.03] as const;

  test("what stays behind feels the room's wind, however fast the emitter is carried", () => {
    // Still air: the emitter feels its own way as a wind.
    const felt = [-way[0] / TICK, 0, -way[2] / TICK] as const;
    const layer = { ...CORE, follow: 0, drift: 0, drag: 2 };
    for (const [before, after] of oneTick(layer, { way, wind: felt })) {
      for (const axis of [0, 2] as const) {
        const kept = before.velocity[axis] * Math.exp(-layer.drag * TICK);
        expect(after.velocity[axis]).toBeCloseTo(kept, 6);
      }
    }
  });

  test("what stays behind lies evenly along the emitter's way, not in a heap for each tick", () => {
    const layer = {
      ...CORE,
      rate: 480,
      capacity: 1000,
      spawnRadius: 0,
      sideSpeed: 0,
      drift: 0,
      drag: 0,
      follow: 0,
    };
    const timeline = new Timeline(0);
    const particles = new Particles(layer, KEY);
    pass(timeline, 12, { way: [0.04, 0, 0] });
    particles.follow(timeline);
    const places = alive(particles).map(({ position }) => position[0]);
    places.sort((a, b) => a - b);
    for (const [i, place] of places.entries()) {
      if (i > 0) expect(place - (places[i - 1] ?? 0)).toBeCloseTo(0.01, 5);
    }
    expect(places.length).toBeGreaterThan(40);
  });

  test("particles that follow ride with the emitter", () => {
    for (const [before, after] of oneTick({ ...CORE, follow: 1 }, { way })) {
      for (const axis of [0, 1, 2] as const) {
        const moved = after.position[axis] - before.position[axis];
        expect(moved).toBeCloseTo(after.velocity[axis] * TICK, 6);
      }
    }
  });

  test.each([0, 0.25])("particles that follow by %d leave the rest of the way behind", (follow) => {
    const pairs = oneTick({ ...CORE, follow }, { way });
    expect(pairs.length).toBeGreaterThan(200);
    for (const [before, after] of pairs) {
      for (const axis of [0, 1, 2] as const) {
        // Seen from the room: the emitter's way and its own.
        const moved = after.position[axis] - before.position[axis] + way[axis];
        expect(moved).toBeCloseTo(after.velocity[axis] * TICK + follow * way[axis], 6);
      }
    }
  });
});

describe("groups", () => {
  const groupOf = ({ capacity }: ParticleLayer, slot: number) =>
    Math.floor(slot / (capacity / GROUPS));

  test.each([CORE, HAZE])("share the living evenly: $name", (layer) => {
    const counts = new Array<number>(GROUPS).fill(0);
    for (const { slot } of alive(burning(layer).particles)) counts[groupOf(layer, slot)]!++;
    const mean = (layer.rate * layer.life) / GROUPS;
    for (const count of counts) expect(Math.abs(count - mean)).toBeLessThanOrEqual(1);
  });

  test.each([1, 2, 3])("%i alone bear particles when only they may (F4)", (groups) => {
    const { timeline, particles } = burning(CORE);
    pass(timeline, 120, { groups });
    particles.follow(timeline);
    const living = alive(particles);
    for (const { slot } of living) expect(groupOf(CORE, slot)).toBeLessThan(groups);
    expect(Math.abs(living.length - (210 * groups) / GROUPS)).toBeLessThanOrEqual(2);
  });

  test("of a sample are the first slots of the whole layer", () => {
    const { timeline, particles } = burning(CORE);
    const sample = new Particles(CORE, KEY, CORE.capacity / GROUPS);
    sample.follow(timeline);
    expect(sample.state).toEqual(particles.state.subarray(0, sample.state.length));
  });
});
