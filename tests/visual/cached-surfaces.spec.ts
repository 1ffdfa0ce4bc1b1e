// Candles alone at low, in frames that follow each other: their surfaces are sums of images that are kept.
import type { Page } from "playwright/test";
import sharp from "sharp";
import { candlePlate, jarCandle, ringOf } from "../support/candle-model.ts";
import { type Drive, drawFrames, driveFrames } from "../support/driven-frames.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const MODELS: Readonly<Record<string, Buffer>> = {
  "cached-4.glb": candlePlate(ringOf(4, 0.09, 0.07, 0.028), 0.14),
  "cached-16.glb": candlePlate(ringOf(16, 0.085, 0.05, 0.004), 0.11),
  "cached-jar.glb": jarCandle(),
};
const SIZE = { width: 240, height: 160 };
/** Milliseconds. */
const FRAME = 20;
/** Of 255: flames of the images are at rest, and those of frames are not. */
const LIMITS = { mean: 0.8, high: 16 };

let page: Page;
let room: RoomDriver;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await driveFrames(page);
  for (const [name, body] of Object.entries(MODELS)) {
    await page.route(`${LIBRARY}${name}`, (route) =>
      route.fulfill({ contentType: "model/gltf-binary", body }),
    );
  }
  room = await new RoomDriver(page).open(
    { scene: "candle", src: "cached-4.glb", look: "physical", quality: "low", wind: "0" },
    SIZE,
  );
});
test.afterAll(() => page.close());
test.afterEach(() => expect(room.complaints).toEqual([]));

/** Draws driven frames until the images are drawn: then a frame has fewer triangles than when it was stepped. */
async function catchUp(triangles: number): Promise<void> {
  let drawn = Number.POSITIVE_INFINITY;
  for (let tries = 0; tries < 60 && drawn >= triangles; tries++) {
    await drawFrames(room, 10, FRAME);
    drawn = (await room.stats()).triangles;
  }
  expect(drawn).toBeLessThan(triangles);
}

/** Shows a model and plays it in driven frames. */
async function play(src: string): Promise<void> {
  const triangles = await room.evaluate(async (element, src) => {
    element.pause();
    if (element.getAttribute("src") !== src) {
      const loaded = new Promise((resolve) =>
        element.addEventListener("load", resolve, { once: true }),
      );
      element.src = src;
      await loaded;
    }
    element.reset();
    for (const candle of element.candles) candle.light();
    element.step(1);
    const { triangles } = element.stats;
    (Reflect.get(window, "drive") as Drive).isOn = true;
    element.play();
    return triangles;
  }, src);
  await catchUp(triangles);
}

/** How much the frame that plays differs from the same one when it is stepped, of 255: mean, and 99th percentile. */
async function bothWays() {
  const { kept, drawn, isSame } = await room.evaluate(async (element) => {
    const shot = async () => {
      const blob = await element.toBlob();
      return [...new Uint8Array(await blob.arrayBuffer())];
    };
    const radiance = () => {
      const { width, height } = element.stats;
      return element.readRadiance(0, 0, width, height);
    };
    const kept = await shot();
    const keptRadiance = radiance();
    element.pause();
    element.step(0);
    const drawn = await shot();
    const isSame = radiance().every((value, i) => value === keptRadiance[i]);
    element.play();
    return { kept, drawn, isSame };
  });
  expect.soft(isSame, "radiance is that of a stepped frame").toBe(true);
  const raw = (png: number[]) =>
    sharp(Buffer.from(png)).flatten({ background: "#202020" }).raw().toBuffer();
  const [ours, theirs] = [await raw(kept), await raw(drawn)];
  const differences = [...ours]
    .map((value, i) => Math.abs(value - theirs[i]!))
    .sort((a, b) => a - b);
  const mean = differences.reduce((sum, value) => sum + value, 0) / differences.length;
  const high = differences[Math.floor(0.99 * differences.length)] ?? 0;
  return { mean, high };
}

for (const src of [...Object.keys(MODELS), "/models/wreath.glb", "/models/jar.glb"]) {
  test(`${src} looks the same, and its triangles are not drawn again`, async () => {
    await play(src);
    const all = await bothWays();
    console.log(`${src}: ${JSON.stringify(all)}`);
    expect.soft(all.mean).toBeLessThan(LIMITS.mean);
    expect.soft(all.high).toBeLessThan(LIMITS.high);
    // One alone goes on burning, and where there is one it goes out.
    await room.evaluate(({ candles }) => {
      for (const candle of candles.slice(candles.length > 1 ? 1 : 0)) candle.extinguish();
    });
    await drawFrames(room, 60, FRAME);
    const one = await bothWays();
    console.log(`${src}, one flame or none: ${JSON.stringify(one)}`);
    expect.soft(one.mean).toBeLessThan(LIMITS.mean);
    expect.soft(one.high).toBeLessThan(LIMITS.high);
  });
}

test("light of a wide wick comes from as high as its flame", async () => {
  await play("cached-4.glb");
  for (const wick of ["8", "2"]) {
    await room.set({ wick });
    await drawFrames(room, 100, FRAME);
    const { mean, high } = await bothWays();
    expect.soft(mean).toBeLessThan(LIMITS.mean);
    expect.soft(high).toBeLessThan(LIMITS.high);
  }
});

/** Draws a frame, and counts its pixels that are as bright as a flame: the only ones with much blue. */
const drawnFlames = () =>
  room.evaluate((element, milliseconds) => {
    (Reflect.get(window, "drive") as Drive).tick(milliseconds);
    const canvas = element.shadowRoot?.querySelector("canvas") as HTMLCanvasElement;
    const { width, height } = canvas;
    const copy = new OffscreenCanvas(width, height).getContext("2d")!;
    copy.drawImage(canvas, 0, 0); // in the same task: afterwards it is empty
    const { data } = copy.getImageData(0, 0, width, height);
    return data.filter((value, i) => i % 4 === 2 && value > 150).length;
  }, FRAME);

test("in a box of another shape the images are drawn anew, and no frame lacks its flames", async () => {
  await play("cached-4.glb");
  const resize = (width: number) =>
    room.evaluate((element, width) => {
      element.style.width = `${width}px`;
      return new Promise((resolve) => {
        new ResizeObserver((_, observer) => {
          if (element.clientWidth !== width) return;
          observer.disconnect();
          setTimeout(resolve);
        }).observe(element);
      });
    }, width);
  for (const width of [120, SIZE.width, SIZE.width - 4]) {
    await resize(width);
    const [first, second] = [await drawnFlames(), await drawnFlames()] as const;
    expect.soft(first).toBeGreaterThan(0.9 * second);
    expect.soft(second).toBeGreaterThan(40);
    await drawFrames(room, 60, FRAME);
    expect(await room.evaluate(({ clientWidth }) => clientWidth)).toBe(width);
    const { mean, high } = await bothWays();
    expect.soft(mean).toBeLessThan(LIMITS.mean);
    expect.soft(high).toBeLessThan(LIMITS.high);
  }
});
