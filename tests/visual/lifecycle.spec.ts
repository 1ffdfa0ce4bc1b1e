import type { Page } from "playwright/test";
import { graphicsErrors, lostContexts, recordContexts } from "../support/contexts.ts";
import { QUICK_ROOM } from "../support/plain-room.ts";
import { type Attributes, type Opening, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

// Dear, and each for itself: whichever worker is free takes the next.
test.describe.configure({ mode: "parallel" });

const TINY = { width: 32, height: 18 } as const;

async function openRecorded(
  page: Page,
  attributes: Attributes = {},
  opening: Opening = {},
): Promise<RoomDriver> {
  await recordContexts(page);
  await serveSmallTextures(page);
  return new RoomDriver(page).open(attributes, { ...TINY, ...opening });
}

test("Taken out and put back seventeen times, an element leaves nothing behind", async ({
  page,
}) => {
  const times = 17; // one more than a browser has contexts
  const room = await openRecorded(page, { look: "original" }, { model: QUICK_ROOM }); // it has the fewest programs
  // A neighbour, whose context the others' must never evict.
  await page.evaluate(async () => {
    const neighbour = document.createElement("candle-flame");
    neighbour.id = "neighbour";
    neighbour.look = "paper";
    neighbour.quality = "low";
    neighbour.paused = true;
    neighbour.style.cssText = "width: 32px; height: 18px";
    document.body.append(neighbour);
    await neighbour.ready;
    neighbour.addEventListener("contextlost", () =>
      console.error("the neighbour lost its context"),
    );
  });
  const { before, counts } = await page.evaluate(async (times) => {
    const element = document.querySelector("candle-flame"); // the first
    if (!element) throw new Error("no element");
    const before = element.stats;
    // What is made is counted, whatever is drawn.
    Object.assign(WebGL2RenderingContext.prototype, { drawArrays() {}, drawElements() {} });
    const counts: { gpuObjects: number; gpuBytes: number }[] = [];
    for (let i = 0; i < times; i++) {
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
      document.body.append(element);
      await element.ready;
      const { gpuObjects, gpuBytes } = element.stats;
      counts.push({ gpuObjects, gpuBytes });
    }
    return { before, counts };
  }, times);
  const { gpuObjects, gpuBytes } = before;
  expect(gpuObjects).toBeGreaterThan(20);
  expect(counts).toEqual(Array.from({ length: times }, () => ({ gpuObjects, gpuBytes })));
  // In order: its first context, the neighbour's, and one for each return.
  const lost = await lostContexts(page);
  expect(lost).toEqual([true, false, ...Array.from({ length: times - 1 }, () => true), false]);
  expect(await page.evaluate(() => document.querySelectorAll("canvas").length)).toBe(0);
  expect(await graphicsErrors(page)).toEqual([]);
  expect(room.complaints).toEqual([]);
});

test("Moved, resized and changed, an element goes on and holds no more than before", async ({
  page,
}) => {
  const room = await openRecorded(page);
  const before = await room.stats();

  await test.step("moved within the page", async () => {
    await room.step(0.2);
    await room.stand({ yaw: 1 });
    const picture = await room.pixels();
    const events = await room.evaluate(async (element) => {
      const events: string[] = [];
      for (const type of ["load", "progress", "error", "contextlost"] as const) {
        element.addEventListener(type, () => events.push(type));
      }
      const elsewhere = document.createElement("section");
      document.body.append(elsewhere);
      elsewhere.append(element);
      await new Promise((resolve) => setTimeout(resolve));
      return events;
    });
    expect(events).toEqual([]);
    expect(await room.pixels()).toBe(picture);
    expect(await room.evaluate((element) => element.currentTime)).toBeCloseTo(0.2, 9);
  });

  await test.step("resized twenty times", async () => {
    const sizes = await room.evaluate(async (element) => {
      const sizes: string[] = [];
      for (let i = 1; i <= 20; i++) {
        element.style.width = `${32 + (i % 4) * 16}px`;
        element.style.height = `${18 + (i % 3) * 12}px`;
        // The observer of sizes runs within the frame, after its callbacks.
        await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
        const { width, height, gpuObjects } = element.stats;
        sizes.push(`${width}x${height} ${gpuObjects}`);
      }
      element.style.width = "32px";
      element.style.height = "18px";
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      return sizes;
    });
    const expected = Array.from({ length: 20 }, (_, i) => {
      const width = 32 + ((i + 1) % 4) * 16;
      const height = 18 + ((i + 1) % 3) * 12;
      return `${width}x${height} ${before.gpuObjects}`;
    });
    expect(sizes).toEqual(expected);
    const { gpuObjects, gpuBytes } = await room.stats();
    expect({ gpuObjects, gpuBytes }).toEqual({
      gpuObjects: before.gpuObjects,
      gpuBytes: before.gpuBytes,
    });
  });

  await test.step("with other looks, seeds, particles and qualities", async () => {
    await room.evaluate((element) => {
      for (let i = 0; i < 2; i++) {
        for (const look of ["original", "paper"] as const) element.look = look;
        for (const quality of ["low", "high", "ultra", "medium"] as const)
          element.quality = quality;
        element.particles = 500 + i;
        element.seed = i;
        element.features.drift = false;
        element.features.drift = true;
        element.step(1 / 60);
      }
      for (const name of element.getAttributeNames()) {
        if (!["paused", "look", "quality"].includes(name)) element.removeAttribute(name);
      }
      element.step(1 / 60);
    });
    const { gpuObjects, gpuBytes } = await room.stats();
    expect({ gpuObjects, gpuBytes }).toEqual({
      gpuObjects: before.gpuObjects,
      gpuBytes: before.gpuBytes,
    });
  });
  expect(await lostContexts(page)).toEqual([false]);

  await test.step("playing, while its context is lost and afterwards", async () => {
    const times = await room.evaluate(async (element) => {
      const frames = async (count: number) => {
        for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
      };
      element.play();
      await frames(3);
      const extension = contexts[0]?.getExtension("WEBGL_lose_context");
      const lost = new Promise((resolve) => element.addEventListener("contextlost", resolve));
      extension?.loseContext();
      await lost;
      const times = [element.currentTime];
      await frames(3);
      times.push(element.currentTime);
      const restored = new Promise((resolve) =>
        element.addEventListener("contextrestored", resolve),
      );
      extension?.restoreContext();
      await restored;
      await frames(5);
      times.push(element.currentTime);
      element.pause();
      return times;
    });
    const [lost = 0, still = 0, again = 0] = times;
    expect(still).toBe(lost);
    expect(again).toBeGreaterThan(lost);
  });
  expect(await graphicsErrors(page)).toEqual([]);
  expect(room.complaints).toEqual([]);
});

test("An element taken out while it loads gives its context back, and loads when put back", async ({
  page,
}) => {
  const room = await openRecorded(page);
  await page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    Object.assign(element, { look: "paper", quality: "low", paused: true });
    element.style.cssText = "width: 32px; height: 18px";
    document.body.append(element);
    await new Promise((resolve) => element.addEventListener("progress", resolve, { once: true }));
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    if (element.shadowRoot?.querySelector("canvas")) throw new Error("a canvas is left");
    document.body.append(element);
    await element.ready;
    element.step(1 / 60);
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
  });
  expect(await lostContexts(page)).toEqual([false, true, true]);
  expect(room.complaints).toEqual([]);
});

test("Waiting for an element that is taken out ends with an error, and a new wait succeeds", async ({
  room,
}) => {
  const outcome = await room.page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    element.look = "paper";
    element.paused = true;
    element.style.cssText = "width: 32px; height: 18px";
    document.body.append(element);
    const { ready } = element;
    element.remove();
    const reason = await ready.catch(({ name }: Error) => name);
    const isNew = element.ready !== ready;
    document.body.append(element);
    // Still the same wait, though for something else.
    const second = element.ready;
    element.scene = "candle";
    const isSame = element.ready === second;
    await second;
    const { drawCalls } = element.stats;
    element.remove();
    return { reason, isNew, isSame, drawCalls };
  });
  expect(outcome).toEqual({
    reason: "AbortError",
    isNew: true,
    isSame: true,
    drawCalls: expect.any(Number),
  });
  expect(outcome.drawCalls).toBeGreaterThan(0);
});

test("In a shadow tree, in another document, and home again, an element draws in its box", async ({
  room,
}) => {
  const seen = await room.page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    Object.assign(element, { scene: "candle", paused: true, quality: "high" });
    element.style.cssText = "width: 64px; height: 36px";
    const host = document.createElement("div");
    const frame = document.createElement("iframe");
    document.body.append(host, frame);
    const seen: unknown[] = [];
    const homes = [
      host.attachShadow({ mode: "closed" }),
      frame.contentDocument?.body,
      document.body,
    ];
    for (const home of homes) {
      home?.append(element);
      await new Promise((resolve) => setTimeout(resolve));
      await element.ready;
      const canvas = element.shadowRoot?.querySelector("canvas");
      const { width, drawCalls } = element.stats;
      // A shadow tree without its style has its canvas amid the text.
      const style = canvas && getComputedStyle(canvas).position;
      seen.push([element.ownerDocument === document, style, width, drawCalls > 0]);
    }
    for (const one of [element, host, frame]) one.remove();
    return seen;
  });
  expect(seen).toEqual([true, false, true].map((isHome) => [isHome, "absolute", 64, true]));
  expect(room.complaints).toEqual([]);
});

for (const isAdopted of [false, true]) {
  test(`${isAdopted ? "Adopted by" : "Moved to"} another document at once, an element goes on there, in the room that it showed`, async ({
    room,
  }) => {
    const outcome = await room.page.evaluate(async (isAdopted) => {
      const element = document.createElement("candle-flame");
      Object.assign(element, { look: "paper", paused: true, quality: "low" });
      element.style.cssText = "width: 64px; height: 36px";
      const frame = document.createElement("iframe");
      document.body.append(frame, element);
      const errors: string[] = [];
      element.addEventListener("error", ({ detail }) => errors.push(detail.type));
      await element.ready;
      element.step(0.5);
      element.src = "define.js"; // no model
      await new Promise((resolve) => element.addEventListener("error", resolve, { once: true }));
      const { ready } = element;
      if (isAdopted) frame.contentDocument?.adoptNode(element);
      frame.contentDocument?.body.append(element);
      const isNew = element.ready !== ready;
      await element.ready;
      const outcome = {
        isNew,
        errors,
        time: element.currentTime,
        drawn: element.stats.triangles > 0,
      };
      for (const one of [element, frame]) one.remove();
      return outcome;
    }, isAdopted);
    const errors = ["asset", "asset"];
    expect(outcome).toEqual({ isNew: true, errors, time: expect.closeTo(0.5), drawn: true });
  });
}

test("In another window an element has that window's frames, playing and paused", async ({
  room,
}) => {
  const outcome = await room.page.evaluate(async () => {
    const frame = document.createElement("iframe");
    document.body.append(frame);
    const element = document.createElement("candle-flame");
    Object.assign(element, { look: "paper", quality: "low" });
    element.style.cssText = "width: 64px; height: 36px";
    frame.contentDocument?.body.append(element);
    await element.ready;
    // As in a popup or a picture in picture, of which the opener is hidden.
    const request = window.requestAnimationFrame;
    window.requestAnimationFrame = () => 0;
    const framesUntil = async (isDone: () => boolean) => {
      for (let i = 0; i < 300 && !isDone(); i++)
        await new Promise((resolve) => frame.contentWindow?.requestAnimationFrame(resolve));
      return isDone();
    };
    element.pause();
    const time = element.currentTime;
    element.play();
    const plays = await framesUntil(() => element.currentTime > time);
    element.pause();
    const drawn = new Promise((resolve) => {
      const { clear } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.clear = function (mask) {
        WebGL2RenderingContext.prototype.clear = clear;
        clear.call(this, mask);
        resolve(true);
      };
    });
    element.exposure = 1;
    const draws = await Promise.race([drawn, framesUntil(() => false)]);
    window.requestAnimationFrame = request;
    for (const one of [element, frame]) one.remove();
    return { plays, draws };
  });
  expect(outcome).toEqual({ plays: true, draws: true });
});

test("In another document a model's address is relative to that document", async ({ room }) => {
  const { page } = room;
  await page.route("**/nested/room.glb", (route) =>
    route.fulfill({ contentType: "model/gltf-binary", body: QUICK_ROOM }),
  );
  const errors = await page.evaluate(async () => {
    const frame = document.createElement("iframe");
    document.body.append(frame);
    const { contentDocument } = frame;
    const base = contentDocument?.createElement("base");
    if (!contentDocument || !base) throw new Error("The frame has no document.");
    base.href = "/nested/";
    contentDocument.head.append(base);
    const element = document.createElement("candle-flame");
    Object.assign(element, { look: "physical", quality: "low", paused: true, src: "room.glb" });
    element.style.cssText = "width: 64px; height: 36px";
    const errors: string[] = [];
    element.addEventListener("error", ({ detail }) => errors.push(detail.message));
    contentDocument.body.append(element);
    await element.ready.catch(() => {});
    for (const one of [element, frame]) one.remove();
    return errors;
  });
  expect(errors).toEqual([]);
});

test("What is set while another look loads is done to the one on show", async ({ page }) => {
  await serveSmallTextures(page);
  let release = () => {};
  const released = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/cabin\.glb$/, async (route) => {
    await released;
    await route.fulfill({ contentType: "model/gltf-binary", body: QUICK_ROOM });
  });
  const room = await new RoomDriver(page).open({ exposure: "1", quality: "low" }, TINY);
  const bright = await room.pixels();
  await room.set({ exposure: "0" });
  await room.set({ look: "physical", exposure: "1", seed: "1" });
  expect(await room.pixels()).toBe(bright);
  const loads = await room.evaluate(async (element) => {
    let loads = 0;
    element.addEventListener("load", () => loads++);
    element.look = "paper"; // after all
    await new Promise((resolve) => setTimeout(resolve));
    return loads;
  });
  expect(loads, "it is there already").toBe(0);
  expect(await room.pixels()).toBe(bright);
  await room.set({ look: "physical" });
  await room.stand({ yaw: 2 });
  expect((await room.camera()).yaw, "of the room on show").toBe(2);
  await room.evaluate((element) => {
    const loaded = new Promise((resolve) =>
      element.addEventListener("load", resolve, { once: true }),
    );
    Object.assign(globalThis, { loaded });
  });
  release();
  await room.evaluate(() => (globalThis as unknown as { loaded: Promise<unknown> }).loaded);
  expect(await room.pixels()).not.toBe(bright);
  expect((await room.camera()).yaw, "and of the one that comes").toBe(2);
  expect(room.complaints).toEqual([]);
});

test("A look set while the first one loads is the one that comes", async ({ room }) => {
  await room.set({ look: "original" });
  const isSame = await room.evaluate(async (first) => {
    const second = document.createElement("candle-flame");
    second.paused = true;
    second.quality = "medium";
    second.style.cssText = "width: 160px; height: 90px";
    document.body.append(second);
    second.look = "original";
    await second.ready;
    const [one, other] = await Promise.all(
      [first, second].map(async (element) => (await element.toBlob()).arrayBuffer()),
    );
    second.remove();
    return String(new Uint8Array(one ?? [])) === String(new Uint8Array(other ?? []));
  });
  expect(isSame).toBe(true);
});

test("A model that fails while the first room is prepared leaves that room", async ({ room }) => {
  const outcome = await room.evaluate(async (shown) => {
    const element = document.createElement("candle-flame");
    Object.assign(element, { look: "paper", quality: "low", paused: true });
    const { linkProgram } = WebGL2RenderingContext.prototype;
    const begun = new Promise<void>((resolve) => {
      WebGL2RenderingContext.prototype.linkProgram = function (program) {
        linkProgram.call(this, program);
        resolve();
      };
    });
    shown.after(element);
    await begun;
    WebGL2RenderingContext.prototype.linkProgram = linkProgram;
    const failed = new Promise<string>((resolve) =>
      element.addEventListener("error", ({ detail }) => resolve(detail.type)),
    );
    element.src = "data:model/gltf-binary,nonsense";
    const outcome = [await failed, await element.ready, element.candles.length];
    element.remove();
    return outcome;
  });
  expect(outcome).toEqual(["asset", undefined, 1]);
});

test("`ready` waits for the room that was asked for before the first frame", async ({ page }) => {
  const room = await openRecorded(page, { look: "original" }, { model: QUICK_ROOM });
  await page.route(/later\.glb$/, async (route) => {
    await route.fulfill({ contentType: "model/gltf-binary", body: QUICK_ROOM });
  });
  const outcomes = await room.evaluate(async (shown) => {
    const { fetch } = globalThis;
    const outcomes: unknown[] = [];
    for (const src of ["later.glb", "define.js", ""]) {
      // The file arrives once the room before it is on show.
      let release = () => {};
      const released = new Promise<void>((resolve) => {
        release = resolve;
      });
      globalThis.fetch = async (input, init) => {
        const { url } = new Request(input);
        if (/later\.glb|define\.js/.test(url)) await released;
        return fetch(input, init);
      };
      const element = document.createElement("candle-flame");
      Object.assign(element, { look: "paper", quality: "low", paused: true });
      const events: string[] = [];
      for (const type of ["load", "error"]) element.addEventListener(type, () => events.push(type));
      const { linkProgram } = WebGL2RenderingContext.prototype;
      const begun = new Promise<void>((resolve) => {
        WebGL2RenderingContext.prototype.linkProgram = function (program) {
          linkProgram.call(this, program);
          resolve();
        };
      });
      const first = new Promise((resolve) =>
        element.addEventListener("load", resolve, { once: true }),
      );
      void element.ready.then(() => events.push("ready"));
      shown.after(element);
      await begun;
      WebGL2RenderingContext.prototype.linkProgram = linkProgram;
      element.src = src || "later.glb";
      await first;
      await new Promise((resolve) => setTimeout(resolve));
      events.push("released");
      if (src === "") element.src = "";
      else release();
      await element.ready;
      await new Promise((resolve) => setTimeout(resolve));
      outcomes.push(events);
      element.remove();
    }
    Object.assign(globalThis, { fetch });
    return outcomes;
  });
  expect(outcomes, "fetched, missing, and not asked for any more").toEqual([
    ["load", "released", "load", "ready"],
    ["load", "released", "error", "ready"],
    ["load", "released", "ready"],
  ]);
});

test("However much is set, one frame shows it", async ({ room }) => {
  const frames = await room.evaluate(async (element) => {
    let clears = 0;
    const { prototype } = WebGL2RenderingContext;
    const { clear } = prototype;
    prototype.clear = function (mask) {
      clears++;
      clear.call(this, mask);
    };
    const inTwoFrames = async (change: () => void) => {
      clears = 0;
      change();
      for (let i = 0; i < 2; i++) await new Promise(requestAnimationFrame);
      return clears;
    };
    try {
      element.camera = { ...element.camera, yaw: 0.4 };
      const one = await inTwoFrames(() => element.step(0));
      const set = await inTwoFrames(() => {
        element.camera = { ...element.camera, yaw: 0.5 };
        element.features.drift = false;
        element.exposure = 0.5;
      });
      const stepped = await inTwoFrames(() => {
        element.camera = { ...element.camera, yaw: 0.6 };
        element.features.drift = true;
        element.step(1 / 60);
      });
      const same = await inTwoFrames(() => {
        element.features.drift = true;
      });
      return [set / one, stepped / one, same];
    } finally {
      prototype.clear = clear;
    }
  });
  expect(frames).toEqual([1, 1, 0]);
});

test("A lost context given back shows the very same picture", async ({ page }) => {
  await recordContexts(page);
  await serveSmallTextures(page);
  const room = await new RoomDriver(page).open({}, { width: 96, height: 54 });
  await room.step(1 / 15, 2);
  const picture = await room.pixels();
  const { gpuObjects, gpuBytes } = await room.stats();
  for (let loss = 0; loss < 2; loss++) {
    const events = await room.evaluate(async (element) => {
      const events: string[] = [];
      const stop = new AbortController();
      const happens = (type: "contextlost" | "contextrestored") =>
        new Promise<void>((resolve) => {
          const note = () => {
            events.push(type);
            resolve();
          };
          element.addEventListener(type, note, { signal: stop.signal });
        });
      const extension = contexts[0]?.getExtension("WEBGL_lose_context");
      const lost = happens("contextlost");
      const restored = happens("contextrestored");
      extension?.loseContext();
      await lost;
      element.step(0); // nothing to draw on, and no harm
      // The browser learns that it is wanted back only after the event's task.
      await new Promise((resolve) => setTimeout(resolve));
      extension?.restoreContext();
      await restored;
      stop.abort();
      return events;
    });
    expect(events).toEqual(["contextlost", "contextrestored"]);
    expect(await room.pixels()).toBe(picture);
    expect(await room.stats()).toMatchObject({ gpuObjects, gpuBytes });
  }
  await room.stand({ yaw: 2 });
  expect(await room.pixels()).not.toBe(picture);
  expect(await graphicsErrors(page)).toEqual([]);
  expect(room.complaints).toEqual([]);
});

test("A context lost again while it is restored is reported lost once and restored once", async ({
  page,
}) => {
  await recordContexts(page);
  const room = await new RoomDriver(page).open({ look: "paper" }, { width: 96, height: 54 });
  const events = await room.evaluate(async (element) => {
    const events: string[] = [];
    for (const type of ["contextlost", "contextrestored"]) {
      element.addEventListener(type, () => events.push(type));
    }
    const canvas = element.shadowRoot?.querySelector("canvas");
    const happens = (type: string, target: EventTarget | null | undefined) =>
      new Promise((resolve) => target?.addEventListener(type, resolve, { once: true }));
    const extension = contexts[0]?.getExtension("WEBGL_lose_context");
    element.play();
    for (let loss = 0; loss < 2; loss++) {
      const lost = happens("webglcontextlost", canvas);
      extension?.loseContext();
      await lost;
      // The browser learns that it is wanted back only after the event's task.
      await new Promise((resolve) => setTimeout(resolve));
      const restored = happens("webglcontextrestored", canvas);
      const drawn = happens("contextrestored", element);
      extension?.restoreContext();
      await (loss === 0 ? restored : drawn);
    }
    element.pause();
    return events;
  });
  expect(events).toEqual(["contextlost", "contextrestored"]);
  expect(room.complaints).toEqual([]);
});

test("A context lost while the driver answers about a program comes back", async ({ page }) => {
  // A GPU that is reset does so at a program's first draw, when its uniforms and blocks are asked for.
  await page.addInitScript(() => {
    const prototype = WebGL2RenderingContext.prototype;
    const ask = prototype.getActiveUniform;
    let questions = 0;
    prototype.getActiveUniform = function (...question) {
      questions++;
      if (questions === 3) {
        const extension = this.getExtension("WEBGL_lose_context");
        extension?.loseContext();
        // The browser learns that it is wanted back only after the event's task.
        this.canvas.addEventListener(
          "webglcontextlost",
          () => setTimeout(() => extension?.restoreContext()),
          { once: true },
        );
      }
      return ask.apply(this, question);
    };
  });
  const room = await new RoomDriver(page).load({}, TINY);
  const event = await room.evaluate(
    (element) =>
      new Promise((resolve) => {
        for (const type of ["load", "error"]) {
          element.addEventListener(type, () => resolve(type), { once: true });
        }
      }),
  );
  expect(event).toBe("load");
  expect(room.complaints).toEqual([]);
});
