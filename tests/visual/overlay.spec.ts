import sharp from "sharp";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const CANDLE = { scene: "candle", quality: "low" } as const;
/** Narrower than a word. */
const NARROW = { width: 24, height: 80 } as const;

test("That a candle is out is shown with controls alone, and never leaves the page wider", async ({
  page,
}) => {
  const room = await new RoomDriver(page).open({ ...CANDLE, unlit: "" }, NARROW);
  const boxOfHint = () =>
    room.evaluate((element) => {
      element.style.marginInlineStart = "calc(100vw - 24px)";
      const line = element.shadowRoot?.querySelector("[part=hint] p");
      const { scrollWidth, clientWidth } = document.documentElement;
      return {
        width: line?.getBoundingClientRect().width,
        isWider: scrollWidth > clientWidth,
      };
    });
  expect(await boxOfHint()).toEqual({ width: 0, isWider: false });
  await room.set({ controls: "" });
  expect((await boxOfHint()).width).toBeGreaterThan(24);
  await room.evaluate((element) => {
    for (const animation of element.shadowRoot?.getAnimations() ?? []) animation.finish();
  });
  expect(await boxOfHint()).toEqual({ width: 0, isWider: false });
  expect(room.complaints).toEqual([]);
});

for (const contrast of ["no-preference", "more"] as const) {
  test(`The focus is seen on pages of any brightness, with contrast ${contrast}`, async ({
    page,
  }) => {
    await page.emulateMedia({ contrast });
    const room = await new RoomDriver(page).open({ ...CANDLE, controls: "" }, NARROW);
    for (const ground of [0, 255]) {
      await room.evaluate((element, ground) => {
        document.body.style.background = `rgb(${ground} ${ground} ${ground})`;
        element.style.margin = "20px";
      }, ground);
      const shot = async () => {
        const clip = { x: 0, y: 0, width: 20, height: 120 };
        const file = await page.screenshot({ clip });
        return sharp(file).greyscale().raw().toBuffer();
      };
      const before = await shot();
      await room.evaluate((element) => element.focus());
      const changes = (await shot()).map((level, i) => Math.abs(level - (before[i] ?? 0)));
      expect(Math.max(...changes)).toBeGreaterThan(150);
      await room.evaluate((element) => element.blur());
    }
  });
}

test("Words in a lone candle's slots have the page's colour, and in a room's a light one", async ({
  page,
}) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const room = await new RoomDriver(page).load(CANDLE);
  const colours = () =>
    room.evaluate((element) => {
      const own = element.shadowRoot?.querySelector("[part=error] p");
      const colours = [own && getComputedStyle(own).color];
      element.innerHTML = "<p slot=error>No candle.</p>";
      colours.push(getComputedStyle(element.children[0] as Element).color);
      element.replaceChildren();
      return colours;
    });
  const light = "rgb(243, 231, 211)";
  expect(await colours()).toEqual([light, "rgb(0, 0, 0)"]);
  await room.set({ scene: "room" });
  expect(await colours()).toEqual([light, light]);
});

test("After a file that could not be fetched a button fetches it again", async ({ page }) => {
  const models = "**/*.glb";
  await page.route(models, (route) => route.abort());
  const room = await new RoomDriver(page).load(CANDLE);
  const reload = page.locator("candle-flame").locator("[part~=reload]");
  await expect(reload).toBeVisible();
  await page.unroute(models);
  await reload.click();
  await room.evaluate((element) => element.ready);
  await expect(reload).toBeHidden();
});

test("In a small box with large type a failure's sentence and button can be scrolled to", async ({
  page,
}) => {
  await page.route("**/*.glb", (route) => route.abort());
  await new RoomDriver(page).load(CANDLE, { width: 160, height: 90 });
  await page.addStyleTag({ content: "html { font-size: 200% } candle-flame { margin: 200px }" });
  const failure = page.locator("candle-flame").locator("[part~=error]");
  await expect(failure).toBeVisible();
  const top = () =>
    failure.evaluate((element) => {
      element.scrollTo(0, 0);
      const sentence = element.querySelector("p");
      return (sentence?.getBoundingClientRect().top ?? 0) - element.getBoundingClientRect().top;
    });
  expect(await top()).toBeGreaterThanOrEqual(0);
  await page.locator("candle-flame").locator("[part~=reload]").click({ timeout: 5000 });
});

test("The element's own words are English and run to the right on any page, the page's as there", async ({
  page,
}) => {
  await page.route("**/*.glb", (route) => route.abort());
  const room = await new RoomDriver(page).load({ ...CANDLE, controls: "", unlit: "" });
  await page.evaluate(() => Object.assign(document.documentElement, { lang: "ar", dir: "rtl" }));
  const own = "[part=hint] p, [part=hint] kbd, [part=error] p, [part=reload]";
  const spoken = (selector: string) =>
    room.evaluate((element, selector) => {
      const all = [...element.children, ...(element.shadowRoot?.querySelectorAll(selector) ?? [])];
      return all.map((one) => [
        one.closest("[lang]")?.getAttribute("lang"),
        getComputedStyle(one).direction,
      ]);
    }, selector);
  const english = ["en", "ltr"];
  const reload = page.locator("candle-flame").locator("[part~=reload]");
  await expect(reload).toBeVisible();
  expect(await spoken(own)).toEqual([english, english]);
  await page.unroute("**/*.glb");
  await reload.click();
  await room.evaluate((element) => element.ready);
  expect(await spoken("[part=hint] p")).toEqual([english]);
  await room.evaluate((element) => {
    element.enter();
    element.step(0);
  });
  const controls = await spoken("[part=hint] p, [part=hint] kbd");
  expect(controls.length).toBeGreaterThan(2);
  expect(controls).toEqual(controls.map(() => english));
  await room.evaluate((element) => {
    element.innerHTML = "<b slot=hint>page</b>";
  });
  expect((await spoken("[part=hint]"))[0]).toEqual(["ar", "rtl"]);
});

test("A poster that cannot be fetched leaves no icon of a broken image", async ({ page }) => {
  await page.route("**/*.glb", () => {}); // loads for ever
  const room = await new RoomDriver(page).load({ ...CANDLE, poster: "none.png" });
  const poster = page.locator("candle-flame").locator("[part~=poster]");
  await expect(poster).toBeHidden();
  await page.route("**/late.svg", (route) =>
    route.fulfill({
      contentType: "image/svg+xml",
      body: '<svg xmlns="http://www.w3.org/2000/svg" width="1" height="1"/>',
    }),
  );
  await room.set({ poster: "late.svg" });
  await expect(poster).toBeVisible();
});

test("Who has asked to enter before the first frame enters with it", async ({ page }) => {
  const room = await new RoomDriver(page).load({ ...CANDLE, controls: "" });
  const isEarly = await room.evaluate(async (element) => {
    // Another, which cannot have been drawn before the call.
    const other = element.cloneNode() as typeof element;
    element.replaceWith(other);
    const isEarly = other.stats.drawCalls === 0;
    other.enter();
    await other.ready;
    return isEarly;
  });
  expect(isEarly).toBe(true);
  await expect.poll(() => room.isWalking()).toBe(true);
});

test("The bar of progress fills from where the page's lines begin", async ({ page }) => {
  const room = await new RoomDriver(page).open(CANDLE);
  for (const dir of ["ltr", "rtl"] as const) {
    const gaps = await room.evaluate(async (element, dir) => {
      document.documentElement.dir = dir;
      const bar = element.shadowRoot?.querySelector("[part=progress]");
      const gaps: { before: number; after: number }[] = [];
      element.addEventListener("progress", ({ detail: { totalProgress } }) => {
        if (totalProgress === 0 || totalProgress === 1) return;
        queueMicrotask(() => {
          const [own, all] = [bar, element].map((one) => one?.getBoundingClientRect());
          const left = (own?.left ?? 0) - (all?.left ?? 0);
          const right = (all?.right ?? 0) - (own?.right ?? 0);
          gaps.push(
            dir === "ltr" ? { before: left, after: right } : { before: right, after: left },
          );
        });
      });
      element.src = dir === "ltr" ? "/models/jar.glb" : "/models/wreath.glb";
      await element.ready;
      return gaps;
    }, dir);
    expect(gaps.length, dir).toBeGreaterThan(0);
    for (const { before, after } of gaps) {
      expect(before, dir).toBeCloseTo(0, 1);
      expect(after, dir).toBeGreaterThan(1);
    }
  }
});

test("While loading has no measure a piece of the bar goes from one end to the other", async ({
  page,
}) => {
  const room = await new RoomDriver(page).open(CANDLE);
  const ends = await room.evaluate((element) => {
    const slot = element.shadowRoot?.querySelector<HTMLElement>("slot[name=progress]");
    const bar = element.shadowRoot?.querySelector<HTMLElement>("[part=progress]");
    if (!slot || !bar) throw new Error("There is no bar.");
    slot.hidden = false;
    bar.style.inlineSize = "100%";
    bar.classList.add("full");
    const [animation] = bar.getAnimations();
    if (!animation) throw new Error("It stands still.");
    animation.pause();
    const { left, width } = element.getBoundingClientRect();
    return [0, 1599.9].map((time) => {
      animation.currentTime = time;
      const own = bar.getBoundingClientRect();
      return [(own.left - left) / width, (own.right - left) / width];
    });
  });
  for (const [i, end] of [0, 0.2, 0.8, 1].entries()) {
    expect(ends.flat()[i]).toBeCloseTo(end, 2);
  }
});
