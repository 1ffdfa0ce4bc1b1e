import type { Page } from "playwright/test";
import { luma } from "../../src/light/color.ts";
import { colorOf } from "../support/display-transform.ts";
import {
  quantile,
  readReference,
  renderView,
  tracedViews,
  VIEW_SIZE,
} from "../support/reference.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

/** Relative errors of luminance: median, 90th percentile, and of the mean, signed. */
interface Errors {
  readonly median: number;
  readonly high: number;
  readonly mean: number;
}
/** Views of the cabin by several lights, at `high`, as measured on 2026-11-26; docs/realism.md quotes them. */
const MEASURED: Readonly<Record<string, Errors>> = {
  // Nothing but light that has bounced, from one patch on the floor.
  night: { median: 0.125, high: 0.42, mean: -0.038 },
  moonlit: { median: 0.05, high: 0.188, mean: 0 },
  "three-candles": { median: 0.068, high: 0.256, mean: -0.054 },
};
const MARGIN: Errors = { median: 0.01, high: 0.02, mean: 0.01 };

test.describe("By several lights the cabin is as a path tracer has it", () => {
  let page: Page;
  let room: RoomDriver;
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    room = await new RoomDriver(page).open(
      { look: "physical", quality: "high", wind: "0" },
      VIEW_SIZE,
    );
  });
  test.afterAll(() => page.close());

  for (const [name, before] of Object.entries(MEASURED)) {
    test(name, async () => {
      const view = tracedViews.find((one) => one.name === name);
      if (!view) throw new Error(`There is no reference of “${name}”.`);
      const ours = await renderView(room, view);
      const { radiance, isCompared } = readReference(name);
      expect([ours.width, ours.height]).toEqual([view.width, view.height]);
      const pairs = isCompared.flatMap((counts, pixel) => {
        const theirs = luma(colorOf(radiance, pixel));
        return counts && theirs > 0 ? [[luma(colorOf(ours.radiance, pixel)), theirs] as const] : [];
      });
      expect(pairs.length).toBeGreaterThan(isCompared.length / 2);
      const errors = pairs.map(([mine, theirs]) => Math.abs(mine / theirs - 1));
      const sum = (which: 0 | 1) => pairs.reduce((total, pair) => total + pair[which], 0);
      const measured = {
        median: quantile(errors, 0.5),
        high: quantile(errors, 0.9),
        mean: sum(0) / sum(1) - 1,
      };
      console.log(name, measured);
      expect.soft(measured.median).toBeLessThanOrEqual(before.median + MARGIN.median);
      expect.soft(measured.high).toBeLessThanOrEqual(before.high + MARGIN.high);
      expect.soft(Math.abs(measured.mean)).toBeLessThanOrEqual(Math.abs(before.mean) + MARGIN.mean);
      expect(room.complaints).toEqual([]);
    });
  }
});
