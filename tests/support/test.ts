import { test as base, expect } from "playwright/test";
import { RoomDriver } from "./room-driver.ts";

export { expect };

/**
 * Playwright's `test` with a room that is open already, for tests that change nothing of the page.
 *
 * The page is shared, so that nobody waits for shaders and textures twice; each test finds the element
 * at its defaults, paused at time 0. A test fails if the page complained of anything meanwhile.
 */
export const test = base.extend<{ room: RoomDriver }, { sharedRoom: RoomDriver }>({
  sharedRoom: [
    async ({ browser }, use) => {
      const page = await browser.newPage();
      await use(await new RoomDriver(page).open({}, { width: 160, height: 90 }));
      await page.close();
    },
    { scope: "worker" },
  ],
  room: async ({ sharedRoom }, use) => {
    await sharedRoom.restore();
    const before = sharedRoom.complaints.length;
    await use(sharedRoom);
    expect(sharedRoom.complaints.slice(before)).toEqual([]);
  },
});
