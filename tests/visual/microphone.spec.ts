import { writeFileSync } from "node:fs";
import { browser as settings } from "../support/browser.ts";
import { HostedPage, test } from "../support/hosted-page.ts";
import { vowel, wav, wind } from "../support/signals.ts";
import { expect } from "../support/test.ts";

test("a breath at the microphone puts the candle out, and speech before it does not", async ({
  playwright,
}, testInfo) => {
  const file = testInfo.outputPath("breath.wav");
  const speech = vowel(0.3, [700, 1200]);
  writeFileSync(file, wav([speech, wind(0.35), wind(0.35)]));
  const { args = [], ...options } = settings.launchOptions ?? {};
  const browser = await playwright.chromium.launch({
    ...options,
    args: [
      ...args,
      "--use-fake-ui-for-media-stream",
      "--use-fake-device-for-media-stream",
      `--use-file-for-fake-audio-capture=${file}`,
    ],
  });
  const page = await browser.newPage({ viewport: { width: 320, height: 200 } });
  const hosted = await new HostedPage(page).open();
  await hosted.evaluate((room) => {
    const { blow } = room;
    room.blow = (strength) => {
      window.heardAt ??= performance.now();
      blow.call(room, strength);
    };
  });
  await page.getByRole("button", { name: "Settings" }).click();
  await page.evaluate(() => {
    window.openedAt = performance.now();
  });
  await page.getByRole("button", { name: "Blow with your breath" }).click();
  await expect.poll(() => hosted.evaluate((room) => room.lit)).toBe(false);
  const silence = await page.evaluate(() => (window.heardAt ?? 0) - window.openedAt);
  expect(silence, "while there was speech").toBeGreaterThan(1000);
  expect(hosted.complaints).toEqual([]);
  await browser.close();
});

declare global {
  interface Window {
    /** Milliseconds, when the microphone was asked for, and when it first heard a breath. */
    openedAt: number;
    heardAt: number | undefined;
  }
}
