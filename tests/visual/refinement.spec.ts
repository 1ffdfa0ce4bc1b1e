// `auto` without a GPU: what a visitor who stands still is shown.
import type { Page } from "playwright/test";
import sharp from "sharp";
import type { Camera, CandleFlameElement } from "../../src/candle-flame-element.ts";
import {
  CAMERA,
  type Drive,
  drawFrames,
  driveFrames,
  playAtTable,
  TABLE,
} from "../support/driven-frames.ts";
import { flip } from "../support/flip.ts";
import { type Attributes, type Picture, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

const BOX = { width: 320, height: 180 };
/** The candle's flame as seen from CAMERA, pixels. */
const FLAME = [167, 86] as const;
/** Edge of a tile, pixels. */
const TILE = 64;
const STEP = { position: [-0.84, 1.3, 1.09], yaw: -0.8, pitch: -0.244 } as const;
const CORNER = { position: [1.468, 1.6, -1.062], yaw: -0.57, pitch: -0.4 } as const;

const MANTEL = { position: [-0.5, 1.6, -0.75], yaw: 0, pitch: -0.25 } as const;

/** A room beside it, which shows the same moment at `high`. */
const BESIDE = `<candle-flame id="high" look="physical" quality="high" moonlight="0" paused></candle-flame>`;

/** Pixels of `low`, as raw data. */
const LOW = { width: 213, height: 120, channels: 4 } as const;

let page: Page;
let room: RoomDriver;

// One visit: each test goes on where the one before it ended.
test.describe.configure({ mode: "serial" });

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await serveSmallTextures(page);
  await driveFrames(page);
  const opening = { ...BOX, after: BESIDE };
  room = await new RoomDriver(page).open({ look: "physical", quality: "auto" }, opening);
  await room.evaluate(async () => {
    const rooms = document.querySelectorAll<CandleFlameElement>("candle-flame");
    for (const { ready } of rooms) await ready;
  });
  await playAtTable(room);
});
test.afterEach(() => expect(room.complaints).toEqual([]));
test.afterAll(() => page.close());

const frames = (count: number, milliseconds: number) => drawFrames(room, count, milliseconds);

/**
 * Draws frames until the picture is that of the refinement.
 *
 * @returns the most new programs and points in a frame
 */
async function refine(milliseconds: number): Promise<Pick<Drive, "programs" | "points">> {
  const isShown = async () => (await room.stats()).width === BOX.width;
  return await framesUntil(isShown, milliseconds);
}

async function framesUntil(
  isDone: (tiles: number) => boolean | Promise<boolean>,
  milliseconds: number,
): Promise<Pick<Drive, "programs" | "points">> {
  const most = { programs: 0, points: 0 };
  let tiles = 0;
  for (let i = 0; i < 4000; i++) {
    if (await isDone(tiles)) return most;
    [tiles = 0] = await frames(1, milliseconds);
    const { programs, points } = await room.evaluate(() => Reflect.get(window, "drive") as Drive);
    most.points = Math.max(most.points, points);
    most.programs = Math.max(most.programs, programs);
  }
  throw new Error("The picture was never refined.");
}

/** Draws frames until all tiles have been drawn. */
async function complete(): Promise<void> {
  let left = Math.ceil(BOX.width / TILE) * Math.ceil(BOX.height / TILE);
  const countDown = (tiles: number) => {
    left -= tiles;
    return left <= 0;
  };
  await framesUntil(countDown, 50);
  await frames(20, 50); // first draws to a target of the size are counted, too
}

/** Linear light of a picture. */
function shown({ width, height, data }: Picture) {
  const linear = new Float32Array(width * height * 3);
  for (let i = 0; i < width * height * 3; i++) {
    const code = (data[Math.floor(i / 3) * 4 + (i % 3)] ?? 0) / 255;
    linear[i] = code <= 0.04045 ? code / 12.92 : ((code + 0.055) / 1.055) ** 2.4;
  }
  return { width, height, linear };
}

/** Pixels that are less than half as bright: of those neither black nor in the glare of the flame, which moves. */
function dark(picture: Picture, beside: Picture): number {
  const [ours, theirs] = [shown(picture).linear, shown(beside).linear];
  const isDarker = (green: number, pixel: number) => {
    const [x, y] = [pixel % BOX.width, Math.floor(pixel / BOX.width)];
    const isGlare = Math.hypot(x - FLAME[0], y - FLAME[1]) < 16;
    return !isGlare && green > 0.01 && ours[3 * pixel + 1]! < green / 2;
  };
  return theirs
    .filter((_, i) => i % 3 === 1)
    .reduce((sum, green, i) => sum + Number(isDarker(green, i)), 0);
}

/** Mean difference of green between neighbours in a row, as a share of the mean. */
function sharpness({ width, data }: Picture): number {
  let [differences, sum] = [0, 0];
  for (let pixel = 0; pixel < data.length / 4; pixel++) {
    const green = data[4 * pixel + 1] ?? 0;
    sum += green;
    if (pixel % width > 0) differences += Math.abs(green - (data[4 * pixel - 3] ?? 0));
  }
  return differences / sum;
}

/** Energy of stair-steps: of what of four pixels is bright along one diagonal and dark along the other. */
function stairSteps({ width, height, data }: Picture): number {
  const green = (x: number, y: number) => data[4 * (y * width + x) + 1] ?? 0;
  let sum = 0;
  for (let y = 0; y + 1 < height; y++) {
    for (let x = 0; x + 1 < width; x++) {
      sum += (green(x, y) - green(x + 1, y) - green(x, y + 1) + green(x + 1, y + 1)) ** 2;
    }
  }
  return sum;
}

function meanFlip(a: Picture, b: Picture): number {
  const differences = flip(shown(a), shown(b));
  return differences.reduce((sum, one) => sum + one, 0) / differences.length;
}

/** What `high` shows of the same moment, from somewhere. */
async function atHigh(camera: Camera): Promise<Picture> {
  await room.evaluate((element, camera) => {
    const high = document.getElementById("high") as CandleFlameElement;
    high.moonlight = element.moonlight;
    high.moonDirection = element.moonDirection;
    high.mirror(element);
    high.camera = camera;
  }, camera);
  return new RoomDriver(page, "#high").picture();
}

let begun: Picture;
/** The same once its display colours are kept. */
let kept: Picture;
let refined: Picture;
let firstStep: Picture;

test("is prepared in frames of which each draws with two new programs at most, and few points", async () => {
  await frames(1, 50); // of `low`, with programs of its own
  const first = await refine(50);
  begun = await room.picture();
  expect(first.points, "it begins with `low`'s light").toBe(0);
  const captures = await framesUntil((tiles) => tiles > 0, 50);
  kept = await room.picture();
  expect(captures.points, "slow without a GPU").toBeGreaterThan(0);
  expect(captures.points).toBeLessThan(100_000);
  for (const { programs } of [first, captures]) {
    expect(programs, "one of `low`'s, and one of its own").toBeLessThanOrEqual(2);
  }
});

test("is refined by a machine with no time to spare too, a tile in some frames", async () => {
  await frames(4, 400);
  const tiles = await frames(40, 400);
  expect(Math.max(...tiles), "in any frame").toBeLessThanOrEqual(1);
  const drawn = tiles.reduce((sum, one) => sum + one, 0);
  expect(drawn).toBeGreaterThanOrEqual(4);
  expect(drawn).toBeLessThanOrEqual(6);
});

test("is complete once all of its tiles are drawn, at the canvas's full resolution", async () => {
  const tiles = await frames(80, 50);
  expect(tiles.slice(-5), "nothing is left to do").toEqual([0, 0, 0, 0, 0]);
  refined = await room.picture();
  expect([refined.width, refined.height]).toEqual([BOX.width, BOX.height]);
});

test("is what the first step begins with, and left for the coarser one within a second of walking", async () => {
  const widths: number[] = [];
  for (let step = 0; step < 20; step++) {
    await room.evaluate(
      (element, { camera, yaw }) => {
        element.camera = { ...camera, yaw };
      },
      { camera: STEP, yaw: STEP.yaw + 0.002 * step },
    );
    await frames(1, 50);
    widths.push((await room.stats()).width);
    if (step === 0) firstStep = await room.picture();
  }
  expect(widths[0]).toBe(BOX.width);
  expect(widths.at(-1), "the full resolution of `low`").toBe(LOW.width);
  expect(widths, "the canvas changes once").toEqual(widths.toSorted((a, b) => b - a));
});

test("is what `high` shows, and the first step nearer to it than `low` is", async () => {
  await room.evaluate((element) => element.pause());
  const still = await atHigh(CAMERA);
  const difference = meanFlip(still, refined);
  expect(dark(refined, still), "dots in corners").toBeLessThan(20);
  const high = await atHigh(STEP);
  // At rest it is `low` until frames have come.
  const coarse = await room.picture({ camera: STEP, seconds: 0 });
  expect([coarse.width, coarse.height]).toEqual([LOW.width, LOW.height]);
  const low = await sharp(coarse.data, { raw: LOW })
    .resize(BOX.width, BOX.height, { kernel: "linear", fit: "fill" })
    .raw()
    .toBuffer();
  const [ofFirst, ofLow] = [meanFlip(high, firstStep), meanFlip(high, { ...BOX, data: low })];
  const atBeginning = meanFlip(still, begun);
  const all = [atBeginning, difference, ofFirst, ofLow];
  console.log(`mean FLIP ${all.map((one) => one.toFixed(4))}`);
  const [ofBegun = 0, ofCoarse = 1] = [begun, { ...BOX, data: low }].map(
    (one) => sharpness(one) / sharpness(still),
  );
  console.log(`as sharp as it: ${ofBegun.toFixed(2)} as it begins, \`low\` ${ofCoarse.toFixed(2)}`);
  const steps = stairSteps(kept) / stairSteps(still);
  const brighter = dark(still, begun);
  console.log(`stair-steps: ${steps.toFixed(2)} of its; ${brighter} pixels twice as bright`);
  expect(steps, "2.97 without antialiasing").toBeLessThan(1.3);
  expect(brighter, "1729 in `low`'s shadows").toBeLessThan(1600);
  expect(ofBegun, "as it begins").toBeGreaterThan(0.9);
  expect(ofCoarse).toBeLessThan(0.8);
  expect(difference).toBeLessThan(0.02);
  expect(ofFirst).toBeLessThan(0.7 * ofLow);
});

test("is what `high` shows by a moon that has moved, beside the candle, whose bounce is resampled", async () => {
  await room.set({ moonlight: "0.3", "moon-direction": "-98 27" });
  await room.evaluate((element, camera) => {
    element.camera = camera;
    element.play();
  }, CAMERA);
  await frames(1, 50); // of `low`, which captures it at once
  await room.set({ "moon-direction": "-98 60" });
  await refine(50);
  await complete();
  const picture = await room.picture();
  const difference = meanFlip(await atHigh(CAMERA), picture);
  const beside = new RoomDriver(page, "#high");
  const by = async (attributes: Attributes) =>
    meanFlip(await beside.picture({ attributes }), picture);
  const former = await by({ "moon-direction": "-98 27" });
  const unlit = await by({ moonlight: "0" });
  console.log(
    `mean FLIP ${[difference, former, unlit].map((one) => one.toFixed(4))}: now, by the moon where it was, by none`,
  );
  expect(difference).toBeLessThan(0.02);
  expect(former).toBeGreaterThan(2 * difference);
  expect(unlit, "moonlight is in it").toBeGreaterThan(1.3 * difference);
});

test("is what `high` shows where a candle stood that is hidden now", async () => {
  const showCandle = (isShown: boolean) =>
    room.evaluate((_, isShown) => {
      const rooms = document.querySelectorAll<CandleFlameElement>("candle-flame");
      for (const { features } of rooms) features.candle = isShown;
    }, isShown);
  expect((await room.stats()).width, "an image with the candle").toBe(BOX.width);
  await showCandle(false);
  await frames(1, 50);
  await refine(50);
  await complete();
  const picture = await room.picture();
  await room.evaluate((element) => element.pause());
  expect(dark(picture, await atHigh(CAMERA)), "where it stood").toBeLessThan(4);
  await showCandle(true);
  await room.set({ moonlight: "0" });
});

test("is what `high` shows elsewhere, too, with the candle in the hand, whatever was begun on the way", async () => {
  const stand = (camera: Camera) =>
    room.evaluate((element, camera) => {
      element.reset();
      element.camera = camera;
      element.play();
    }, camera);
  await stand(CAMERA);
  await refine(50);
  await stand({ ...CAMERA, yaw: CAMERA.yaw + 0.5 });
  // As long as captures have begun for that place, and are not done.
  await frames(14, 50);
  await stand(CORNER);
  await refine(50);
  await complete();
  const picture = await room.picture();
  await room.evaluate((element) => element.pause());
  const difference = meanFlip(await atHigh(CORNER), picture);
  console.log(`mean FLIP ${difference.toFixed(4)}`);
  // The hand has swayed a little since. With captures of the other place it was 0.16.
  expect(difference).toBeLessThan(0.04);
});

test("is what `high` shows by the moon alone, too, once the eye is used to it", async () => {
  const wait = (seconds: number) =>
    room.evaluate(
      (element, { camera, seconds }) => {
        element.camera = camera;
        element.extinguish();
        element.step(seconds);
        element.play();
      },
      { camera: TABLE, seconds },
    );
  await room.set({ moonlight: "0.3" });
  await wait(12);
  await frames(20, 50);
  expect((await room.stats()).width, "the eye is adapting").toBeLessThan(BOX.width);
  await wait(10);
  await refine(50);
  await complete();
  const picture = await room.picture();
  await room.evaluate((element, yaw) => {
    element.camera = { ...element.camera, yaw };
  }, TABLE.yaw + 0.002);
  await frames(1, 50);
  const step = await room.picture();
  await room.evaluate((element) => element.pause());
  const high = await atHigh(TABLE);
  const [ofImage = 1, ofStep = 1] = [picture, step].map((one) => meanFlip(high, one));
  console.log(`mean FLIP ${[ofImage, ofStep].map((one) => one.toFixed(4))}`);
  expect(ofImage).toBeLessThan(0.02);
  // The exposure has settled before it begins: else it is 0.06.
  expect(ofStep, "the first step begins with it").toBeLessThan(0.045);
});

test("is what `high` shows by several candles, too", async () => {
  await room.set({ moonlight: "0" });
  await room.evaluate((element, camera) => {
    element.reset();
    element.camera = camera;
    element.place();
    element.candles[2]?.light();
    element.step(2);
    element.play();
  }, MANTEL);
  await refine(50);
  await complete();
  const picture = await room.picture();
  await room.evaluate((element) => element.pause());
  const difference = meanFlip(await atHigh(MANTEL), picture);
  console.log(`mean FLIP ${difference.toFixed(4)}`);
  // `high` has layers with all shadow taps for each candle, lit from where the flame was when they were last drawn: 0.024
  // to 0.027, by what was drawn before.
  expect(difference).toBeLessThan(0.035);
});
