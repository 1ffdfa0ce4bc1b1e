import { test as base, expect } from "playwright/test";
import { drawOneSample } from "./one-sample.ts";
import { RoomDriver } from "./room-driver.ts";
import { serveSmallTextures } from "./small-textures.ts";

export { expect };

const SIZE = { width: 160, height: 90 } as const;

/**
 * Playwright's `test` with a room that is open already, the paper's or the cabin, for tests that change nothing of the page.
 *
 * The page is shared, so that nobody waits for shaders and textures twice; each test finds the element
 * at its defaults, paused at time 0. A test fails if the page complained of anything meanwhile. The cabin has grey textures,
 * one sample a pixel, and the quality of the test before.
 */
export const test = base.extend<
  { room: RoomDriver; cabin: RoomDriver },
  { sharedRoom: RoomDriver; sharedCabin: RoomDriver }
>({
  sharedRoom: [
    async ({ browser }, use) => {
      const page = await browser.newPage();
      await use(await new RoomDriver(page).open({}, SIZE));
      await page.close();
    },
    { scope: "worker" },
  ],
  sharedCabin: [
    async ({ browser }, use) => {
      const page = await browser.newPage();
      await serveSmallTextures(page);
      await drawOneSample(page);
      await use(await new RoomDriver(page).open({ look: "physical", quality: "low" }, SIZE));
      await page.close();
    },
    { scope: "worker" },
  ],
  room: async ({ sharedRoom }, use) => {
    await sharedRoom.restore("paper", "medium");
    const before = sharedRoom.complaints.length;
    await use(sharedRoom);
    expect(sharedRoom.complaints.slice(before)).toEqual([]);
  },
  cabin: async ({ sharedCabin }, use) => {
    await sharedCabin.restore("physical");
    const before = sharedCabin.complaints.length;
    await use(sharedCabin);
    expect(sharedCabin.complaints.slice(before)).toEqual([]);
  },
});
