import { expect, test, vi } from "vitest";
import { carriedFlame, flameReport } from "../../../src/light/flame-light.ts";
import { advance } from "../../../src/world/advance.ts";
import { createPlume, Plume } from "../../../src/world/air/plume.ts";
import { createWorldInSteps, type WorldOptions } from "../../../src/world/create-world.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import type { World } from "../../../src/world/world.ts";
import { createWorld } from "../../support/world.ts";

const WIND = { speed: 0.4, direction: 1, gustiness: 0.6 };

function stepsOfPlume(run: () => World): { world: World; steps: number } {
  const step = vi.spyOn(Plume.prototype, "step");
  try {
    return { world: run(), steps: step.mock.calls.length };
  } finally {
    step.mockRestore();
  }
}

const made = (options: WorldOptions, seed = 5) =>
  stepsOfPlume(() => createWorld("physical", seed, { createPlume, ...options }));

/** The air around the flame and the smoke, after it burned, and went out. */
function after(world: World) {
  advance(world, { ...STILL, forward: 1 }, 0.3);
  advance(world, { ...STILL, togglesFlame: true }, 0.7);
  const { solver, smoke } = world.plume ?? expect.fail("There is no plume.");
  const { velocities, heat, origin } = solver;
  return { velocities, heat, origin, parcels: smoke.parcels, count: smoke.count };
}

test("a world made alike takes over the plume, and goes on as one whose plume rose in it", () => {
  made({}, 6); // another is the last one
  const first = made({ wind: WIND });
  const second = made({ wind: WIND });
  expect(first.steps).toBe(30);
  expect(second.steps).toBe(0);
  advance(first.world, STILL, 0.1); // what it kept is not its own
  const third = made({ wind: WIND });
  advance(second.world, STILL, 0.1);
  advance(third.world, STILL, 0.1);
  const [a, b, c] = [first, second, third].map(({ world }) => after(world));
  expect(a?.count).toBeGreaterThan(0);
  expect(b).toEqual(a);
  expect(c).toEqual(a);
});

test.each<[name: string, options: WorldOptions, seed?: number]>([
  ["wind", { wind: { ...WIND, direction: 2 } }],
  ["wick", { wick: 0.003 }],
  ["age", { age: 100 }],
  ["flame", { isLit: false }],
  ["seed", {}, 7],
])("another %s has its own plume", (_, options, seed) => {
  made({ wind: WIND });
  expect(made({ wind: WIND, ...options }, seed).steps).toBe(30);
});

test("a world is made in steps of at most one of its plume's", () => {
  made({}, 6);
  const step = vi.spyOn(Plume.prototype, "step");
  const steps = createWorldInSteps("physical", 5, { createPlume });
  const counts: number[] = [];
  for (let next = steps.next(); !next.done; next = steps.next()) {
    counts.push(step.mock.calls.length);
    step.mockClear();
  }
  step.mockRestore();
  expect(counts.length).toBeGreaterThan(30);
  expect(Math.max(...counts)).toBe(1);
});

test("where nothing sways, the flame of a new world stands as it goes on to, whatever the seed", () => {
  for (const seed of [1, 2, 3]) {
    const { world } = made({ sways: false, wind: WIND }, seed);
    const { tilt } = flameReport(carriedFlame(world));
    expect(tilt).toBeCloseTo(0, 9);
    advance(world, STILL, 0.5);
    expect(flameReport(carriedFlame(world)).tilt).toBeCloseTo(0, 9);
  }
});
