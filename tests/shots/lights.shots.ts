import { expect, test } from "playwright/test";
import { RoomDriver } from "../support/room-driver.ts";
import { type Tile, writeSheet } from "./sheet.ts";

const SPAWN = { position: [-1.55, 1.6, 1.3], yaw: -0.3 * Math.PI, pitch: -0.08 } as const;
/** Since the last candle was put out, seconds. */
const MOMENTS = [0.2, 2, 5, 10, 15, 20] as const;

test("shot: several candles, and the twenty seconds after the last of them", async ({ page }) => {
  test.setTimeout(600_000);
  const attributes = { look: "physical", quality: "high", moonlight: "0.15" };
  const room = await new RoomDriver(page).open(attributes, { width: 480, height: 270 });
  const tiles: Tile[] = [];
  const shoot = async (name: string) => void tiles.push({ name, picture: await room.png({}) });
  await room.stand(SPAWN);
  await room.step(2);
  await shoot("candle and moon");
  await room.evaluate((element) => {
    for (const candle of element.candles) candle.light();
  });
  await room.step(3);
  await shoot("four candles");
  await room.evaluate((element) => {
    for (const candle of element.candles) candle.extinguish();
  });
  let now = 0;
  for (const moment of MOMENTS) {
    await room.step(moment - now);
    now = moment;
    await shoot(`all out for ${moment} s`);
  }
  await room.evaluate((element) => element.light());
  await room.step(1);
  await shoot("lit again for 1 s");
  await writeSheet("docs/shots/lights.jpg", tiles, 3);
  expect(room.complaints).toEqual([]);
});
