import { readFileSync } from "node:fs";
import type { Page, Route } from "playwright/test";
import { graphicsErrors, lostContexts, recordContexts } from "../support/contexts.ts";
import { QUICK_ROOM } from "../support/plain-room.ts";
import { attributeValues } from "../support/random-values.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

// Dear, and each for itself: whichever worker is free takes the next.
test.describe.configure({ mode: "parallel" });

const TINY = { width: 32, height: 18 } as const;
const PIXEL = "data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACwAAAAAAQABAAACAkQBADs=" as const;

interface Failure {
  readonly type: string;
  readonly message: string;
  /** How often the element reported it. */
  readonly count: number;
  readonly isCauseAnError: boolean;
  /** Whether `ready` was rejected with the very cause. */
  readonly isReadyRejectedWithIt: boolean;
  readonly shown: string;
  readonly isReloadOffered: boolean;
  readonly isPosterShown: boolean;
  readonly isLoading: boolean;
}

/** Waits for the element to fail, and tells how. */
async function failureOf(room: RoomDriver): Promise<Failure> {
  const failure = await room.evaluate(async (element) => {
    const errors: { type: string; message: string; cause: unknown }[] = [];
    element.addEventListener("error", ({ detail }) => errors.push(detail));
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    document.body.append(element);
    const reason = await element.ready.then(
      () => "it is ready",
      (error: unknown) => error,
    );
    await new Promise((resolve) => setTimeout(resolve));
    const part = (name: string) => element.shadowRoot?.querySelector(`[part~=${name}]`);
    const [first] = errors;
    const sentence = part("error")?.querySelector("p");
    return {
      type: first?.type ?? "none",
      message: first?.message ?? String(reason),
      count: errors.length,
      isCauseAnError: first?.cause instanceof Error,
      isReadyRejectedWithIt: reason === first?.cause,
      shown: sentence?.checkVisibility() ? (sentence.textContent ?? "") : "",
      isReloadOffered: part("reload") !== null,
      isPosterShown: part("poster")?.checkVisibility() ?? false,
      isLoading: element.matches(":state(loading)"),
    };
  });
  return failure;
}

/** What every failure has in common: it is reported once, shown, and nothing is left hanging. */
function expectFailure(failure: Failure, type: string, sentence: RegExp): void {
  expect(failure).toEqual({
    type,
    message: expect.stringMatching(sentence),
    count: 1,
    isCauseAnError: true,
    isReadyRejectedWithIt: true,
    shown: failure.message,
    isReloadOffered: type === "asset",
    isPosterShown: true,
    isLoading: false,
  });
}

/** Exceptions and rejections that nobody caught; the browser's own notes of a 404 are none. */
const uncaught = (room: RoomDriver) =>
  room.complaints.filter((text) => !text.startsWith("Failed to load resource"));

const FAILURES: readonly {
  readonly name: string;
  readonly files: RegExp;
  readonly answer: (route: Route) => Promise<void>;
  readonly sentence: RegExp;
}[] = [
  {
    name: "A model that the network drops",
    files: /paper-candle\.glb$/,
    answer: (route) => route.abort("connectionreset"),
    sentence: /paper-candle\.glb .*\.$/,
  },
  {
    name: "A texture that is not there",
    files: /logs-normal\.\w+$/,
    answer: (route) => route.fulfill({ status: 404, body: "not found" }),
    sentence: /logs-normal\b.*\.$/,
  },
  {
    name: "A texture that is no picture",
    files: /logs-albedo\.\w+$/,
    answer: (route) => route.fulfill({ contentType: "image/jpeg", body: "no picture" }),
    sentence: /logs-albedo\b.*\.$/,
  },
];

for (const { name, files, answer, sentence } of FAILURES) {
  test(`${name} gives a sentence that names it, and no exception`, async ({ page }) => {
    await serveSmallTextures(page);
    await page.route(files, answer);
    const room = await new RoomDriver(page).load({ poster: PIXEL }, TINY);
    expectFailure(await failureOf(room), "asset", sentence);
    expect(uncaught(room)).toEqual([]);
  });
}

test("A room from an address that is none, or gone, or no room gives a sentence of ours, and leaves what was there", async ({
  page,
}) => {
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).open({}, TINY);
  const failures = await room.evaluate(async (shown) => {
    const failureOf = async (element: HTMLElementTagNameMap["candle-flame"], src: string) => {
      const failed = new Promise<{ type: string; message: string }>((resolve) =>
        element.addEventListener("error", ({ detail }) => resolve(detail), { once: true }),
      );
      element.src = src;
      document.body.append(element);
      const { type, message } = await failed;
      return `${type}: ${message}`;
    };
    const failures: Record<string, string> = {};
    for (const src of ["http://[", "/gone.glb", "/room.html", "ftp://host/room.glb"]) {
      failures[src] = await failureOf(shown, src);
    }
    const fresh = document.createElement("candle-flame");
    Object.assign(fresh, { look: "paper", quality: "low", paused: true });
    fresh.style.cssText = "width: 32px; height: 18px";
    const said = await failureOf(fresh, "http://[");
    const sentence = fresh.shadowRoot?.querySelector("[part~=error] p")?.textContent;
    const { ready } = fresh;
    fresh.src = "";
    const another = fresh.ready;
    await another;
    const mended = another !== ready && !fresh.matches(":state(loading)");
    fresh.remove();
    shown.step(1 / 60);
    return { ...failures, said, sentence, mended, stillThere: shown.stats.triangles > 0 };
  });
  const none = "The model's address is none that can be read: http://[";
  expect(failures).toEqual({
    "http://[": `asset: ${none}`,
    "/gone.glb": expect.stringMatching(/^asset: gone\.glb could not be fetched: .* 404.*\.$/),
    "/room.html": "asset: room.html is a web page, says its server (text/html).",
    "ftp://host/room.glb": "asset: room.glb could not be fetched.",
    said: `asset: ${none}`,
    sentence: none,
    mended: true,
    stillThere: true,
  });
  expect(uncaught(room).filter((text) => !text.includes("URL scheme"))).toEqual([]);
});

test("Code that does not know where it lies asks for an `asset-base`, and works with one, put back", async ({
  page,
}) => {
  await serveSmallTextures(page);
  await page.route(/\.js$/, async (route) => {
    const response = await route.fetch({ maxRetries: 3 });
    // As esbuild makes a script of a module.
    const body = (await response.text()).replaceAll("import.meta.url", "(void 0)");
    await route.fulfill({ response, body });
  });
  const room = await new RoomDriver(page).load({ poster: PIXEL }, TINY);
  expectFailure(await failureOf(room), "asset", /Set the attribute asset-base/);
  const state = await room.evaluate(async (element) => {
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    element.assetBase = "/";
    document.body.append(element);
    await element.ready;
    element.step(1 / 60);
    const sentence = element.shadowRoot?.querySelector("[part~=error]");
    return { isShown: sentence?.checkVisibility(), time: element.currentTime };
  });
  expect(state).toEqual({ isShown: false, time: expect.closeTo(1 / 60, 9) });
  expect((await room.stats()).drawCalls).toBeGreaterThan(0);
  expect(uncaught(room)).toEqual([]);
});

test("A failed element takes every call without an exception", async ({ page }) => {
  const room = await new RoomDriver(page).load({ "asset-base": "/nowhere/" }, TINY);
  await room.evaluate(async (element) => {
    await element.ready.catch(() => {});
    element.step(1);
    element.reset(2);
    element.place();
    element.take();
    element.play();
    element.enter();
    element.camera = { position: [0, 1, 0], yaw: 0, pitch: 0 };
    element.features.drift = false;
    element.look = "original";
    element.quality = "low";
    element.controls = true;
    element.style.width = "50px";
  });
  await page.evaluate(() => new Promise(requestAnimationFrame));
  expect(await room.evaluate((element) => element.stats.drawCalls)).toBe(0);
  expect(uncaught(room)).toEqual([]);
});

test("Without WebGL 2 there is a sentence and the poster", async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const models: string[] = [];
  page.on("request", (request) => {
    if (request.url().endsWith(".glb")) models.push(request.url());
  });
  const room = await new RoomDriver(page).load({ poster: PIXEL }, TINY);
  expectFailure(await failureOf(room), "webgl-unavailable", /WebGL 2.*\.$/);
  expect(models, "nothing is fetched in vain").toEqual([]);
  expect(uncaught(room)).toEqual([]);
});

test("Without WebGL 2 whoever inserts the element may listen for the error afterwards", async ({
  page,
}) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const room = await new RoomDriver(page).load({ poster: PIXEL }, TINY);
  const type = await room.evaluate(
    (element) =>
      new Promise((resolve) => {
        const other = element.cloneNode() as typeof element;
        other.ready.catch(() => {});
        element.replaceWith(other);
        other.addEventListener("error", ({ detail }) => resolve(detail.type));
      }),
  );
  expect(type).toBe("webgl-unavailable");
  const [background, state] = await room.evaluate(async (element) => {
    element.scene = "candle";
    await element.ready.catch(() => {});
    return [getComputedStyle(element).backgroundColor, element.matches(":state(alone)")];
  });
  expect([background, state], "nothing lies behind a lone candle").toEqual([
    "rgba(0, 0, 0, 0)",
    true,
  ]);
});

test("A shader that the driver refuses is named, and its context is given back", async ({
  page,
}) => {
  await recordContexts(page);
  await serveSmallTextures(page);
  await page.route(/\.js$/, async (route) => {
    const response = await route.fetch({ maxRetries: 3 });
    const body = (await response.text()).replaceAll("float peak=", "flot peak=");
    await route.fulfill({ response, body });
  });
  const room = await new RoomDriver(page).load({ poster: PIXEL }, TINY);
  expectFailure(await failureOf(room), "shader", /shaders\/lib\/srgb\.glsl:\d+: 'flot'/);
  expect(new Set(await lostContexts(page))).toEqual(new Set([true]));
  expect(uncaught(room)).toEqual([]);
});

/** A page whose contexts lack extensions. */
const withhold = (page: Page, names: readonly string[]) =>
  page.addInitScript((names) => {
    const { prototype } = WebGL2RenderingContext;
    const { getExtension } = prototype;
    prototype.getExtension = function (this: WebGL2RenderingContext, name: string) {
      return names.includes(name) ? null : Reflect.apply(getExtension, this, [name]);
    } as typeof getExtension;
  }, names);

test("A flame is bright in half floats, and a shader refused at a later change ends in a sentence and the poster, not in black", async ({
  page,
}) => {
  await recordContexts(page);
  await withhold(page, ["EXT_color_buffer_float"]); // one room for both, which is dear
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const { shaderSource } = prototype;
    prototype.shaderSource = function (shader, source) {
      const refused: unknown = Reflect.get(globalThis, "refused");
      const isRefused = typeof refused === "string" && source.includes(refused);
      shaderSource.call(this, shader, isRefused ? `${source}surplus;` : source);
    };
  });
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).open(
    { look: "physical", poster: PIXEL },
    // The flame is a pixel wide.
    { width: 96, height: 54, model: QUICK_ROOM },
  );
  const radiance = await room.evaluate((element) => [...element.readRadiance(0, 0, 96, 54)]);
  expect(Math.max(...radiance), "the flame, cd/m²").toBeGreaterThan(10);
  expect(await graphicsErrors(page)).toEqual([]);
  const failing = (refused: string, change: string) =>
    room.evaluate(
      async (element, { refused, change }) => {
        Object.assign(globalThis, { refused });
        const failed = new Promise<{ type: string; message: string }>((resolve) =>
          element.addEventListener("error", ({ detail }) => resolve(detail), { once: true }),
        );
        if (change === "gradient") element.features.gradient = false;
        else element.setAttribute("quality", change);
        const { type, message } = await failed;
        Object.assign(globalThis, { refused: null });
        const part = (name: string) => element.shadowRoot?.querySelector(`[part~=${name}]`);
        return {
          type,
          message,
          shown: part("error")?.textContent,
          isPosterShown: part("poster")?.checkVisibility(),
          hasCanvas: part("canvas") !== null,
        };
      },
      { refused, change },
    );
  const expected = (file: string) => {
    const message = expect.stringMatching(`shaders/${file}:\\d+: 'surplus'`);
    return { type: "shader", message, shown: message, isPosterShown: true, hasCanvas: false };
  };
  const tier = await failing("#define SHADOW_TAPS 8", "low");
  expect(tier).toEqual(expected("post/fullscreen.vert"));
  await room.evaluate(async (element) => {
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    element.look = "paper";
    document.body.append(element);
    await element.ready;
  });
  // Compiled when it is drawn for the first time.
  expect(await failing("#define GRADIENT 0", "gradient")).toEqual(expected("paper/particle.vert"));
  expect(uncaught(room)).toEqual([]);
});

test.describe("Where floats are not to be had", () => {
  test("a flame whose table cannot be of full floats looks the same", async ({ page }) => {
    await serveSmallTextures(page);
    const seen: number[][] = [];
    for (const withheld of [[], ["OES_texture_float_linear"]]) {
      await withhold(page, withheld);
      const room = await new RoomDriver(page).open({ scene: "candle" }, { width: 60, height: 90 });
      seen.push(await room.evaluate((element) => [...element.readRadiance(0, 0, 60, 90)]));
      expect(room.complaints).toEqual([]);
    }
    const [full = [], half = []] = seen;
    const brightest = Math.max(...full);
    expect(brightest, "cd/m²").toBeGreaterThan(1000);
    const errors = half.map((x, i) => Math.abs(x - (full[i] ?? 0)) / brightest);
    expect(Math.max(...errors)).toBeLessThan(0.01);
  });

  test("and without those either, the room is the paper's, and a sentence says so", async ({
    page,
  }) => {
    await withhold(page, ["EXT_color_buffer_float", "EXT_color_buffer_half_float"]);
    const models: string[] = [];
    page.on("request", (request) => {
      if (request.url().endsWith(".glb")) models.push(new URL(request.url()).pathname);
    });
    await serveSmallTextures(page);
    const room = await new RoomDriver(page).open({ look: "physical" }, TINY);
    const hint = page.locator("candle-flame").locator("[part~=hint]");
    await expect(hint).toHaveText(/^\s*This driver .* paper's look\.\s*$/);
    const scale = await hint.locator("p").evaluate((element) => getComputedStyle(element).scale);
    expect(scale, "without `controls`, too").toBe("none");
    expect(models.sort()).toEqual(["/models/paper-candle.glb", "/models/paper-room.glb"]);
    const picture = await room.pixels();
    await room.set({ look: "paper" });
    expect(await room.pixels()).toBe(picture);
    expect(room.complaints).toEqual([]);
  });

  test("and a lone candle ends in a sentence and the poster", async ({ page }) => {
    await withhold(page, ["EXT_color_buffer_float", "EXT_color_buffer_half_float"]);
    const room = await new RoomDriver(page).load({ scene: "candle", poster: PIXEL }, TINY);
    expectFailure(await failureOf(room), "graphics", /refuses a surface to draw on/);
  });
});

test("Boxes of one pixel, of none and of great length draw without an error", async ({ page }) => {
  await recordContexts(page);
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).open({}, { width: 1, height: 1 });
  await room.step(1 / 60);
  expect(await room.stats()).toMatchObject({ width: 1, height: 1 });
  for (const { width, height, quality } of [
    { width: 0, height: 0, quality: "medium" },
    { width: 0, height: 20, quality: "high" },
    { width: 5000, height: 20, quality: "medium" },
    { width: 20, height: 5000, quality: "low" },
    // Wider than the longest texture that SwiftShader knows.
    { width: 9000, height: 2, quality: "medium" },
    { width: 6000, height: 2, quality: "ultra" },
  ] as const) {
    await test.step(`${width} x ${height}, ${quality}`, async () => {
      const drawn = await room.evaluate(
        async (element, { width, height, quality }) => {
          element.quality = quality;
          element.style.width = `${width}px`;
          element.style.height = `${height}px`;
          await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
          element.step(1 / 60);
          return (await element.toBlob()).size;
        },
        { width, height, quality },
      );
      expect(drawn).toBeGreaterThan(0);
      expect(await graphicsErrors(page)).toEqual([]);
      expect(room.complaints).toEqual([]);
    });
  }
});

test("A room that cannot be seen is there all the same, once it can", async ({ page }) => {
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).load({}, TINY);
  await room.evaluate((element) => {
    element.hidden = true;
    element.step(1 / 60);
    return element.ready;
  });
  const size = await room.evaluate(async (element) => {
    element.hidden = false;
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    const { width, height } = element.stats;
    return [width, height];
  });
  expect(size).toEqual([32, 18]);
  expect(room.complaints).toEqual([]);
});

test("Six hundred rounds of random attributes and properties throw nothing, stop nothing and leave nothing", async ({
  page,
}) => {
  await recordContexts(page);
  await serveSmallTextures(page);
  // Whatever nonsense is asked for is there, since what cannot be fetched is another test's.
  const models = /(paper-candle|chamberstick)\.glb$/;
  await page.route(
    (url) => url.href.startsWith(LIBRARY) && !/\.(js|html|avif|png|webp)$/.test(url.pathname),
    (route) => {
      const [, name = "paper-room"] = models.exec(route.request().url()) ?? [];
      return route.fulfill({ body: readFileSync(`public/models/${name}.glb`) });
    },
  );
  const room = await new RoomDriver(page).open({}, { width: 8, height: 8 });
  const client = await page.context().newCDPSession(page);
  const countListeners = async () => {
    await page.evaluate(() => {
      globalThis.contexts = contexts.filter((context) => !context.isContextLost()); // nobody else's
    });
    // What ends in a later task is not yet garbage: the fewest of collections count, until eight of them find no fewer.
    let fewest = Infinity;
    for (let same = 0; same < 8; same++) {
      await client.send("HeapProfiler.collectGarbage");
      const { metrics } = await client.send("Performance.getMetrics");
      const found = metrics.find(({ name }) => name === "JSEventListeners");
      const value = found?.value ?? Number.NaN;
      if (value < fewest) [fewest, same] = [value, 0];
      await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 50)));
    }
    expect(fewest).toBeLessThan(Infinity);
    return fewest;
  };
  await client.send("Performance.enable");
  // Another scene starts anew, and would have to be waited for each time: both have their share.
  // A million particles are legal, but take SwiftShader minutes.
  const isQuick = (name: string, value: string | null) =>
    name !== "scene" && !(name === "particles" && Number.parseFloat(value ?? "") > 2000);
  const rounds = attributeValues(600).map((round) =>
    round.filter(({ name, value }) => isQuick(name, value)),
  );
  /** What is left of the rounds once nothing is set any more. */
  const rage = async (from: number, to: number) => {
    const left = await room.evaluate(
      async (element, rounds) => {
        for (const [i, round] of rounds.entries()) {
          for (const { name, value } of round) {
            const property = name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
            if (value === null) element.removeAttribute(name);
            else if (i % 2 === 0) element.setAttribute(name, value);
            else Reflect.set(element, property, value);
          }
          if (i % 16 === 0) element.step(1 / 120);
        }
        element.look = "paper";
        element.paused = true;
        element.quality = "medium";
        for (const name of element.getAttributeNames()) {
          if (!["look", "paused", "quality"].includes(name)) element.removeAttribute(name);
        }
        await element.ready;
        await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
        element.reset();
        element.step(1 / 60);
        const { gpuObjects, gpuBytes } = element.stats;
        return { gpuObjects, gpuBytes, time: element.currentTime };
      },
      rounds.slice(from, to),
    );
    return { ...left, listeners: await countListeners() };
  };
  const first = await rage(0, 150);
  const { gpuObjects, gpuBytes, time } = first;
  const second = await rage(150, 450);
  expect(second).toMatchObject({ gpuObjects, gpuBytes, time });
  expect(second.listeners).toBeLessThanOrEqual(first.listeners);
  await room.set({ scene: "candle" });
  await room.evaluate((element) => element.ready);
  // Listeners too, but for those that the collector still holds of the other scene.
  expect(await rage(450, 600)).toMatchObject({ gpuObjects, gpuBytes, time });
  expect(first.time).toBeCloseTo(1 / 60, 9);
  expect(first.gpuObjects).toBeGreaterThan(20);
  expect(await lostContexts(page)).toEqual([false]);
  expect(await graphicsErrors(page)).toEqual([]);
  expect(room.complaints).toEqual([]);
});
