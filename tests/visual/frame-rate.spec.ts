import type { Page } from "playwright/test";
import { type Attributes, RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

let page: Page;
let room: RoomDriver;

// Hundreds of pictures are drawn, and nobody looks at them.
test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await serveSmallTextures(page);
  room = await new RoomDriver(page).open({}, { width: 64, height: 36 });
});
test.afterAll(() => page.close());
test.afterEach(() => expect(room.complaints).toEqual([]));

/** What the element shows after half a second from time 0, in steps as a display of this rate takes. */
async function endOfHalfSecond(room: RoomDriver, framesPerSecond: number): Promise<string> {
  await room.evaluate((element) => element.reset());
  await room.step(1 / framesPerSecond, framesPerSecond / 2);
  expect(await room.evaluate((element) => element.currentTime)).toBeCloseTo(0.5, 9);
  return room.pixels();
}

async function pictureOf(seed: number): Promise<string> {
  await room.evaluate((element, seed) => element.reset(seed), seed);
  await room.step(1 / 60, 12);
  return room.pixels();
}

for (const look of ["paper", "original"] as const) {
  test(`The same seed of the ${look} look is the same flame, another seed another`, async () => {
    await room.pixels({ attributes: { look, quality: "medium" } });
    const flame = await pictureOf(5);
    expect(await pictureOf(6)).not.toBe(flame);
    expect(await pictureOf(5)).toBe(flame);
  });
}

test("A long frame leaves the flame where many short ones would", async () => {
  const attributes = { look: "paper", quality: "medium" };
  const atOnce = await room.pixels({ attributes, isReset: true, seconds: 2 });
  await room.evaluate((element) => element.reset());
  await room.step(1 / 16, 32);
  expect(await room.pixels()).toBe(atOnce);
});

/** Expects half a second to end in the same pixels, whatever the display's rate. */
async function expectSameEnd(room: RoomDriver, attributes: Attributes): Promise<void> {
  const gusts = { wind: "0.4", gustiness: "0.6" };
  const begin = await room.pixels({ attributes: { ...attributes, ...gusts }, isReset: true });
  const end = await endOfHalfSecond(room, 30);
  expect(end).not.toBe(begin);
  expect(await endOfHalfSecond(room, 60)).toBe(end);
  expect(await endOfHalfSecond(room, 144)).toBe(end);
}

test("Half a second of the paper look ends in the same pixels at 30, 60 and 144 Hz", () =>
  expectSameEnd(room, { look: "paper", quality: "medium" }));

test("Half a second of the physical look ends in the same pixels at 30, 60 and 144 Hz", ({
  cabin,
}) => expectSameEnd(cabin, { quality: "low" }));
