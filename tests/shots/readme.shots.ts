import { mkdirSync } from "node:fs";
import { expect, test } from "playwright/test";
import sharp from "sharp";
import { RoomDriver } from "../support/room-driver.ts";
import { lookingAt, type Shot, take } from "./shot.ts";

/** In the middle of the table's near half, from where one stands before it. */
const ON_THE_TABLE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;

/** Images of README.md and docs/realism.md. */
const SHOTS: readonly Shot[] = [
  {
    name: "cabin",
    attributes: { look: "physical", quality: "high" },
    camera: { position: [-1.55, 1.6, 1.3], yaw: -0.3 * Math.PI, pitch: -0.08 },
    seconds: 1,
  },
  {
    name: "cabin-table",
    attributes: { look: "physical", quality: "high" },
    place: ON_THE_TABLE,
    camera: lookingAt([-0.85, 1.3, 1.1], [0.45, 0.85, -0.15]),
    seconds: 1,
  },
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
    place: { position: [1.1, 1.6, 1.2], yaw: 0.75, pitch: 0 },
    camera: { position: [2.2, 0.62, 2.4], yaw: 0.75, pitch: -0.12 },
    seconds: 1,
  },
  {
    name: "original",
    attributes: { look: "original", quality: "high" },
    camera: { position: [1.2, 1.6, 2.6], yaw: 0.35, pitch: -0.06 },
    seconds: 1,
  },
];

for (const shot of SHOTS) {
  test(`shot: ${shot.name}`, async ({ page }) => {
    const opening = { width: 1280, height: 720, hasTextures: true };
    const room = await new RoomDriver(page).open(shot.attributes, opening);
    const picture = await take(room, shot);
    mkdirSync("docs/shots", { recursive: true });
    await sharp(picture)
      .jpeg({ quality: 88, chromaSubsampling: "4:4:4" })
      .toFile(`docs/shots/${shot.name}.jpg`);
    expect((await sharp(picture).stats()).isOpaque).toBe(true);
    expect(room.complaints).toEqual([]);
  });
}
