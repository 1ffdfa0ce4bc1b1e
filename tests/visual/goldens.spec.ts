import type { Page } from "playwright/test";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";
import { SCENES } from "./scenes.ts";

test.describe("The picture", () => {
  let page: Page;
  let room: RoomDriver;
  test.beforeAll(async ({ browser }) => {
    page = await browser.newPage();
    room = await new RoomDriver(page).open({}, { width: 640, height: 360 });
  });
  test.afterAll(() => page.close());

  for (const { name, attributes, camera, seconds, place } of SCENES) {
    test(`of ${name} is as it was`, async () => {
      await room.restore();
      await room.change(attributes.look);
      await room.set(attributes);
      if (place) {
        await room.stand(place);
        await room.evaluate((element) => element.place());
      }
      await room.stand(camera);
      await room.step(seconds);
      await expect(page.locator("candle-flame")).toHaveScreenshot(`${name}.png`);
      expect(room.complaints).toEqual([]);
    });
  }
});
