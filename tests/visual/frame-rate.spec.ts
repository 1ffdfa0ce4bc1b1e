import { SETTINGS } from "../../src/settings.ts";
import { expect, test } from "../support/test.ts";

for (const look of SETTINGS.look.choices) {
  test(`One second of the ${look} look ends in the same pixels at 30, 60 and 144 Hz`, async ({
    room,
  }) => {
    await room.set({ look });
    const begin = await room.pixels();
    const ends: string[] = [];
    for (const framesPerSecond of [30, 60, 144]) {
      await room.evaluate((element) => element.reset());
      await room.step(1 / framesPerSecond, framesPerSecond);
      expect(await room.evaluate((element) => element.currentTime)).toBeCloseTo(1, 9);
      ends.push(await room.pixels());
    }
    expect(ends[1]).toBe(ends[0]);
    expect(ends[2]).toBe(ends[0]);
    expect(ends[0]).not.toBe(begin);
  });

  test(`The same seed of the ${look} look is the same flame, another seed another`, async ({
    room,
  }) => {
    await room.set({ look });
    const flames: string[] = [];
    for (const seed of [5, 6, 5]) {
      await room.evaluate((element, seed) => element.reset(seed), seed);
      await room.step(1 / 60, 12);
      flames.push(await room.pixels());
    }
    expect(flames[2]).toBe(flames[0]);
    expect(flames[1]).not.toBe(flames[0]);
  });
}

test("A long frame leaves the flame where many short ones would", async ({ room }) => {
  await room.step(2);
  const atOnce = await room.pixels();
  await room.evaluate((element) => element.reset());
  await room.step(1 / 16, 32);
  expect(await room.pixels()).toBe(atOnce);
});
