import type { Page } from "playwright/test";
import {
  PAPER_LAYERS,
  type ParticleLayer,
  PHYSICAL_LAYERS,
  withCount,
} from "../../src/world/particles/particle-layer.ts";
import { graphicsErrors, recordContexts } from "../support/contexts.ts";
import type { Course } from "../support/kernel.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { openSources } from "../support/sources.ts";
import { expect, test } from "../support/test.ts";

type Kernel = typeof import("../support/kernel.ts");
const KERNEL = "/tests/support/kernel.ts";
/** Shader and twin round differently, by this much at most in any number of any particle. */
const TOLERANCE = 1e-4;

const [HAZE, CORE] = PAPER_LAYERS as [ParticleLayer, ParticleLayer];

function compareTwins(page: Page, course: Course) {
  return page.evaluate(
    async ({ module, course }) => {
      const { compareTwins }: Kernel = await import(module);
      return compareTwins(course);
    },
    { module: KERNEL, course },
  );
}

function compareLatecomer(page: Page, course: Course) {
  return page.evaluate(
    async ({ module, course }) => {
      const { compareLatecomer }: Kernel = await import(module);
      return compareLatecomer(course);
    },
    { module: KERNEL, course },
  );
}

test.describe("The shader and its twin on the CPU", () => {
  let page: Page;
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    await openSources(page);
  });
  test.afterAll(() => page.close());

  for (const layer of [CORE, HAZE]) {
    const { name, rate, life } = layer;
    const alive = rate * life;

    test(`agree on every particle of the ${name} after 240 steps in still air`, async () => {
      const { worst, most } = await compareTwins(page, { layer, ticks: 240, pace: [1] });
      expect(worst).toBeLessThan(TOLERANCE);
      expect(most).toBeGreaterThan(alive * 0.98);
      expect(most).toBeLessThan(alive * 1.02);
    });

    test(`agree on the ${name} carried through wind, however many ticks a pass takes`, async () => {
      for (const pace of [[1], [2], [8], [240], [1, 13, 5, 8, 40]]) {
        const course: Course = { layer, ticks: 240, pace, isCarried: true, wind: [3, 1, -2] };
        const { worst, most } = await compareTwins(page, course);
        expect(worst, `${pace} ticks`).toBeLessThan(TOLERANCE);
        expect(most).toBeGreaterThan(alive * 0.98);
      }
    });

    test(`agree on a ${name} that stays behind when the candle moves on`, async () => {
      const left = { ...layer, follow: 0, drag: 3 };
      const half = { ...layer, follow: 0.5, drag: 0.5 };
      for (const layer of [left, half]) {
        const { worst } = await compareTwins(page, {
          layer,
          ticks: 240,
          pace: [2, 3],
          isCarried: true,
          wind: [0.5, 0, 0.5],
        });
        expect(worst, `follow ${layer.follow}`).toBeLessThan(TOLERANCE);
      }
    });

    test(`agree on the ${name} while groups of it come and go with distance`, async () => {
      const groups = [
        { ticks: 100, count: 4 },
        { ticks: 190, count: 1 },
        { ticks: 30, count: 3 },
        { ticks: 200, count: 2 },
        { ticks: 230, count: 0 },
        { ticks: 11, count: 4 },
        { ticks: 191, count: 1 },
      ];
      for (const pace of [[1], [2], [8], [7, 30, 1]]) {
        const { worst, most, fewest } = await compareTwins(page, {
          layer,
          ticks: 1150,
          pace,
          groups,
        });
        expect(worst, `${pace} ticks`).toBeLessThan(TOLERANCE);
        expect(most).toBeGreaterThan(alive * 0.5);
        expect(fewest).toBe(0);
      }
    });

    test(`a ${name} simulated from a late start equals one simulated from the beginning`, async () => {
      const groups = [
        { ticks: 250, count: 4 },
        { ticks: 240, count: 1 },
        { ticks: 130, count: 3 },
      ];
      for (const ticks of [240, 500, 620]) {
        const { worst, most } = await compareLatecomer(page, {
          layer: { ...layer, follow: 0.3 },
          ticks,
          pace: [2, 1],
          isCarried: true,
          wind: [1, 0, 0],
          groups,
        });
        expect(worst, `after ${ticks} ticks`).toBe(0);
        expect(most).toBeGreaterThan(alive * 0.2);
      }
    });
  }

  test("agree on the dust of the room, and on the sparks of a wick", async () => {
    const alive: Readonly<Record<string, number>> = { dust: 120, spark: 5 };
    for (const layer of PHYSICAL_LAYERS) {
      const { worst, most, fewest } = await compareTwins(page, {
        layer,
        ticks: 360,
        pace: [2, 3],
        isCarried: true,
        wind: [4, 0, -3],
        groups: [
          { ticks: 4, count: 4 },
          { ticks: 116, count: 0 },
        ],
      });
      expect(worst, layer.name).toBeLessThan(10 * TOLERANCE); // a room is hundreds of units wide
      expect(most, layer.name).toBeGreaterThan((alive[layer.name] ?? 0) * 0.9);
      expect(most, layer.name).toBeLessThan((alive[layer.name] ?? 0) * 1.1 + 2);
      if (layer.source === "spark") expect(fewest).toBe(0);
    }
  });

  test("agree on 20,000 particles, of which many are born in every tick", async () => {
    for (const layer of withCount(PAPER_LAYERS, 20_000)) {
      const { worst, most } = await compareTwins(page, { layer, ticks: 240, pace: [60] });
      expect(worst).toBeLessThan(TOLERANCE);
      expect(most).toBeGreaterThan(5_000);
    }
  });

  test("agree on both layers while a visitor walks, puts the candle down and leaves it", async () => {
    for (const framesPerSecond of [30, 60, 144]) {
      const { worst, most, fewest } = await page.evaluate(
        async ({ module, framesPerSecond }) => {
          const { compareInRoom }: Kernel = await import(module);
          return compareInRoom(framesPerSecond);
        },
        { module: KERNEL, framesPerSecond },
      );
      expect(worst, `at ${framesPerSecond} Hz`).toBeLessThan(TOLERANCE);
      expect(most).toBeGreaterThan(350);
      expect(fewest).toBeLessThan(most);
    }
  });
});

// Their first moments are replayed, which takes a CPU its time; the bench has a million.
test("A hundred thousand particles burn without an error", async ({ page }) => {
  await recordContexts(page);
  const room = await new RoomDriver(page).open({ particles: "100000" }, { width: 64, height: 36 });
  await room.step(1 / 60, 2);
  expect((await room.stats()).particles).toBeGreaterThanOrEqual(100_000);
  expect(await graphicsErrors(page)).toEqual([]);
  expect(room.complaints).toEqual([]);
});
