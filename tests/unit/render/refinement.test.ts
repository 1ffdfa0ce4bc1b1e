import { describe, expect, test } from "vitest";
import type { FrameSettings } from "../../../src/render/frame-settings.js";
import { RefinementBudget } from "../../../src/render/refinement/refinement-budget.js";
import { tilesAround } from "../../../src/render/refinement/tiles.js";
import type { Renderer } from "../../../src/render/renderer.js";
import { Refinement } from "../../../src/scenes/refinement.js";
import type { ViewSubject } from "../../../src/scenes/view-subject.js";
import { partsOf } from "../../support/refinement-parts.ts";

const SIZE = { width: 853, height: 481 };

describe("Tiles of a refined picture", () => {
  const tiles = tilesAround(SIZE, [0.7, 0.4], 64);

  test("are each pixel of it, once", () => {
    const count = new Uint8Array(SIZE.width * SIZE.height);
    for (const [x, y, width, height] of tiles) {
      for (let row = y; row < y + height; row++) {
        for (let column = x; column < x + width; column++) count[row * SIZE.width + column]!++;
      }
    }
    expect(count.every((times) => times === 1)).toBe(true);
  });

  test("come in the order of their distance from the flame", () => {
    const [first] = tiles;
    expect(first).toEqual([576, 192, 64, 64]);
    const distances = tiles.map(([x, y, width, height]) =>
      Math.hypot(x + width / 2 - 0.7 * SIZE.width, y + height / 2 - 0.4 * SIZE.height),
    );
    expect(distances).toEqual(distances.toSorted((a, b) => a - b));
  });

  test("may be around a flame that is out of sight", () => {
    expect(tilesAround(SIZE, [-2, 9], 64)).toHaveLength(tiles.length);
  });
});

describe("The budget of a refinement", () => {
  const stepsAt = (seconds: number, frames: number, budget = new RefinementBudget()) => {
    let steps = 0;
    for (let frame = 0; frame < frames; frame++) {
      budget.take(seconds);
      steps += budget.next();
    }
    return steps;
  };

  test("grows while frames are in time, and is bounded", () => {
    expect(stepsAt(1 / 60, 10)).toBeGreaterThan(15);
    const budget = new RefinementBudget();
    stepsAt(1 / 60, 1000, budget);
    budget.take(1 / 60);
    expect(budget.next()).toBeLessThanOrEqual(65);
  });

  test("shrinks with late frames, the later the more, and never ends", () => {
    const busy = () => {
      const budget = new RefinementBudget();
      stepsAt(1 / 60, 30, budget);
      return budget;
    };
    expect(stepsAt(0.2, 3, busy())).toBeLessThan(stepsAt(0.06, 3, busy()));
    const slow = stepsAt(0.4, 80);
    expect(slow).toBeGreaterThanOrEqual(10);
    expect(slow).toBeLessThanOrEqual(12);
  });

  test("is the same for the same times", () => {
    const times = [0.016, 0.05, 0.07, 0.033, 0.2, 0.05, 0.05, 0.017];
    const run = () => {
      const budget = new RefinementBudget();
      return times.map((seconds) => {
        budget.take(seconds);
        return budget.next();
      });
    };
    expect(run()).toEqual(run());
  });
});

test("Frames beside which a refinement is prepared do not count for the coarse image, and those in motion do", async () => {
  let isPrepared = false;
  let compiled = () => {};
  const renderer = { setLayers: () => {} } as unknown as Renderer;
  const whenCompiled = () => new Promise<void>((resolve) => (compiled = resolve));
  const refinement = new Refinement(partsOf(renderer, whenCompiled, () => isPrepared));
  const rest = () => {
    refinement.take(0.1);
    refinement.advance(
      { world: { flame: { glow: 1 }, standing: [], moon: null } } as unknown as ViewSubject,
      {} as FrameSettings,
      renderer,
      SIZE,
    );
    return refinement.isBusy;
  };
  expect(refinement.isBusy).toBe(false);
  expect(rest(), "prepared").toBe(true);
  isPrepared = true;
  expect([rest(), rest()], "compiled").toEqual([true, true]);
  refinement.stop();
  expect(refinement.isBusy, "in motion").toBe(false);
  compiled();
  await new Promise((resolve) => setTimeout(resolve));
  expect(rest(), "before it begins").toBe(false);
});

test("The surfaces that it begins with are drawn while its renderer is made, once the camera has rested", () => {
  let bands = 0;
  const fill = (function* () {
    for (; bands < 3; bands++) yield;
  })();
  const coarse = { initialImage: () => ({ fill }) } as unknown as Renderer;
  const refinement = new Refinement(partsOf(coarse, undefined, () => false));
  const world = { flame: { glow: 1 }, standing: [], moon: null };
  const bandsAfter = Array.from({ length: 20 }, () => {
    refinement.take(0.05);
    refinement.advance({ world } as unknown as ViewSubject, {} as FrameSettings, coarse, SIZE);
    return bands;
  });
  expect(bandsAfter[0]).toBe(0);
  expect(bandsAfter.at(-1)).toBe(3);
});
