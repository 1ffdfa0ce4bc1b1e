import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

test("Loading is reported as it goes on, ends at 1, and ends with `load` and `ready`", async ({
  room,
}) => {
  const { progress, order, bubbled } = await room.page.evaluate(async () => {
    const progress: number[] = [];
    const order: string[] = [];
    const bubbled: string[] = [];
    const element = document.createElement("candle-flame");
    element.look = "paper";
    element.quality = "low";
    element.style.cssText = "width: 32px; height: 18px";
    for (const type of ["progress", "load", "error", "play", "pause", "camerachange"]) {
      element.addEventListener(type, () => order.push(type));
      document.body.addEventListener(type, () => bubbled.push(type));
    }
    element.addEventListener("progress", ({ detail }) => progress.push(detail.totalProgress));
    document.body.append(element);
    await element.ready.then(() => order.push("ready"));
    element.pause();
    element.step(0);
    element.camera = { ...element.camera, yaw: 1 };
    element.remove();
    return { progress, order, bubbled };
  });
  expect(progress.length).toBeGreaterThan(2);
  expect(progress).toEqual([...progress].sort((a, b) => a - b));
  expect(progress[0]).toBeGreaterThanOrEqual(0);
  expect(progress.at(-1)).toBe(1);
  const rest = order.slice(order.lastIndexOf("progress") + 1);
  expect(rest).toEqual(["play", "load", "ready", "pause", "camerachange"]);
  expect(bubbled).toEqual([]);
});

test("A bar shows how far loading is, moves while the first frame is prepared, and is gone afterwards", async ({
  room,
}) => {
  const { shown, moves, left } = await room.page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    element.look = "paper";
    element.quality = "low";
    const bar = element.shadowRoot?.querySelector<HTMLElement>("[part~=progress]");
    const shown: number[] = [];
    const moves: boolean[] = [];
    element.addEventListener("progress", ({ detail }) => {
      moves.push(bar?.getAnimations().length === 1);
      if (detail.totalProgress === 1) return;
      const width = bar?.getBoundingClientRect().width ?? Number.NaN;
      shown.push(bar?.checkVisibility() ? Math.abs(width / 200 - detail.totalProgress) : 1);
    });
    element.style.cssText = "width: 200px; height: 20px";
    element.paused = true;
    document.body.append(element);
    await element.ready;
    const left = bar?.checkVisibility();
    element.remove();
    return { shown, moves, left };
  });
  expect(shown.length).toBeGreaterThan(1);
  expect(moves.indexOf(true), "once everything is fetched").toBe(shown.length);
  expect(moves.lastIndexOf(false)).toBe(shown.length - 1);
  expect(Math.max(...shown), "width beside progress").toBeLessThan(0.01);
  expect(left).toBe(false);
});

test("Playing and pausing are reported once each, when they happen", async ({ room }) => {
  const events = await room.evaluate((element) => {
    const events: string[] = [];
    const stop = new AbortController();
    for (const type of ["play", "pause"] as const) {
      const note = () => events.push(`${type} ${element.paused}`);
      element.addEventListener(type, note, { signal: stop.signal });
    }
    element.play();
    element.play();
    element.setAttribute("paused", "");
    element.pause();
    element.removeAttribute("paused");
    element.paused = true;
    stop.abort();
    return events;
  });
  expect(events).toEqual(["play false", "pause true", "play false", "pause true"]);
});

test("A removal while time passes is reported as a pause, once", async ({ room }) => {
  const events = await room.page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    element.look = "paper";
    element.quality = "low";
    element.style.cssText = "width: 32px; height: 18px";
    document.body.append(element);
    await element.ready;
    const events: string[] = [];
    for (const type of ["play", "pause"]) element.addEventListener(type, () => events.push(type));
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    element.paused = true;
    document.body.append(element);
    await element.ready;
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    return events;
  });
  expect(events).toEqual(["pause"]);
});

test("A candle put out before insertion stays out after removals, while it loads and later", async ({
  room,
}) => {
  const lit = await room.page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    element.look = "paper";
    element.quality = "low";
    element.paused = true;
    element.style.cssText = "width: 32px; height: 18px";
    element.lit = false;
    document.body.append(element);
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    const lit = [element.lit];
    document.body.append(element);
    await element.ready;
    lit.push(element.lit);
    element.remove();
    await new Promise((resolve) => setTimeout(resolve));
    return [...lit, element.lit];
  });
  expect(lit).toEqual([false, false, false]);
});

test("The camera's moves are reported, and only moves", async ({ room }) => {
  const counts = await room.evaluate((element) => {
    let count = 0;
    const stop = new AbortController();
    element.addEventListener("camerachange", () => count++, { signal: stop.signal });
    const counts = [count];
    const { camera } = element;
    element.camera = { ...camera, yaw: camera.yaw + 0.1 };
    counts.push(count);
    element.camera = { ...camera, yaw: camera.yaw + 0.1 };
    element.step(1 / 60);
    counts.push(count);
    element.reset();
    counts.push(count);
    element.camera = { ...camera, pitch: 0.2 };
    element.seed = 9; // begins anew, where one begins
    counts.push(count);
    element.look = "original";
    counts.push(count);
    element.camera = { ...camera, position: [20, 1.6, 0] };
    element.look = "paper"; // whose walls are solid
    counts.push(count);
    stop.abort();
    return counts;
  });
  expect(counts).toEqual([0, 1, 1, 2, 4, 4, 6]);
});

test("No event of the element bubbles", async ({ room }) => {
  const { eventTypes, left } = await room.evaluate((element) => {
    const types = ["play", "pause", "place", "take", "camerachange", "progress", "load", "error"];
    const eventTypes: string[] = [];
    const left: string[] = [];
    const stop = new AbortController();
    for (const type of types) {
      element.addEventListener(type, () => eventTypes.push(type), { signal: stop.signal });
      document.addEventListener(type, () => left.push(type), { signal: stop.signal });
    }
    element.look = "paper";
    element.quality = "low";
    element.play();
    element.pause();
    element.place();
    element.take();
    element.camera = { ...element.camera, pitch: 0.3 };
    stop.abort();
    return { eventTypes, left };
  });
  expect(eventTypes).toEqual(["play", "pause", "place", "take", "camerachange"]);
  expect(left).toEqual([]);
});

test("Properties set before the element is defined hold when it is", async ({ page }) => {
  const body = `<!doctype html><title>test</title>
    <candle-flame style="width: 64px; height: 36px"></candle-flame>
    <script>
      Object.assign(document.querySelector("candle-flame"), {
        look: "original", quality: "medium", paused: true, seed: 12, exposure: -1, controls: true, alt: "Early",
        maxPixelRatio: 0.5, camera: { position: [0, 1.5, 1], yaw: 0.25, pitch: 0.125 },
        features: { normalMaps: false },
      });
    </script>
    <script type="module" src="/define.js"></script>`;
  await page.route(`${LIBRARY}early.html`, (route) =>
    route.fulfill({ contentType: "text/html", body }),
  );
  const room = new RoomDriver(page);
  await page.goto(`${LIBRARY}early.html`);
  await page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
  const found = await room.evaluate(async (element) => {
    await element.ready;
    const { look, paused, seed, exposure, controls, alt, maxPixelRatio, camera, stats } = element;
    const own = Object.keys(element);
    const { normalMaps } = element.features;
    const { width } = stats;
    return {
      look,
      paused,
      seed,
      exposure,
      controls,
      alt,
      maxPixelRatio,
      camera,
      normalMaps,
      width,
      own,
    };
  });
  expect(found).toEqual({
    look: "original",
    paused: true,
    seed: 12,
    exposure: -1,
    controls: true,
    alt: "Early",
    maxPixelRatio: 0.5,
    camera: { position: [0, 1.5, 1], yaw: 0.25, pitch: 0.125, fieldOfView: Math.PI / 4 },
    normalMaps: false,
    width: 32,
    own: [],
  });
  expect(room.complaints).toEqual([]);
});

test("A camera set while the models load is where the first frame is seen from", async ({
  room,
}) => {
  const camera = await room.page.evaluate(async () => {
    const element = document.createElement("candle-flame");
    element.look = "paper";
    element.quality = "low";
    element.style.cssText = "width: 32px; height: 18px";
    element.paused = true;
    document.body.append(element);
    element.camera = { position: [1, 1.5, 1], yaw: 1, pitch: 0.5 };
    await element.ready;
    const { camera } = element;
    element.remove();
    return camera;
  });
  expect(camera).toMatchObject({ position: [1, 1.5, 1], yaw: 1, pitch: 0.5 });
});
