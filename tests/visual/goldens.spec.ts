import type { Page } from "playwright/test";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";
import { SCENES } from "./scenes.ts";

/** SwiftShader's pixels are the same to the bit on one architecture; others may fuse operations. */
const TOLERANCE = { threshold: 0.1, maxDiffPixelRatio: 0.002 };

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
      await room.change(attributes.look);
      // In one go: the page draws once for all of it.
      await room.evaluate(
        (element, { attributes, camera, seconds, place }) => {
          for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
          element.reset();
          if (place) {
            element.camera = place;
            element.place();
          }
          element.camera = camera;
          element.step(seconds);
        },
        { attributes, camera, seconds, place },
      );
      expect(await room.png()).toMatchSnapshot(`${name}.png`, TOLERANCE);
      expect(room.complaints).toEqual([]);
    });
  }
});
