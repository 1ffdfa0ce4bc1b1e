import { expect, test } from "playwright/test";
import { ORIGINS } from "../support/browser.ts";
import type { TierName } from "./passes.ts";

const PAGE = { width: 1920, height: 1080 };
const TIERS: readonly TierName[] = ["low", "medium", "high", "ultra"];
const ROUNDS = 6;

for (const quality of TIERS) {
  test(`a frame at ${quality} on the machine's own GPU`, async ({ page }, info) => {
    await page.goto(ORIGINS.bench);
    await page.waitForFunction(() => "bench" in window);
    const frames = await page.evaluate(
      ([quality, rounds, size]) => window.bench.measurePasses(quality, rounds, size),
      [quality, ROUNDS, PAGE] as const,
    );
    await info.attach("gpu", { body: JSON.stringify(frames), contentType: "application/json" });
    for (const { renderer, frame } of frames) {
      expect(frame.gpuMs, `${renderer} has a clock`).toBeGreaterThan(0);
    }
  });
}
