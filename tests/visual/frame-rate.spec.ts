import { RoomDriver } from "../support/room-driver.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { expect, test } from "../support/test.ts";

/** What the element shows after a second from time 0, in steps as a display of this rate takes. */
async function endOfSecond(room: RoomDriver, framesPerSecond: number): Promise<string> {
  await room.evaluate((element) => element.reset());
  await room.step(1 / framesPerSecond, framesPerSecond);
  expect(await room.evaluate((element) => element.currentTime)).toBeCloseTo(1, 9);
  return room.pixels();
}

async function pictureOf(room: RoomDriver, seed: number): Promise<string> {
  await room.evaluate((element, seed) => element.reset(seed), seed);
  await room.step(1 / 60, 12);
  return room.pixels();
}

for (const look of ["paper", "original"] as const) {
  test(`One second of the ${look} look ends in the same pixels at 30, 60 and 144 Hz`, async ({
    room,
  }) => {
    await room.change(look);
    const begin = await room.pixels();
    const end = await endOfSecond(room, 30);
    expect(end).not.toBe(begin);
    expect(await endOfSecond(room, 60)).toBe(end);
    expect(await endOfSecond(room, 144)).toBe(end);
  });

  test(`The same seed of the ${look} look is the same flame, another seed another`, async ({
    room,
  }) => {
    await room.change(look);
    const flame = await pictureOf(room, 5);
    expect(await pictureOf(room, 6)).not.toBe(flame);
    expect(await pictureOf(room, 5)).toBe(flame);
  });
}

test("A second of the physical look ends in the same pixels at 30, 60 and 144 Hz", async ({
  page,
}) => {
  const room = new RoomDriver(page);
  await serveSmallTextures(page);
  await room.open({ look: "physical", quality: "low" }, { width: 64, height: 36 });
  const end = await endOfSecond(room, 30);
  expect(await endOfSecond(room, 60)).toBe(end);
  expect(await endOfSecond(room, 144)).toBe(end);
  expect(room.complaints).toEqual([]);
});

test("A long frame leaves the flame where many short ones would", async ({ room }) => {
  await room.step(2);
  const atOnce = await room.pixels();
  await room.evaluate((element) => element.reset());
  await room.step(1 / 16, 32);
  expect(await room.pixels()).toBe(atOnce);
});
