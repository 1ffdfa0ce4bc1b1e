import { expect, test } from "playwright/test";
import { ORIGINS } from "../support/browser.ts";
import type { Lights, TierName } from "./passes.ts";

const PAGE = { width: 1920, height: 1080 };
const TIERS: readonly TierName[] = ["low", "medium", "high", "ultra"];
const ROUNDS = 6;
const LIGHTS: readonly (Lights | undefined)[] = [
  undefined,
  "candle on the table",
  "one more candle",
  "three more candles",
  "moon alone",
];

const scenes = TIERS.flatMap((quality) =>
  // What else shines is measured at two tiers.
  (quality === "medium" || quality === "high" ? LIGHTS : [undefined]).map((lights) => ({
    quality,
    lights,
  })),
);

for (const { quality, lights } of scenes) {
  const title = [quality, lights].filter(Boolean).join(", ");
  test(`a frame at ${title} on the machine's own GPU`, async ({ page }, info) => {
    await page.goto(ORIGINS.bench);
    await page.waitForFunction(() => "bench" in window);
    const frames = await page.evaluate(
      ([quality, rounds, size, lights]) =>
        window.bench.measurePasses(quality, rounds, size, lights),
      [quality, ROUNDS, PAGE, lights] as const,
    );
    await info.attach("gpu", { body: JSON.stringify(frames), contentType: "application/json" });
    for (const { renderer, frame } of frames) {
      expect(frame.gpuMs, `${renderer} has a clock`).toBeGreaterThan(0);
    }
  });
}
