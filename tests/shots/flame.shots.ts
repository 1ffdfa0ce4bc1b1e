import { expect, test } from "playwright/test";
import sharp from "sharp";
import type { Camera } from "../../src/candle-flame-element.ts";
import { hasSparks } from "../../src/world/particles/sparks.ts";
import { TICK } from "../../src/world/timeline.ts";
import { plainRoom } from "../support/plain-room.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { type Tile, writeSheet } from "./sheet.ts";
import { lookingAt, onScreen } from "./shot.ts";

const SIZE = { width: 1200, height: 750 };
/** Pixels of it for each of a tile's, at zoom 1. */
const SCALE = SIZE.width / 720;
/** Between pictures nobody looks, and every step draws. */
const UNSEEN = "0.1";
const TILE = { width: 320, height: 240 };

/** On the table, and beneath the window. */
const TABLE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;
/** Where one can walk to both sides. */
const OPEN = { position: [-1, 1.6, 0.8], yaw: -0.94, pitch: -0.1 } as const;
const BY_THE_WALL = lookingAt([1.55, 1.6, -0.4], [2.2, 0.46, -0.2]);

/** A shelf above one's head, which nobody walks into: so the eye can come near to a candle on it. */
const BARE = { min: [-2, 0, -2], max: [2, 2.6, 2] } as const;
const SHELF = { min: [-0.2, 1.72, -0.2], max: [0.2, 1.75, 0.2] } as const;
const ABOVE_SHELF = { position: [0, 2.2, 0.5], yaw: 0, pitch: -0.73 } as const;

class FlameStudio {
  readonly tiles: Tile[] = [];
  readonly #room: RoomDriver;

  constructor(room: RoomDriver) {
    this.#room = room;
  }

  /** A new moment: the candle stands where it is seen from `place`, or is in the hand. */
  async begin(place: Camera | null, seed = 1): Promise<void> {
    await this.#room.set({ wind: "0.05", gustiness: "0.5", exposure: "0" });
    await this.#room.evaluate(
      (element, { place, seed }) => {
        element.reset(seed);
        element.light();
        if (!place) return;
        element.camera = place;
        element.place();
      },
      { place, seed },
    );
    await this.#room.step(0.5);
  }

  /** Turns to the flame from a place `from` it, metres. */
  async look(
    from: readonly [number, number, number],
    aim: readonly [number, number, number] = [0, 0, 0],
  ) {
    const [x, y, z] = await this.#room.evaluate((element) => element.flame?.position ?? [0, 0, 0]);
    const camera = lookingAt(
      [x + from[0], y + from[1], z + from[2]],
      [x + aim[0], y + aim[1], z + aim[2]],
    );
    await this.#room.stand(camera);
  }

  /** Cuts a tile out of the picture, around the flame or the wick; `above` of it, shares of the tile. */
  async take(name: string, zoom = 1, above = 0.1): Promise<void> {
    const { camera, position } = await this.#room.evaluate(({ camera, flame }) => ({
      camera,
      position: flame?.position ?? [0, 0, 0],
    }));
    await this.#room.set({ "max-pixel-ratio": "1" });
    const png = await this.#room.png();
    await this.#room.set({ "max-pixel-ratio": UNSEEN });
    const [x, y] = onScreen(camera, position, SIZE);
    const width = Math.min(Math.round((TILE.width * SCALE) / zoom), SIZE.width);
    const height = Math.min(Math.round((TILE.height * SCALE) / zoom), SIZE.height);
    const inside = (value: number, most: number) => Math.round(Math.min(Math.max(value, 0), most));
    const whole = await sharp(png).resize(SIZE.width, SIZE.height).toBuffer();
    const picture = await sharp(whole)
      .extract({
        left: inside(x - width / 2, SIZE.width - width),
        top: inside(y - height * (0.5 + above), SIZE.height - height),
        width,
        height,
      })
      .resize(TILE.width, TILE.height, { kernel: "cubic" })
      .png()
      .toBuffer();
    this.tiles.push({ name, picture });
  }
}

async function changeRoom(room: RoomDriver, body: Buffer): Promise<void> {
  const src = `${LIBRARY}another-room.glb`;
  await room.page.route(src, (route) => route.fulfill({ contentType: "model/gltf-binary", body }));
  await room.evaluate(async (element, src) => {
    const loaded = new Promise((resolve) =>
      element.addEventListener("load", resolve, { once: true }),
    );
    element.src = src;
    await loaded;
  }, src);
}

test("shot: the flame, what moves it, out and in again", async ({ page }) => {
  test.setTimeout(3_000_000);
  const attributes = {
    look: "physical",
    quality: "medium",
    controls: "",
    motion: "full",
    "max-pixel-ratio": UNSEEN,
  };
  const room = await new RoomDriver(page).open(attributes, SIZE);
  const studio = new FlameStudio(room);
  const BESIDE = [-0.42, 0.08, 0.3] as const;
  // To the right, as seen from there.
  const ACROSS = { "wind-direction": "-145", gustiness: "0" };

  await studio.begin(TABLE);
  await studio.look(BESIDE);
  await studio.take("still", 2);
  await studio.take("still, nearer", 4);
  await studio.look([-0.28, 0.5, 0.2]);
  await studio.take("from above", 2);
  for (const wind of ["0.1", "0.3", "0.5"]) {
    await studio.begin(TABLE);
    await studio.look(BESIDE);
    await room.set({ ...ACROSS, wind });
    await room.step(1.5);
    await studio.take(`wind of ${wind} m/s`, 2);
  }
  await room.set({ wind: "1", gustiness: "1" });
  await room.step(2);
  await studio.take("gusts around 1 m/s", 2);

  for (const [code, name] of [
    ["KeyA", "carried to the left"],
    ["KeyD", "carried to the right"],
  ] as const) {
    await studio.begin(null);
    await room.stand(OPEN);
    await room.evaluate((element, code) => {
      element.enter();
      element.dispatchEvent(new KeyboardEvent("keydown", { code, bubbles: true }));
      element.step(0.5);
    }, code);
    await studio.take(name, 2);
    await room.evaluate((element, code) => {
      element.dispatchEvent(new KeyboardEvent("keyup", { code, bubbles: true }));
    }, code);
  }

  await studio.begin(BY_THE_WALL);
  await studio.look([-0.55, 0.1, -0.1]);
  await studio.take("against the log wall", 1.5);

  const seed = [...Array(1000).keys()].find((seed) => hasSparks(seed, 66)) ?? 1;
  await studio.begin(TABLE, seed);
  await studio.look(BESIDE);
  await room.step(12 * TICK);
  await studio.take("the wick spits", 1.5);

  await studio.begin(TABLE);
  await studio.look(BESIDE, [0, 0.06, 0]);
  await room.evaluate((element) => {
    element.blow();
    element.step(0.1);
  });
  await studio.take("a breath, after 0.1 s", 2);
  await room.evaluate((element) => {
    for (let i = 0; i < 12 && element.lit; i++) element.step(0.1);
  });
  await studio.take("blown out", 1.2, 0.3);
  await room.set({ moonlight: "0.3" });
  for (const [seconds, name] of [
    [0.2, "0.2 s"],
    [0.8, "1 s"],
    [2, "3 s"],
  ] as const) {
    await room.step(seconds);
    await studio.take(`out for ${name}, by the moon`, 1.2, 0.3);
  }
  await room.set({ exposure: "3" });
  await studio.take("the same, 3 EV more", 1.2, 0.3);
  await room.set({ exposure: "0", moonlight: "0" });
  await room.evaluate((element) => element.light());
  await room.step(0.3);
  await studio.take("lit for 0.3 s", 1.2, 0.3);

  await studio.begin(BY_THE_WALL);
  await studio.look([-0.7, 0.35, -0.2], [0, 0.3, -0.05]);
  await room.evaluate((element) => element.extinguish());
  await room.step(3);
  await room.set({ exposure: "3", moonlight: "0.3" });
  await studio.take("smoke before the window, 3 EV more", 0.5, 0.2);
  await room.set({ moonlight: "0" });

  await changeRoom(room, plainRoom(BARE, [SHELF], 0.3));
  await studio.begin(ABOVE_SHELF);
  await studio.look([0, 0, 0.1]);
  await studio.take("at 10 cm, in a bare room", 1.5, 0);

  await writeSheet("docs/shots/flame.jpg", studio.tiles, 4);
  expect(room.complaints).toEqual([]);
});
