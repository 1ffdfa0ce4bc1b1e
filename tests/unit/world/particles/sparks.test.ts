import { describe, expect, test } from "vitest";
import { advance } from "../../../../src/world/advance.ts";
import { hasSparks } from "../../../../src/world/particles/sparks.ts";
import { STILL } from "../../../../src/world/player/intent.ts";
import { TICK } from "../../../../src/world/timeline.ts";
import { createWorld } from "../../../support/world.ts";

const HOUR = 3600 / TICK;

/** First tick and length of every spit within a number of ticks. */
function spitsOf(seed: number, ticks = HOUR): { readonly tick: number; readonly lasts: number }[] {
  const spits = [];
  for (let tick = 0; tick < ticks; tick++) {
    if (!hasSparks(seed, tick)) continue;
    let lasts = 1;
    while (hasSparks(seed, tick + lasts)) lasts++;
    spits.push({ tick, lasts });
    tick += lasts;
  }
  return spits;
}

describe("sparks of a wick", () => {
  test("does so rarely, briefly, and by its seed's chance", () => {
    const spits = spitsOf(1);
    expect(spits.length).toBeGreaterThan(110);
    expect(spits.length).toBeLessThan(190);
    for (const { lasts } of spits) expect(lasts * TICK).toBeLessThanOrEqual(0.05);
    const gaps = spits.slice(1).map(({ tick }, i) => (tick - (spits[i]?.tick ?? 0)) * TICK);
    expect(Math.max(...gaps)).toBeGreaterThan(3 * Math.min(...gaps));
    expect(spitsOf(1, HOUR / 10)).toEqual(spits.filter(({ tick }) => tick < HOUR / 10));
    expect(spitsOf(2, HOUR / 10)).not.toEqual(spitsOf(1, HOUR / 10));
  });

  test("needs a flame that burns well, and a visitor who wants motion", () => {
    const seed = [...Array(99).keys()].find((seed) => (spitsOf(seed, 30)[0]?.tick ?? 0) > 0) ?? 0;
    const spits = (change: (world: ReturnType<typeof createWorld>) => void) => {
      const world = createWorld("physical", seed);
      change(world);
      let count = 0;
      for (let tick = 0; tick < 40; tick++) {
        advance(world, STILL, TICK);
        count += world.timeline.groups(world.timeline.tick - 1, "spark") > 0 ? 1 : 0;
      }
      return count;
    };
    expect(spits(() => {})).toBe(spitsOf(seed, 40)[0]?.lasts);
    expect(spits(({ flame }) => flame.extinguish())).toBe(0);
    expect(
      spits((world) => {
        world.sways = false;
      }),
    ).toBe(0);
  });
});
