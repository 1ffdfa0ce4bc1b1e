import { beforeAll, describe, expect, test } from "vitest";
import { advance } from "../../../../src/world/advance.ts";
import { createPlume } from "../../../../src/world/air/plume.ts";
import { blow } from "../../../../src/world/commands.ts";
import { LINES, ROWS, SMOKE_FLOATS, type Smoke } from "../../../../src/world/particles/smoke.ts";
import { STILL } from "../../../../src/world/player/intent.ts";
import type { World } from "../../../../src/world/world.ts";
import { LONE_CANDLE_SETUP } from "../../../../src/world/world-setup.ts";
import { createWorld } from "../../../support/world.ts";

/** A room where people live: 5 cm/s, moderately uneven. */
const DRAUGHT = { speed: 0.05, direction: 1, gustiness: 0.5 };

function smokeOf({ plume }: World): Smoke {
  if (!plume) throw new Error("The paper's flame heats no air.");
  return plume.smoke;
}

/** Middle of a row, the youngest is 0: x, y, z from the foot of the flame, metres. */
function middle(world: World, age: number): [number, number, number] {
  const { parcels, newest } = smokeOf(world);
  const row = (newest - age + ROWS) % ROWS;
  const sum: [number, number, number] = [0, 0, 0];
  for (let line = 0; line < LINES; line++) {
    for (const axis of [0, 1, 2] as const) {
      sum[axis] += (parcels[(row * LINES + line) * SMOKE_FLOATS + axis] ?? 0) / LINES;
    }
  }
  for (const axis of [0, 1, 2] as const) sum[axis] -= world.emitter[axis];
  return sum;
}

/** Height up to which the smoke rises: there it turns aside by more than 45 degrees, 2 cm from its wick. */
function laminarLength(world: World): number {
  const { count } = smokeOf(world);
  for (let age = 4; age < count; age++) {
    const [x, y, z] = middle(world, age);
    const [bx, by, bz] = middle(world, age - 4);
    if (y > 0.02 && Math.hypot(x - bx, z - bz) > y - by) return y;
  }
  return middle(world, count - 1)[1];
}

/** Extinction's cross-section of all smoke in the air, m². */
function amount(world: World): number {
  const { parcels, count, newest } = smokeOf(world);
  let sum = 0;
  for (let age = 1; age < count; age++) {
    const row = (newest - age + ROWS) % ROWS;
    for (let line = 0; line < LINES; line++) {
      const at = (row * LINES + line) * SMOKE_FLOATS;
      const next = (((row + 1) % ROWS) * LINES + line) * SMOKE_FLOATS;
      const way = [0, 1, 2].map((axis) => (parcels[at + axis] ?? 0) - (parcels[next + axis] ?? 0));
      sum += (parcels[at + 3] ?? 0) * Math.hypot(...way);
    }
  }
  return sum;
}

describe("smoke after the flame is out", () => {
  const lengths: number[] = [];
  const amounts: number[] = [];
  let speed = 0;
  let world: World;
  beforeAll(() => {
    world = createWorld("physical", 1, { wind: DRAUGHT, createPlume });
    advance(world, STILL, 0.5);
    expect(smokeOf(world).count).toBe(0);
    world.flame.extinguish();
    for (let second = 1; second <= 20; second++) {
      advance(world, STILL, 1);
      amounts.push(amount(world));
      if (second >= 2 && second <= 6) lengths.push(laminarLength(world));
      if (second !== 2) continue;
      // How long the parcels that are at 10 cm took from 5 cm.
      let low = 0;
      while (middle(world, low)[1] < 0.05) low++;
      let high = low;
      while (middle(world, high)[1] < 0.1) high++;
      speed = 0.05 / ((high - low) / 60);
    }
  }, 60_000);

  test("rises at 0.15 to 0.45 m/s, 5 to 10 cm above the wick", () => {
    expect(speed).toBeGreaterThan(0.15);
    expect(speed).toBeLessThan(0.45);
  });

  test("rises straight for 8 to 25 cm, then curls", () => {
    const median = lengths.toSorted((a, b) => a - b)[2] ?? 0;
    expect(median, String(lengths)).toBeGreaterThan(0.08);
    expect(median, String(lengths)).toBeLessThan(0.25);
  });

  test("is strongest in the first seconds, and gone after twenty", () => {
    const strongest = amounts.indexOf(Math.max(...amounts));
    expect(strongest, String(amounts)).toBeLessThan(5);
    expect(amounts[5]).toBeGreaterThan(0);
    expect(amounts[19]).toBe(0);
    expect(smokeOf(world).count).toBe(0);
  });

  test("lights at once where it still is hot, and the flame grows through it", () => {
    const lightAgain = (again: World, out: number) => {
      again.flame.extinguish();
      advance(again, STILL, out);
      const { count } = smokeOf(again);
      again.flame.light();
      let seconds = 0;
      while (again.flame.fuel < 0.5) {
        advance(again, STILL, 1 / 60);
        seconds += 1 / 60;
      }
      return { count, seconds, left: smokeOf(again).count };
    };
    const atOnce = lightAgain(createWorld("physical", 1, { wind: DRAUGHT, createPlume }), 0.3);
    const later = lightAgain(
      createWorld("physical", 1, { wind: DRAUGHT, isLit: false, createPlume }),
      0,
    );
    expect(atOnce.count).toBeGreaterThan(0);
    expect(atOnce.left, "what has risen goes on").toBeGreaterThan(atOnce.count);
    expect(later.left).toBe(0);
    expect(atOnce.seconds).toBeLessThan(0.8 * later.seconds);
    expect(later.seconds).toBeLessThan(1.5);
  });

  test("thins out where the flame is lit again, rather than be cut", () => {
    const again = createWorld("physical", 1, { wind: DRAUGHT, createPlume });
    again.flame.extinguish();
    advance(again, STILL, 1);
    const strengths = [smokeOf(again).strength];
    again.flame.light();
    for (let step = 0; step < 18; step++) {
      advance(again, STILL, 1 / 60);
      strengths.push(smokeOf(again).isFed ? smokeOf(again).strength : 0);
    }
    const cut = strengths.map((strength, i) => (strengths[i - 1] ?? strength) - strength);
    expect(Math.max(...cut), String(strengths)).toBeLessThan(0.4 * (strengths[0] ?? 0));
    expect(strengths.at(-1)).toBe(0);
  });

  test("spreads in a breath as what a turbulent jet carries does, and hardly shows before it is over", () => {
    const blown = createWorld("physical", 1, { setup: LONE_CANDLE_SETUP, createPlume });
    blow(blown, 1);
    advance(blown, STILL, 0.4);
    const { parcels, newest } = smokeOf(blown);
    const way = Math.hypot(...[0, 1, 2].map((axis) => middle(blown, 3)[axis] ?? 0));
    const breadth = parcels[((newest - 3 + ROWS) % ROWS) * LINES * SMOKE_FLOATS + 4] ?? 0;
    expect(way).toBeGreaterThan(0.2);
    expect(breadth / way).toBeGreaterThan(0.04);
    expect(breadth / way).toBeLessThan(0.09);
    const during = amount(blown);
    advance(blown, STILL, 0.6);
    expect(amount(blown)).toBeGreaterThan(10 * during);
  });

  test("is the same in a copy, which goes on alike", () => {
    const again = createWorld("physical", 1, { setup: LONE_CANDLE_SETUP, createPlume });
    blow(again, 1);
    advance(again, STILL, 0.4);
    const other = again.plume?.clone();
    expect(other?.smoke).toEqual(again.plume?.smoke);
    for (const plume of [again.plume, other]) plume?.step(again.flame, again.emitter, again.air);
    expect(other?.smoke.parcels).toEqual(again.plume?.smoke.parcels);
  });

  test("is the same for the same seed, whatever the frame rate", () => {
    const after = (rate: number) => {
      const again = createWorld("physical", 1, { wind: DRAUGHT, createPlume });
      again.flame.extinguish();
      for (let frame = 0; frame < rate; frame++) advance(again, STILL, 1 / rate);
      return Array.from(smokeOf(again).parcels);
    };
    const once = after(60);
    expect(after(20)).toEqual(once);
    expect(once.some((value) => value !== 0)).toBe(true);
  });

  test("is no business of the paper's looks", () => {
    expect(createWorld("paper", 1, { createPlume }).plume).toBeNull();
    expect(createWorld("original", 1, { createPlume }).plume).toBeNull();
  });
});
