import type { Page } from "playwright/test";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { browser as settings } from "../support/browser.ts";
import { lostContexts, recordContexts } from "../support/contexts.ts";
import { drawNothing } from "../support/no-drawing.ts";
import { plainRoom } from "../support/plain-room.ts";
import { complaintsOf, LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

// Dear, and each for itself: whichever worker is free takes the next.
test.describe.configure({ mode: "parallel" });

const PIXEL = "data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACH5BAEAAAAALAAAAAABAAEAAAICRAEAOw==";

/** Puts more of a page where the room's own would be. */
async function openPage(page: Page, body: string): Promise<void> {
  await recordContexts(page);
  await serveSmallTextures(page);
  await page.route(`${LIBRARY}citizen.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><meta charset="utf-8"><title>citizen</title>
        <meta name="viewport" content="width=device-width">
        <style>body { margin: 0 } candle-flame { aspect-ratio: auto }</style>${body}
        <script type="module" src="/define.js"></script>`,
    }),
  );
  await page.goto(`${LIBRARY}citizen.html`);
  await page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
}

test("Out of sight, in a hidden tab or paused, no frame is asked for and none is drawn", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const counts = { asked: 0, drawn: 0 };
    Object.assign(globalThis, { counts, realFrame: requestAnimationFrame });
    globalThis.requestAnimationFrame = (callback) => {
      counts.asked++;
      return Reflect.apply(Reflect.get(globalThis, "realFrame"), globalThis, [callback]);
    };
    const { clear } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.clear = function (mask) {
      counts.drawn++;
      clear.call(this, mask);
    };
  });
  await drawNothing(page);
  const room = await new RoomDriver(page).open(
    {},
    { width: 32, height: 18, paused: false, after: `<div style="height: 3000px"></div>` },
  );
  const frames = () =>
    room.evaluate(async (element) => {
      const counts = Reflect.get(globalThis, "counts") as { asked: number; drawn: number };
      const realFrame = Reflect.get(globalThis, "realFrame") as typeof requestAnimationFrame;
      const asked = counts.asked;
      const drawn = counts.drawn;
      const time = element.currentTime;
      for (let i = 0; i < 4; i++) await new Promise((resolve) => realFrame.call(window, resolve));
      const moved = element.currentTime > time;
      return { asks: counts.asked > asked, draws: counts.drawn > drawn, moves: moved };
    });
  const plays = (isPlaying: boolean) =>
    expect
      .poll(() => room.evaluate((element) => element.matches(":state(playing)")))
      .toBe(isPlaying);
  const awake = { asks: true, draws: true, moves: true };
  const asleep = { asks: false, draws: false, moves: false };
  await plays(true);
  // Frames are left out while the GPU is busy, with the first one at least.
  await expect.poll(frames).toEqual(awake);

  await page.evaluate(() => scrollTo(0, 2000));
  await plays(false);
  expect(await frames(), "out of sight").toEqual(asleep);
  await room.set({ exposure: "1", "wind-direction": "90" });
  await room.stand({ yaw: 1 });
  expect(await frames(), "changed out of sight").toEqual(asleep);
  await page.evaluate(() => scrollTo(0, 0));
  await plays(true);

  const show = (visibilityState: "hidden" | "visible") =>
    page.evaluate((visibilityState) => {
      Object.defineProperty(document, "visibilityState", {
        value: visibilityState,
        configurable: true,
      });
      document.dispatchEvent(new Event("visibilitychange"));
    }, visibilityState);
  await show("hidden");
  await plays(false);
  expect(await frames(), "hidden").toEqual(asleep);
  await show("visible");
  await plays(true);
  await expect.poll(frames).toEqual(awake);

  await room.evaluate((element) => element.pause());
  // What was asked for before may still be drawn, and no more after it.
  await expect.poll(frames, "paused").toEqual(asleep);
  expect(await frames(), "paused").toEqual(asleep);
  // What changed while it was paused and out of sight is there when it is seen.
  await room.evaluate((element) => {
    scrollTo(0, 2000);
    // The element's own observer is older, and notified first.
    return new Promise<void>((resolve) => {
      const sight = new IntersectionObserver((entries) => {
        if (entries.at(-1)?.isIntersecting) return;
        sight.disconnect();
        resolve();
      });
      sight.observe(element);
    });
  });
  await room.set({ exposure: "-1" });
  expect(await frames()).toEqual(asleep);
  // A canvas is empty once it has another size.
  const canvasWidth = () =>
    room.evaluate((element) => element.shadowRoot?.querySelector("canvas")?.width);
  const width = await canvasWidth();
  await room.evaluate((element) => {
    element.style.width = `${element.clientWidth / 2}px`;
  });
  expect(await frames(), "resized out of sight").toEqual(asleep);
  expect(await canvasWidth()).toBe(width);
  const drawn = () =>
    page.evaluate(() => (Reflect.get(globalThis, "counts") as { drawn: number }).drawn);
  const unseen = await drawn();
  await page.evaluate(() => scrollTo(0, 0));
  await expect.poll(drawn).toBeGreaterThan(unseen);
  await expect.poll(canvasWidth).toBe(Math.round((width ?? 0) / 2));
  expect(room.complaints).toEqual([]);
});

for (const { motion, between } of [
  { motion: "no-preference", between: "then fades above the canvas, which is complete" },
  { motion: "reduce", between: "and is gone at once where less motion is wished for" },
] as const) {
  test(`The poster is there until the first frame, ${between}`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: motion });
    await openPage(page, "");
    const shown = await page.evaluate(async (poster) => {
      const element = document.createElement("candle-flame");
      Object.assign(element, { scene: "candle", quality: "low", paused: true, poster });
      element.style.cssText = "width: 40px; height: 60px";
      const shown: { state: string; opacity: number }[] = [];
      const look = () => {
        const part = (name: string) =>
          element.shadowRoot?.querySelector<HTMLElement>(`[part~=${name}]`);
        const canvas = part("canvas") as HTMLCanvasElement | null | undefined;
        const isCanvasShown = canvas?.checkVisibility({ visibilityProperty: true }) ?? false;
        const pixels = isCanvasShown
          ? canvas?.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data
          : undefined;
        const isDrawn = pixels?.some((byte) => byte > 0) ?? false;
        const isPosterShown = part("poster")?.checkVisibility() ?? false;
        const slot = part("poster")?.parentElement;
        const opacity = isPosterShown && slot ? Number(getComputedStyle(slot).opacity) : 0;
        shown.push({ state: `${isPosterShown} ${isCanvasShown} ${isDrawn}`, opacity });
        return isPosterShown;
      };
      document.body.append(element);
      while (look()) await new Promise(requestAnimationFrame);
      await element.ready;
      for (let i = 0; i < 3; i++) {
        await new Promise(requestAnimationFrame);
        look();
      }
      return shown;
    }, PIXEL);
    const states = shown.map(({ state }) => state).filter((state, i, all) => state !== all[i - 1]);
    const fading = motion === "reduce" ? [] : ["true true true"];
    expect(states).toEqual(["true false false", ...fading, "false true true"]);
    const opacities = shown.map(({ opacity }) => opacity);
    expect(opacities).toEqual(opacities.toSorted((a, b) => b - a));
  });
}

test("A poster that is not rendered, so that its fade never ends, is removed all the same", async ({
  page,
}) => {
  await openPage(page, "");
  const shown = await page.evaluate(async (poster) => {
    const element = document.createElement("candle-flame");
    Object.assign(element, { scene: "candle", quality: "low", paused: true, poster });
    element.style.cssText = "width: 40px; height: 60px; visibility: hidden";
    const box = document.createElement("div");
    box.append(element);
    document.body.append(box);
    box.style.display = "none";
    await element.ready;
    await new Promise(requestAnimationFrame);
    box.style.display = "block";
    return element.shadowRoot?.querySelector("[part~=poster]")?.checkVisibility();
  }, PIXEL);
  expect(shown).toBe(false);
});

test.describe("The canvas has the device pixels of its box", () => {
  const BOX = { left: 10.4, width: 101.3, height: 57.7 } as const;
  const attributes = `look="original" quality="medium" paused max-pixel-ratio="4"`;
  const html = `<candle-flame ${attributes} style="margin-left: ${BOX.left}px; width: ${BOX.width}px; height: ${BOX.height}px"></candle-flame>`;
  /** Where the browser puts the box's edges on the screen. */
  const snapped = (from: number, length: number, ratio: number) =>
    Math.round((from + length) * ratio) - Math.round(from * ratio);
  const setZoom = (page: Page, zoom: number) =>
    page.evaluate((zoom) => {
      document.documentElement.style.zoom = String(zoom);
    }, zoom);
  const sizeOf = (page: Page) =>
    new RoomDriver(page).evaluate(({ stats }) => [stats.width, stats.height]);

  test("to the pixel, at any zoom", async ({ playwright }) => {
    // A real monitor's density: one that is only played is not reported.
    const { launchOptions = {} } = settings;
    const dense = await playwright.chromium.launch({
      ...launchOptions,
      args: [...(launchOptions.args ?? []), "--force-device-scale-factor=1.25"],
    });
    const unplayed: object = { viewport: null, deviceScaleFactor: undefined };
    const context = await dense.newContext(unplayed);
    const page = await context.newPage();
    await drawNothing(page);
    await openPage(page, html);
    // The last makes up for the density.
    for (const zoom of [1, 1.5, 0.75, 0.8]) {
      await setZoom(page, zoom);
      const ratio = 1.25 * zoom;
      await expect
        .poll(() => sizeOf(page), `at ${zoom}`)
        .toEqual([snapped(BOX.left, BOX.width, ratio), snapped(0, BOX.height, ratio)]);
    }
    await dense.close();
  });

  test("on any monitor, near enough where they are not reported", async ({ page }) => {
    await page.addInitScript(() => {
      const { observe } = ResizeObserver.prototype;
      ResizeObserver.prototype.observe = function (target, options) {
        if (options?.box === "device-pixel-content-box") throw new TypeError("no such box");
        observe.call(this, target, options);
      };
      Reflect.deleteProperty(ResizeObserverEntry.prototype, "devicePixelContentBoxSize");
      // The window comes to lie on monitors of any density.
      const monitor = Object.assign(new EventTarget(), { ratio: 1 });
      const { matchMedia } = globalThis;
      globalThis.matchMedia = (query) =>
        query === `(resolution: ${monitor.ratio}dppx)`
          ? (monitor as unknown as MediaQueryList)
          : matchMedia.call(window, query);
      Object.defineProperty(globalThis, "devicePixelRatio", { get: () => monitor.ratio });
      Object.assign(globalThis, { monitor });
    });
    await drawNothing(page);
    await openPage(page, html);
    const room = new RoomDriver(page);
    await room.evaluate((element) => element.ready);
    const moveTo = (ratio: number) =>
      page.evaluate((ratio) => {
        const monitor = Reflect.get(globalThis, "monitor") as EventTarget & { ratio: number };
        monitor.ratio = ratio;
        monitor.dispatchEvent(new Event("change"));
      }, ratio);
    for (const ratio of [1.25, 3, 1]) {
      await moveTo(ratio);
      const [width = 0, height = 0] = await sizeOf(page);
      expect(Math.abs(width - BOX.width * ratio), `at ${ratio}`).toBeLessThanOrEqual(ratio);
      expect(Math.abs(height - BOX.height * ratio), `at ${ratio}`).toBeLessThanOrEqual(ratio);
    }
    await room.set({ "max-pixel-ratio": "1" });
    const [capped] = await sizeOf(page);
    await moveTo(3);
    expect(await sizeOf(page).then(([width]) => width)).toBe(capped);
  });

  test("also where a tool plays a denser monitor", async ({ browser }) => {
    const page = await browser.newPage({ deviceScaleFactor: 2 });
    await drawNothing(page);
    await openPage(page, html);
    await expect.poll(() => sizeOf(page)).toEqual([202, 116]);
    await setZoom(page, 0.5);
    await expect.poll(() => sizeOf(page)).toEqual([101, 58]);
    await page.close();
  });
});

/** Holds back the page's models. Returns what releases them. */
async function holdModels(page: Page): Promise<() => void> {
  let release = () => {};
  const released = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/\.glb$/, async (route) => {
    await released;
    await route.continue();
  });
  return release;
}

test.describe("A lost context", () => {
  test("that does not come back in five seconds ends in poster, sentence and button", async ({
    page,
  }) => {
    await page.clock.install({ time: 0 });
    await recordContexts(page);
    await serveSmallTextures(page);
    const room = await new RoomDriver(page).open(
      { look: "original", poster: PIXEL },
      { width: 320, height: 180 },
    );
    await page.clock.pauseAt(3_600_000);
    const before = await room.pixels();
    await room.stand({ yaw: 0.5 });
    const turned = await room.pixels();
    await room.evaluate((element) => {
      const errors: string[] = [];
      Object.assign(globalThis, { errors });
      element.addEventListener("error", ({ detail }) => errors.push(detail.type));
    });
    const errors = () => page.evaluate(() => Reflect.get(globalThis, "errors") as string[]);
    const lose = (index: number) =>
      room.evaluate(async (element, index) => {
        const lost = new Promise((resolve) =>
          element.addEventListener("contextlost", resolve, { once: true }),
        );
        const extension = contexts[index]?.getExtension("WEBGL_lose_context");
        Object.assign(globalThis, { extension });
        extension?.loseContext();
        await lost;
      }, index);
    const restore = () =>
      room.evaluate(async (element) => {
        const restored = new Promise((resolve) =>
          element.addEventListener("contextrestored", resolve, { once: true }),
        );
        (Reflect.get(globalThis, "extension") as WEBGL_lose_context).restoreContext();
        await restored;
      });
    const poster = page.locator("candle-flame").locator("[part~=poster]");
    const button = page.getByRole("button", { name: "Reload" });

    await lose(0);
    await expect(poster).toBeVisible();
    await room.set({ poster: `${PIXEL}#other` });
    await expect(poster).toHaveAttribute("src", `${PIXEL}#other`);
    await page.clock.runFor(4900);
    await expect(button).toHaveCount(0);
    await room.set({ controls: "" });
    await room.evaluate((element) => element.enter());
    expect(await room.isWalking()).toBe(true);
    await page.clock.runFor(200);
    expect(await room.isWalking(), "beside the button").toBe(false);
    await room.evaluate((element) => element.removeAttribute("controls"));
    await expect(button).toBeVisible();
    await expect(page.getByRole("alert")).toHaveText(/has not restored it\./);
    expect(await errors()).toEqual(["context-lost"]);

    await test.step("comes back late all the same", async () => {
      await restore();
      await expect(button).toHaveCount(0);
      await expect(poster).toBeHidden();
      expect(await room.pixels()).toBe(turned);
    });

    await test.step("in time, and nobody is asked", async () => {
      await lose(0);
      await page.clock.runFor(4000);
      await restore();
      await page.clock.runFor(10_000);
      await expect(button).toHaveCount(0);
      expect(await errors()).toEqual(["context-lost"]);
    });

    await test.step("by the button, with the visitor where he was", async () => {
      await room.set({ controls: "" });
      await lose(0);
      await page.clock.runFor(5000);
      await button.focus();
      await page.keyboard.press("Enter");
      await room.evaluate((element) => element.ready);
      expect(await room.isWalking(), "the key was for the button").toBe(false);
      await expect(button).toHaveCount(0);
      await expect(poster).toBeHidden();
      await expect(page.locator("candle-flame")).toBeFocused();
      expect(await room.pixels()).toBe(turned);
      await room.evaluate((element) => element.reset());
      expect(await room.pixels()).toBe(before);
    });
    expect(room.complaints).toEqual([]);
  });

  test("during loading only delays it", async ({ page }) => {
    await recordContexts(page);
    await serveSmallTextures(page);
    const release = await holdModels(page);
    const room = await new RoomDriver(page).load({ look: "original" }, { width: 32, height: 18 });
    await room.evaluate(async (element) => {
      const lost = new Promise((resolve) => element.addEventListener("contextlost", resolve));
      const loaded = new Promise<void>((resolve) =>
        element.addEventListener("progress", ({ detail }) => {
          if (detail.totalProgress === 1) resolve();
        }),
      );
      const extension = contexts[0]?.getExtension("WEBGL_lose_context");
      Object.assign(globalThis, { loaded, extension });
      extension?.loseContext();
      await lost;
    });
    release();
    await room.evaluate(async (element) => {
      await Reflect.get(globalThis, "loaded");
      await new Promise((resolve) => setTimeout(resolve));
      (Reflect.get(globalThis, "extension") as WEBGL_lose_context).restoreContext();
      await element.ready;
    });
    expect((await room.stats()).drawCalls).toBeGreaterThan(0);
    expect(room.complaints).toEqual([]);
  });
});

/** Whether the element's `ready` has resolved, or what it was rejected with. */
const outcomeOf = (room: RoomDriver) =>
  room.evaluate((element) =>
    Promise.race([
      element.ready.then(
        () => "resolved",
        (error: Error) => error.message,
      ),
      Promise.resolve().then(() => "pending"),
    ]),
  );

const loseContext = (room: RoomDriver) =>
  room.evaluate(async (element) => {
    const lost = new Promise((resolve) =>
      element.addEventListener("contextlost", resolve, { once: true }),
    );
    const extension = contexts[0]?.getExtension("WEBGL_lose_context");
    Object.assign(globalThis, { extension });
    extension?.loseContext();
    await lost;
  });

const restoreContext = (room: RoomDriver) =>
  room.evaluate(async (element) => {
    const restored = new Promise((resolve) =>
      element.addEventListener("contextrestored", resolve, { once: true }),
    );
    (Reflect.get(globalThis, "extension") as WEBGL_lose_context).restoreContext();
    await restored;
  });

test("A context that is lost for good while its room loads rejects `ready`, and comes back late all the same", async ({
  page,
}) => {
  await page.clock.install({ time: 0 });
  await recordContexts(page);
  await serveSmallTextures(page);
  const release = await holdModels(page);
  const room = await new RoomDriver(page).load({ look: "original" }, { width: 32, height: 18 });
  await page.clock.pauseAt(3_600_000);
  await loseContext(room);
  await page.clock.runFor(4900);
  expect(await outcomeOf(room)).toBe("pending");
  await page.clock.runFor(200);
  expect(await outcomeOf(room)).toMatch(/has not restored it/);
  release();
  await restoreContext(room);
  await room.evaluate((element) => element.ready);
  expect((await room.stats()).drawCalls).toBeGreaterThan(0);
  expect(room.complaints).toEqual([]);
});

test("A context that is lost for good while another room is fetched rejects `ready`, and comes back to wait for that room", async ({
  page,
}) => {
  await page.clock.install({ time: 0 });
  await recordContexts(page);
  const room = await new RoomDriver(page).open({}, { width: 32, height: 18 });
  await page.clock.pauseAt(3_600_000);
  const body = plainRoom({ min: [-2, 0, -2], max: [2, 2.6, 2] }, [], 0.5);
  /** Asks for another room, whose file is on its way as the context is lost, for more than five seconds. */
  const loseWhileFetching = async (name: string) => {
    const url = `${LIBRARY}${name}.glb`;
    const request = new Promise<() => Promise<void>>((resolve) => {
      void page.route(url, (route) =>
        resolve(() => route.fulfill({ contentType: "model/gltf-binary", body })),
      );
    });
    await room.evaluate((element, src) => {
      element.src = src;
    }, url);
    const answer = await request;
    await loseContext(room);
    await page.clock.runFor(5100);
    expect(await outcomeOf(room), name).toMatch(/has not restored it/);
    return answer;
  };
  const ready = () => room.evaluate((element) => element.ready);

  await test.step("which comes after it", async () => {
    const answer = await loseWhileFetching("later");
    await restoreContext(room);
    expect(await outcomeOf(room)).toBe("pending");
    await answer();
    await ready();
  });

  await test.step("which came before it", async () => {
    const answer = await loseWhileFetching("sooner");
    await room.evaluate((element) => {
      const load = new Promise<void>((resolve) =>
        element.addEventListener("load", () => resolve(), { once: true }),
      );
      Object.assign(globalThis, { load });
    });
    await answer();
    await page.evaluate(() => Reflect.get(globalThis, "load"));
    await restoreContext(room);
    await ready();
  });

  await test.step("which is not wanted any more", async () => {
    await loseWhileFetching("dropped");
    await room.evaluate((element) => {
      element.src = new URL("sooner.glb", document.baseURI).href;
    });
    await restoreContext(room);
    await ready();
  });
  expect(room.complaints).toEqual([]);
});

for (const scene of ["room", "candle"] as const) {
  test(`A context that is lost when it is made ends in a button that starts again: ${scene}`, async ({
    page,
  }) => {
    await page.addInitScript(() => {
      const { getContext } = HTMLCanvasElement.prototype;
      Object.assign(globalThis, { isLost: true });
      HTMLCanvasElement.prototype.getContext = function (...asked: [string]) {
        const context = getContext.apply(this, asked as never);
        const isLost = asked[0] === "webgl2" && Reflect.get(globalThis, "isLost");
        const gl = context as WebGL2RenderingContext | null;
        if (isLost) gl?.getExtension("WEBGL_lose_context")?.loseContext();
        return gl as never;
      };
    });
    const box = "width: 320px; height: 180px";
    const attributes = `scene="${scene}" look="paper" quality="low" paused style="${box}"`;
    await drawNothing(page);
    await openPage(page, `<candle-flame ${attributes}></candle-flame>`);
    const element = page.locator("candle-flame");
    const reload = element.locator("[part~=reload]");
    await expect(reload).toBeVisible();
    const failed = await element.evaluate(({ ready }: CandleFlameElement) =>
      ready.catch(({ name }: Error) => name),
    );
    expect(failed).toBe("ContextLostError");
    await page.evaluate(() => Object.assign(globalThis, { isLost: false }));
    await reload.click();
    const drawn = await element.evaluate(async (element: CandleFlameElement) => {
      await element.ready;
      return element.stats.drawCalls;
    });
    expect(drawn).toBeGreaterThan(0);
  });
}

test("More rooms than a browser has contexts wait with a sentence, and none in sight is evicted", async ({
  browser,
}) => {
  // On a phone, where browsers have half as many.
  const context = await browser.newContext({
    viewport: { width: 400, height: 300 },
    hasTouch: true,
    isMobile: true,
  });
  const page = await context.newPage();
  const complaints = complaintsOf(page);
  const one = `<candle-flame look="original" quality="low" paused style="width: 90px; height: 90px; display: inline-block"></candle-flame>`;
  await drawNothing(page);
  await openPage(page, `${one.repeat(9)}<div style="height: 2000px"></div>`);
  const rooms = page.locator("candle-flame");
  const opened = () =>
    rooms.evaluateAll((elements) => elements.map((element) => !element.matches(":state(loading)")));
  const seven = Array.from({ length: 7 }, () => true);
  await expect.poll(opened).toEqual([...seven, false, false]);
  const sentences = rooms.getByText(/opens once there is a place\.$/).filter({ visible: true });
  await expect(sentences).toHaveCount(2);
  expect(await lostContexts(page)).toEqual(seven.map(() => false));

  await test.step("a room that is taken out gives its place to the next", async () => {
    await rooms.first().evaluate((element) => element.remove());
    await expect.poll(opened).toEqual([...seven, false]);
    await expect(sentences).toHaveCount(1);
  });

  await test.step("a room that goes out of sight gives its place to one in sight", async () => {
    await rooms.first().evaluate((element: CandleFlameElement) => {
      element.step(0.5);
      element.extinguish();
      element.camera = { yaw: 1 };
      element.style.cssText += "; position: absolute; top: 1500px";
    });
    await expect.poll(opened).toEqual([false, ...seven]);
    await expect(sentences).toHaveCount(1);
  });

  await test.step("and goes on where it was, once there is a place", async () => {
    const moment = () =>
      rooms.first().evaluate(({ currentTime, lit, camera }: CandleFlameElement) => ({
        currentTime,
        lit,
        camera,
      }));
    const before = await moment();
    expect(before).toEqual({ currentTime: 0.5, lit: false, camera: expect.anything() });
    await rooms.last().evaluate((element) => element.remove());
    await expect.poll(opened).toEqual(seven);
    expect(await moment()).toEqual(before);
    expect(before.camera.yaw).toBe(1);
  });

  await test.step("and one that waits may become a lone candle", async () => {
    const states = await rooms.last().evaluate(async (element) => {
      const room = element.cloneNode() as CandleFlameElement;
      element.after(room);
      const states = [room.matches(":state(loading)")];
      room.scene = "candle";
      await room.ready;
      return [...states, room.matches(":state(alone)")];
    });
    expect(states).toEqual([true, true]);
    await expect(sentences).toHaveCount(0);
  });
  expect(complaints).toEqual([]);
  await context.close();
});
