import type { Locator, Page } from "playwright/test";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { SETTINGS } from "../../src/settings.ts";
import { expect, type HostedPage, PAGE, scaleType, test } from "../support/hosted-page.ts";
import { drawNothing } from "../support/no-drawing.ts";

// Dear, and each for itself: whichever worker is free takes the next.
test.describe.configure({ mode: "parallel" });

test.use({
  viewport: { width: 390, height: 500 },
  permissions: ["clipboard-read", "clipboard-write"],
});

/** Opens a page of the documentation, from a folder of a site, under the policy of the hosted page. */
async function read(fresh: HostedPage, name: string): Promise<Page> {
  await drawNothing(fresh.page);
  await fresh.load(name, `${PAGE}some/folder/`);
  return fresh.page;
}

/** Brings a figure into sight, and waits for its first frame. */
async function firstFrame(figure: Locator): Promise<CandleFlameElement["stats"]> {
  await figure.scrollIntoViewIfNeeded();
  return figure.locator("candle-flame").evaluate(async (element: CandleFlameElement) => {
    element.quality = "low";
    element.maxPixelRatio = 0.5;
    await element.ready;
    element.pause();
    return element.stats;
  });
}

const widthOf = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth);

test("“Use it” has snippets to copy, and every attribute to try", async ({ fresh }) => {
  const page = await read(fresh, "use.html");
  expect(await fresh.axe()).toEqual([]);
  expect(await widthOf(page)).toBe(390);
  await scaleType(page, 2);
  expect(await widthOf(page), "with large type").toBe(390);
  await scaleType(page, 1);

  await test.step("a figure says that it is to come, unless it never will", async () => {
    const figure = page.locator("#style figure"); // far below
    await expect(figure.getByText("The figure is being prepared…")).toBeVisible();
    const left = await figure.locator("candle-flame").evaluate((candle) => {
      return ["error", "progress"].map((type) => {
        candle.dispatchEvent(new CustomEvent(type));
        return candle.textContent;
      });
    });
    expect(left).toEqual(["", "The figure is being prepared…"]);
  });

  await test.step("snippets copy", async () => {
    const snippets = page.locator(".snippet");
    const first = snippets.first();
    await first.getByRole("button", { name: "Copy" }).click();
    await expect(first.getByRole("button", { name: "Copied" })).toBeVisible();
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    expect(copied).toContain('<candle-flame scene="candle"></candle-flame>');
    await expect(page.locator(".snippet button")).toHaveCount(await snippets.count());
  });

  await test.step("attributes act, and are said in HTML", async () => {
    const bench = page.locator(".bench");
    expect((await firstFrame(bench.locator("figure"))).drawCalls).toBeGreaterThan(0);
    const form = page.getByRole("form", { name: "Attributes" });
    const names = await form
      .locator("[name]")
      .evaluateAll((all) => all.map((one) => one.getAttribute("name")));
    expect(names).toEqual(Object.keys(SETTINGS));
    await form.getByLabel("wind", { exact: true }).fill("0.4");
    await form.getByLabel("unlit").check();
    await form.getByLabel("quality").selectOption("auto");
    await form.getByLabel("max-pixel-ratio").fill("2");
    await form.getByLabel("paused").uncheck();
    await expect(bench.locator(".snippet code")).toHaveText(
      '<candle-flame scene="candle" unlit wind="0.4"></candle-flame>',
    );
    const candle = page.locator("#tried");
    expect(await candle.evaluate(({ wind, lit }: CandleFlameElement) => ({ wind, lit }))).toEqual({
      wind: 0.4,
      lit: false,
    });
    // Others may be logged soon after it.
    const reported = await bench.getByRole("log").evaluateHandle((log) => {
      const lines: string[] = [];
      new MutationObserver(() => lines.push(log.textContent)).observe(log, { childList: true });
      return lines;
    });
    await form.getByLabel("unlit").uncheck();
    await expect.poll(() => reported.jsonValue()).toContain("event: light");
    expect(await candle.evaluate(({ lit }: CandleFlameElement) => lit)).toBe(true);
    await form.getByLabel("wind", { exact: true }).fill("");
    await page.keyboard.press("Tab");
    await expect(bench.locator(".snippet code"), "its default").toHaveText(
      '<candle-flame scene="candle"></candle-flame>',
    );
  });

  await test.step("time that stops out of sight is not logged, as scrolling would be read aloud", async () => {
    const candle = page.locator("#tried");
    await candle.scrollIntoViewIfNeeded();
    const isPlaying = () => candle.evaluate((candle) => candle.matches(":state(playing)"));
    await expect.poll(isPlaying).toBe(true);
    const lines = await candle.evaluate((candle: CandleFlameElement) => {
      const log = document.querySelector("[role=log]") as HTMLElement;
      const lineAfter = (change: () => void) => {
        log.textContent = "";
        change();
        return log.textContent;
      };
      return [
        ...["pause", "play"].map((type) => lineAfter(() => candle.dispatchEvent(new Event(type)))),
        lineAfter(() => candle.pause()),
        lineAfter(() => candle.play()),
      ];
    });
    expect(lines).toEqual(["", "", "event: pause", "event: play"]);
    const unseen = await candle.evaluate(async (candle: CandleFlameElement) => {
      const log = document.querySelector("[role=log]") as HTMLElement;
      const show = (visibilityState: "hidden" | "visible") => {
        Object.defineProperty(document, "visibilityState", {
          value: visibilityState,
          configurable: true,
        });
        document.dispatchEvent(new Event("visibilitychange"));
      };
      log.textContent = "";
      show("hidden");
      candle.pause();
      await Promise.resolve();
      show("visible");
      const before = log.textContent;
      candle.play();
      return [before, log.textContent];
    });
    expect(unseen, "what began out of sight").toEqual(["", "event: play"]);
  });

  await test.step("none of them is hidden by the candle, whatever takes the focus", async () => {
    await page.emulateMedia({ reducedMotion: "reduce" }); // it scrolls at once
    const inputs = page.locator(".attributes :is(select, input)");
    for (const size of [
      { width: 640, height: 360 },
      { width: 390, height: 700 },
    ]) {
      await page.setViewportSize(size);
      const hidden = await inputs.evaluateAll((all) => {
        const isHidden = (input: Element) => {
          (document.activeElement as HTMLElement).blur();
          (input as HTMLElement).focus();
          const { left, top, width, height } = input.getBoundingClientRect();
          return document.elementFromPoint(left + width / 2, top + height / 2) !== input;
        };
        // Upwards, too, as Shift and Tab go.
        return [...all, ...all.toReversed()].filter(isHidden).map(({ id }) => id);
      });
      expect(hidden).toEqual([]);
    }
  });

  await test.step("a slider's number is said once", async () => {
    const slider = page.getByRole("slider", { name: "--candle-flame-glow", exact: true });
    await slider.fill("0.35");
    await expect(slider).toHaveAttribute("aria-valuetext", "0.35");
    await expect(page.getByText("0.35", { exact: true })).toHaveAttribute("aria-live", "off");
  });

  await test.step("and methods to call on a candle beside their buttons", async () => {
    const figure = page.locator("#scripted");
    await firstFrame(figure);
    await expect(figure.getByText("The figure is being prepared…")).toBeHidden();
    await figure.getByRole("button", { name: "extinguish()" }).click();
    await expect(figure.locator("output")).toHaveText("out");
    await figure.getByRole("button", { name: "light()" }).click();
    await expect(figure.locator("output")).toHaveText("lit");
  });
});

test("without JavaScript each page says so, in sight", async ({ browser }) => {
  const page = await browser.newPage({ javaScriptEnabled: false });
  for (const name of ["", "use.html", "how.html"]) {
    await page.goto(PAGE + name);
    const sentence = page.locator("noscript p");
    await expect(sentence).toContainText("with JavaScript, which is switched off.");
    // As for a click, which nothing may lie over.
    await sentence.click({ trial: true });
  }
  await page.close();
});

test("“How it works” has figures that are computed, and switches that act", async ({ fresh }) => {
  const page = await read(fresh, "how.html");
  expect(await fresh.axe()).toEqual([]);
  expect(await widthOf(page)).toBe(390);
  await expect(page.locator("article")).toHaveCount(12);
  await expect(page.locator("article > figure.live > .window")).toHaveCount(12);

  const figure = (name: string) => page.locator(`#${name} figure`);
  expect((await firstFrame(figure("layers"))).particles).toBeGreaterThan(100);
  const layers = figure("layers").locator("candle-flame");
  expect(await layers.evaluate(({ held }: CandleFlameElement) => held)).toBe(false);
  await figure("layers").getByLabel("the haze").uncheck();
  expect(await layers.evaluate(({ features }: CandleFlameElement) => features.hazeLayer)).toBe(
    false,
  );

  expect((await firstFrame(figure("body"))).drawCalls).toBeGreaterThan(0);
  const body = figure("body").locator("candle-flame");
  const height = () =>
    body.evaluate((candle: CandleFlameElement) => {
      candle.step(1);
      return candle.flame?.height ?? 0;
    });
  const before = await height();
  // Screen readers have the unit as the slider's own, and hear it once.
  const wick = figure("body").getByRole("slider", { name: "wick", exact: true });
  await wick.fill("4");
  await expect(wick).toHaveAttribute("aria-valuetext", "4 mm");
  await expect(figure("body").getByText("4 mm")).toBeVisible();
  await expect(figure("body").getByText("4 mm")).toHaveAttribute("aria-live", "off");
  expect(await height()).toBeGreaterThan(before * 1.2);

  await test.step("candles are chosen while there is no room, too", async () => {
    const night = figure("sum");
    const choose = (label: string) =>
      night.getByLabel(label).evaluate((box: HTMLInputElement) => box.click());
    const chosen = () =>
      night
        .locator("candle-flame")
        .evaluate(({ litWicks, unlit }: CandleFlameElement) => (unlit ? "none" : litWicks));
    await expect(night.locator("candle-flame")).toHaveCount(0);
    await choose("at the window");
    await figure("eye").scrollIntoViewIfNeeded();
    expect(await chosen()).toBe("0 1 3");
    for (const label of ["the carried candle", "left", "at the window"]) await choose(label);
    expect(await chosen()).toBe("none");
    await choose("right");
    expect(await chosen()).toBe("2");
  });

  await test.step("a room far away is given back, and comes again as it was", async () => {
    await figure("eye").scrollIntoViewIfNeeded();
    await expect(layers).toHaveCount(0);
    await firstFrame(figure("layers"));
    expect(
      await layers.evaluate(({ features, held }: CandleFlameElement) => [features.hazeLayer, held]),
    ).toEqual([false, false]);
  });
});

test("on paper both are dark text on white, without gaps where nothing is drawn", async ({
  fresh,
}) => {
  for (const name of ["how.html", "use.html"]) {
    const page = await read(fresh, name);
    await page.emulateMedia({ media: "print" });
    const pale = await page.evaluate(() => {
      const luminance = (color: string) => {
        const channels = (color.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
        const [r = 0, g = 0, b = 0] = channels.map((byte) => {
          const share = byte / 255;
          return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
        });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const contrast = (element: Element) =>
        1.05 / (luminance(getComputedStyle(element).color) + 0.05);
      const all = [...document.querySelectorAll("body, body *")];
      return all
        .filter((one) => one.checkVisibility() && contrast(one) < 4.5)
        .map((one) => one.outerHTML.slice(0, 80));
    });
    expect(pale, name).toEqual([]);
    const windows = page.locator("figure .window");
    const empty = await windows.evaluateAll(
      (all) =>
        all.filter((window) => {
          const isDrawn = window.querySelector("candle-flame:not(:state(loading))") !== null;
          return !isDrawn && window.getBoundingClientRect().height > 0;
        }).length,
    );
    expect(empty, name).toBe(0);
    await expect(page.getByRole("button").first()).toBeHidden();
    await page.emulateMedia({ media: "screen" });
    await page.unrouteAll({ behavior: "ignoreErrors" });
  }
});
