import { expect, test } from "playwright/test";
import sharp from "sharp";
import { CAMERA, drawFrames, driveFrames, playAtTable } from "../support/driven-frames.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { type Tile, writeSheet } from "./sheet.ts";

const SIZE = { width: 1280, height: 720 };
/** Of a frame, milliseconds, and of a step, metres. */
const FRAME = 50;
const STEP = 0.02;

test("shot: the refined image without a GPU, and the first steps from it", async ({ page }) => {
  test.setTimeout(600_000);
  await driveFrames(page);
  const attributes = { look: "physical", quality: "auto", moonlight: "0.15" };
  const room = await new RoomDriver(page).open(attributes, SIZE);
  const tiles: Tile[] = [];
  const shoot = async (name: string) => {
    const picture = await sharp(await room.png())
      .resize(SIZE.width / 2)
      .toBuffer();
    tiles.push({ name, picture });
  };
  await playAtTable(room);
  await drawFrames(room, 2, FRAME);
  await shoot("first frame");
  while ((await room.stats()).width < SIZE.width) await drawFrames(room, 1, FRAME);
  await shoot("sharp surfaces");
  await drawFrames(room, 400, FRAME);
  await shoot("refined");
  const [x, y, z] = CAMERA.position;
  for (let frame = 1; frame <= 13; frame++) {
    const way = STEP * frame;
    await room.stand({
      position: [x + way * Math.sin(-CAMERA.yaw), y, z - way * Math.cos(CAMERA.yaw)],
    });
    await drawFrames(room, 1, FRAME);
    if (frame % 6 === 1) await shoot(`frame ${frame} of a walk`);
  }
  await writeSheet("docs/shots/refinement.jpg", tiles, 3);
  expect(room.complaints).toEqual([]);
});
