/**
 * The example of docs/testing.md: how a page that embeds the element is tested. It imports nothing of this
 * repository but the address that the tests serve the package at, and the element's types.
 */
import { expect, type Page, test } from "playwright/test";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { ORIGINS } from "../support/browser.ts";

/** A stranger's page: a heading, and a candle beside it. */
const PAGE = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Vigil</title>
  <style>
    body { margin: 0; background: #241a14; color: #eee; font: 16px/1.5 monospace }
    candle-flame { width: 60px; height: 80px; aspect-ratio: auto }
  </style>
  <h1>Vigil</h1>
  <candle-flame scene="candle" quality="medium"></candle-flame>
  <script type="module" src="/define.js"></script></html>`;

async function open(page: Page): Promise<void> {
  const url = `${ORIGINS.library}vigil.html`;
  await page.route(url, (route) => route.fulfill({ contentType: "text/html", body: PAGE }));
  await page.goto(url);
  await page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
}

const candleOf = (page: Page) => page.locator("candle-flame");

/** The flame of this seed, this many seconds after the beginning, and no longer moving. */
async function holdStill(page: Page, seed: number, seconds: number): Promise<void> {
  await candleOf(page).evaluate(
    async (candle: CandleFlameElement, { seed, seconds }) => {
      candle.pause();
      await candle.ready;
      candle.reset(seed);
      candle.step(seconds);
    },
    { seed, seconds },
  );
}

test("A page with a candle that is held still has the same screenshot each time", async ({
  page,
}) => {
  await open(page);
  await holdStill(page, 7, 0.5);
  const first = await page.screenshot();
  expect(await page.screenshot()).toEqual(first);

  // Whatever happened meanwhile, and after a reload:
  await candleOf(page).evaluate((candle: CandleFlameElement) => {
    candle.extinguish();
    candle.step(0.5);
    candle.light();
  });
  expect(await page.screenshot()).not.toEqual(first);
  await holdStill(page, 7, 0.5);
  expect(await page.screenshot()).toEqual(first);
  await open(page);
  await holdStill(page, 7, 0.5);
  expect(await page.screenshot()).toEqual(first);

  // Another seed is another flame, and so is another moment.
  await holdStill(page, 8, 0.5);
  expect(await page.screenshot()).not.toEqual(first);
  await holdStill(page, 7, 0.6);
  expect(await page.screenshot()).not.toEqual(first);
});

test("One step is worth many, and the numbers say so too", async ({ page }) => {
  await open(page);
  await holdStill(page, 7, 0.25);
  const numbers = () =>
    candleOf(page).evaluate((candle: CandleFlameElement) => {
      const { flame, currentTime } = candle;
      return { flame, currentTime: currentTime.toFixed(9) };
    });
  const whole = { picture: await page.screenshot(), ...(await numbers()) };
  expect(whole.flame?.luminousIntensity).toBeGreaterThan(0.3);
  await candleOf(page).evaluate((candle: CandleFlameElement) => {
    candle.reset();
    for (let i = 0; i < 15; i++) candle.step(1 / 60);
  });
  expect({ picture: await page.screenshot(), ...(await numbers()) }).toEqual(whole);
});

test("A mask covers a candle that burns on", async ({ page }) => {
  await open(page);
  await candleOf(page).evaluate((candle: CandleFlameElement) => candle.ready);
  const mask = [candleOf(page)];
  const first = await page.screenshot({ mask });
  const time = () => candleOf(page).evaluate((candle: CandleFlameElement) => candle.currentTime);
  const before = await time();
  await expect.poll(time).toBeGreaterThan(before);
  expect(await page.screenshot({ mask })).toEqual(first);
});

test("For visitors who want less motion the flame stands still by itself", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page);
  const flameAt = async (seed: number, seconds: number) => {
    await holdStill(page, seed, seconds);
    return candleOf(page).evaluate((candle: CandleFlameElement) => candle.flame);
  };
  const flame = await flameAt(7, 0.5);
  expect(flame?.luminousIntensity).toBeGreaterThan(0.3);
  expect(await flameAt(8, 1.5), "another seed, another time").toEqual(flame);
  await page.emulateMedia({ reducedMotion: "no-preference" });
  expect(await flameAt(8, 1.5)).not.toEqual(flame);
});

test("Reduced motion holds from the next step on, even if the browser reports the change late", async ({
  page,
}) => {
  await page.addInitScript(() => {
    MediaQueryList.prototype.addEventListener = () => {};
  });
  await open(page);
  await holdStill(page, 7, 0.5);
  const flameAfter = (seconds: number) =>
    candleOf(page).evaluate((candle: CandleFlameElement, seconds) => {
      candle.step(seconds);
      return candle.flame;
    }, seconds);
  expect(await flameAfter(0.5)).not.toEqual(await flameAfter(0.5));
  await page.emulateMedia({ reducedMotion: "reduce" });
  expect(await flameAfter(0.5)).toEqual(await flameAfter(0.5));
  await page.emulateMedia({ reducedMotion: "no-preference" });
  expect(await flameAfter(0.5)).not.toEqual(await flameAfter(0.5));
});
