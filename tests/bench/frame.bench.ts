import { expect, type Page, type TestInfo, test } from "playwright/test";
import { ORIGINS } from "../support/browser.ts";
import type { Cell } from "./law.ts";
import type { TierName } from "./passes.ts";
import type { Effort } from "./scaling.ts";

/** Most that our frame may cost, to the transform feedback control's. */
const MOST_RATIO = 1.15;
/** Most that our script may take of the main thread in a frame, in milliseconds. */
const MOST_SCRIPT = 0.1;
/** How far the peers' pictures may differ in covered pixels and in light, if they draw the same. */
const TOLERANCE = 0.04;

const EFFORT: Readonly<Record<number, Effort>> = {
  800: { rounds: 60, frames: 10 },
  10000: { rounds: 40, frames: 3 },
  100000: { rounds: 16, frames: 1 },
  1000000: { rounds: 5, frames: 1 },
};

const CELLS: readonly Cell[] = [2, 15].flatMap((pixels) =>
  Object.keys(EFFORT).map((count) => ({ count: Number(count), pixels })),
);

async function open(page: Page): Promise<void> {
  await page.goto(ORIGINS.bench);
  await page.waitForFunction(() => "bench" in window);
  expect(await page.evaluate(() => crossOriginIsolated)).toBe(true);
}

function sum(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0);
}

async function report(info: TestInfo, name: string, result: unknown): Promise<void> {
  await info.attach(name, { body: JSON.stringify(result), contentType: "application/json" });
}

test("the paper's features cost something, and all of them together less than they cost it", async ({
  page,
  browser,
}, info) => {
  await open(page);
  const ladder = await page.evaluate(() => window.bench.measureLadder(12));
  await report(info, "ladder", { browser: browser.version(), ...ladder });
  expect([ladder.width, ladder.height]).toEqual([800, 600]);
  expect(ladder.particles).toBeGreaterThan(0);
  const last = ladder.steps.at(-1);
  expect(last?.multiple).toBeGreaterThan(1);
  expect(last?.multiple).toBeLessThan(last?.paperMultiple ?? 0);
});

/** Rounds by tier: the dearer the frame, the fewer. */
const PASS_ROUNDS: Readonly<Record<TierName, number>> = { low: 12, medium: 3, high: 2, ultra: 2 };
/** Most copies that a frame at low may cost: 24 make 24 frames a second on two cores without a GPU. */
const MOST_COPIES = { stands: 16, walks: 24, smokes: 16 };
/** Most copies of what burns and rises in it. */
const MOST_FIRE = 4;
const FIRE = ["volumetric/flame", "volumetric/haze", "volumetric/haze-copy", "volumetric/smoke"];

for (const [quality, rounds] of Object.entries(PASS_ROUNDS) as [TierName, number][]) {
  test(`a frame at ${quality}, as a whole and pass by pass`, async ({ page }, info) => {
    await page.setViewportSize({ width: 1280, height: 720 });
    await open(page);
    const results = await page.evaluate(
      ([quality, rounds]) => window.bench.measurePasses(quality, rounds),
      [quality, rounds] as const,
    );
    await report(info, "passes", results);
    for (const { frame, passes, doing } of results) {
      expect(passes.length).toBeGreaterThan(3);
      expect(frame.copies).toBeGreaterThan(0);
      if (quality !== "low") continue;
      const fire = passes.filter(({ pass }) => FIRE.includes(pass));
      expect.soft(frame.copies, doing).toBeLessThanOrEqual(MOST_COPIES[doing]);
      expect.soft(sum(fire.map(({ copies }) => copies)), doing).toBeLessThanOrEqual(MOST_FIRE);
    }
  });
}

/** Most milliseconds of the main thread that the script of a frame may take: 2 of 16.7. */
const MOST_FRAME_SCRIPT = 2;

test("the script of a frame leaves the main thread to the page", async ({ page }) => {
  for (const quality of ["low", "medium", "high"] as const) {
    await open(page);
    const script = await page.evaluate((quality) => window.bench.measureScript(quality), quality);
    const [atRest, inMotion] = [script.atRest.toFixed(2), script.inMotion.toFixed(2)];
    console.log(`${quality}: script ${atRest} ms at rest, ${inMotion} ms in motion`);
    expect.soft(script.atRest, quality).toBeLessThanOrEqual(MOST_FRAME_SCRIPT);
    expect.soft(script.inMotion, quality).toBeLessThanOrEqual(MOST_FRAME_SCRIPT);
  }
});

/** Most that each standing candle may add to a frame at medium, as shares of one without. */
const MOST_OF_CANDLE = { atRest: 0.1, inMotion: 0.3 };

test("one and three standing candles add little to a frame at medium", async ({ page }) => {
  await open(page);
  const costs = await page.evaluate(() => window.bench.measureCandles("medium", [1, 3], 8));
  expect(costs).toHaveLength(2);
  for (const { candles, atRest, inMotion } of costs) {
    console.log(
      `${candles} candles: ${atRest.toFixed(2)} at rest, ${inMotion.toFixed(2)} in motion`,
    );
    expect.soft(inMotion).toBeLessThanOrEqual(1 + candles * MOST_OF_CANDLE.inMotion);
    expect.soft(atRest).toBeLessThanOrEqual(1 + candles * MOST_OF_CANDLE.atRest);
  }
});

for (const cell of CELLS) {
  const { count, pixels } = cell;
  test(`${count} particles of ${pixels} px cost little more than the least they can`, async ({
    page,
  }, info) => {
    await open(page);
    const effort = EFFORT[count];
    if (!effort) throw new Error(`Nobody said how often to measure ${count} particles.`);
    const result = await page.evaluate(
      ([cell, effort]) => window.bench.measureScaling(cell, effort),
      [cell, effort] as const,
    );
    await report(info, "scaling", result);
    const [ours, control] = result.peers;
    for (const { name, covered, brightness } of result.peers) {
      const coverage = covered / (control?.covered ?? 0);
      expect(Math.abs(coverage - 1), `${name}: covered pixels`).toBeLessThan(TOLERANCE);
      expect(Math.abs(brightness - 1), `${name}: light`).toBeLessThan(TOLERANCE);
    }
    expect(ours?.ratio).toBeLessThanOrEqual(MOST_RATIO);
    expect(ours?.bestScriptMs).toBeLessThanOrEqual(MOST_SCRIPT);
  });
}
