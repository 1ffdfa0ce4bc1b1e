import type { Page } from "playwright/test";
import sharp from "sharp";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";
import { SCENES } from "./scenes.ts";

/** SwiftShader's pixels are the same to the bit on one architecture; others may fuse operations. */
const TOLERANCE = { threshold: 0.1, maxDiffPixelRatio: 0.002 };
/** What no pixel tells by itself: the mean of a channel, of 255. */
const DRIFT = 0.5;

async function means(picture: string | Buffer): Promise<number[]> {
  const { channels } = await sharp(picture).removeAlpha().stats();
  return channels.map(({ mean }) => mean);
}

test.describe("The picture", () => {
  let page: Page;
  let room: RoomDriver;
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    room = await new RoomDriver(page).open({}, { width: 480, height: 270, hasTextures: true });
  });
  test.afterAll(() => page.close());

  for (const { name, attributes, isOut = false, ...change } of SCENES) {
    test(`of ${name} is as it was`, async () => {
      await room.evaluate((element, isOut) => element.toggleAttribute("unlit", isOut), isOut);
      const moonless = { moonlight: "0", "lit-wicks": "0", ...attributes };
      const picture = await room.png({ attributes: moonless, isReset: true, ...change });
      expect(picture).toMatchSnapshot(`${name}.png`, TOLERANCE);
      const before = await means(test.info().snapshotPath(`${name}.png`));
      for (const [channel, mean] of (await means(picture)).entries()) {
        expect(Math.abs(mean - (before[channel] ?? 0)), `channel ${channel}`).toBeLessThan(DRIFT);
      }
      expect(room.complaints).toEqual([]);
    });
  }
});
