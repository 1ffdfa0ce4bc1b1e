import { mkdirSync } from "node:fs";
import { expect, test } from "playwright/test";
import sharp from "sharp";
import { type Attributes, RoomDriver } from "../support/room-driver.ts";

/** A picture of the README: what is set, where the eye is, how long it has burnt. */
interface Shot {
  readonly name: string;
  readonly attributes: Attributes;
  readonly camera: { position: [number, number, number]; yaw: number; pitch: number };
  readonly seconds: number;
  readonly isPlaced?: boolean;
}

const SHOTS: readonly Shot[] = [
  {
    name: "paper",
    attributes: { look: "paper", quality: "high" },
    camera: { position: [1.2, 1.6, 2.6], yaw: 0.35, pitch: -0.06 },
    seconds: 1,
  },
  {
    name: "paper-close",
    attributes: { look: "paper", quality: "high" },
    camera: { position: [-3.6, 1.6, -3.9], yaw: 0.6, pitch: -0.2 },
    seconds: 1,
  },
  {
    name: "paper-placed",
    attributes: { look: "paper", quality: "high" },
    camera: { position: [2.2, 0.62, 2.4], yaw: 0.75, pitch: -0.12 },
    seconds: 1,
    isPlaced: true,
  },
  {
    name: "original",
    attributes: { look: "original", quality: "high" },
    camera: { position: [1.2, 1.6, 2.6], yaw: 0.35, pitch: -0.06 },
    seconds: 1,
  },
];

for (const { name, attributes, camera, seconds, isPlaced } of SHOTS) {
  test(`shot: ${name}`, async ({ page }) => {
    const room = await new RoomDriver(page).open(attributes, { width: 1280, height: 720 });
    if (isPlaced) {
      await room.evaluate((element) => {
        element.camera = { position: [1.1, 1.6, 1.2], yaw: 0.75, pitch: 0 };
        element.place();
      });
    }
    await room.evaluate((element, camera) => {
      element.camera = camera;
    }, camera);
    await room.step(seconds);
    mkdirSync("docs/shots", { recursive: true });
    const picture = await page.screenshot();
    await sharp(picture)
      .jpeg({ quality: 88, chromaSubsampling: "4:4:4" })
      .toFile(`docs/shots/${name}.jpg`);
    expect((await sharp(picture).stats()).isOpaque).toBe(true);
  });
}
