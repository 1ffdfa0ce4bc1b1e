import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { expect, test } from "playwright/test";
import sharp from "sharp";
import type { Camera } from "../../src/candle-flame-element.ts";
import { allFeatures, type Feature, featuresOf } from "../../src/settings.ts";
import { hasSparks } from "../../src/world/particles/sparks.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { type Tile, writeSheet } from "./sheet.ts";
import { lookingAt, onScreen, type Point, type Shot, take } from "./shot.ts";

test("shot: every material under one grazing lamp", async () => {
  test.setTimeout(600_000);
  const { textures } = JSON.parse(readFileSync("public/manifest.json", "utf8"));
  const names = Object.keys(textures);
  expect(names.length).toBeGreaterThan(10);
  const tiles: Tile[] = [];
  for (const name of names) {
    const command = ["tools/textures/preview.mjs", name];
    const file = execFileSync(process.execPath, command, { encoding: "utf8" }).trim();
    // The wall from an angle, and the close crop below it.
    const picture = await sharp(file)
      .extract({ left: 0, top: 0, width: 720, height: 840 })
      .resize(384, 448)
      .png()
      .toBuffer();
    tiles.push({ name, picture });
  }
  await writeSheet("docs/shots/materials.jpg", tiles, 5);
});

const TABLE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;

/** Near enough for wax and flame, far enough for shadows on wall and table. */
const BESIDE_THE_CANDLE = lookingAt([-0.42, 1.12, 0.5], [0.25, 0.84, -0.1]);

const MODELS: readonly Omit<Shot, "attributes" | "seconds">[] = [
  {
    name: "chamberstick",
    place: lookingAt([-0.45, 1.6, 0.1], [-0.02, 0.745, 0.1]),
    camera: lookingAt([-0.42, 0.98, 0.3], [0.02, 0.86, 0.08]),
  },
  {
    name: "table",
    place: TABLE,
    camera: lookingAt([-0.36, 1.45, 0.62], [0.55, 0.72, -0.1]),
  },
  {
    name: "hearth",
    place: lookingAt([-0.5, 1.6, -0.5], [-0.5, 0.0, -1.0]),
    camera: lookingAt([-0.3, 1.3, 0.6], [-0.7, 0.8, -1.8]),
  },
  { name: "shelf", camera: lookingAt([1.2, 1.55, -1.1], [1.3, 1.45, -1.9]) },
  {
    name: "window",
    place: lookingAt([1.55, 1.6, -0.4], [2.2, 0.46, -0.2]),
    camera: lookingAt([0.9, 1.5, -0.6], [2.4, 1.1, -0.5]),
  },
  { name: "door", camera: lookingAt([-0.9, 1.5, 0.2], [-1.4, 1.0, 2.0]) },
  { name: "coat", camera: lookingAt([0.1, 1.5, 0.8], [-0.3, 1.2, 2.0]) },
  {
    name: "chest",
    place: lookingAt([1.55, 1.6, 0.2], [1.75, 0.0, 0.35]),
    camera: lookingAt([1.2, 1.3, 0.6], [2.2, 0.35, -0.4]),
  },
  {
    name: "ceiling",
    place: TABLE,
    camera: lookingAt([-1.2, 1.2, 1.2], [0.6, 2.4, -1.0]),
  },
  {
    name: "bench",
    place: lookingAt([-1.6, 1.6, 0.2], [-2.3, 0.44, 0.2]),
    camera: lookingAt([-0.6, 1.4, 0.9], [-2.3, 0.8, -0.2]),
  },
];

test("shot: every model by candlelight", async ({ page }) => {
  test.setTimeout(600_000);
  const attributes = { look: "physical", quality: "medium" };
  const room = await new RoomDriver(page).open(attributes, { width: 640, height: 360 });
  const tiles: Tile[] = [];
  for (const model of MODELS) {
    tiles.push({ name: model.name, picture: await take(room, { ...model, seconds: 0.5 }) });
  }
  await writeSheet("docs/shots/models.jpg", tiles, 2);
  expect(room.complaints).toEqual([]);
});

/** Where a technique is seen best: far from what it does, two pictures are one. */
interface Stage {
  /** Where the candle is put down; else it is in the hand. */
  readonly candle?: Camera;
  /** The eye, or how far it is from the flame and what it looks at there, metres. */
  readonly camera: Camera | { readonly from: Point; readonly aim?: Point };
  /** How much nearer the flame, and what is around it, is shown. */
  readonly zoom?: number;
  readonly seed?: number;
  /** Since the candle was lit, or put out. */
  readonly seconds?: number;
  readonly isOut?: boolean;
  readonly exposure?: number;
  /** Outside, lux. */
  readonly moonlight?: number;
  /** What would outshine it, and is left out of both pictures. */
  readonly off?: readonly Feature[];
}

const BESIDE: Stage = { candle: TABLE, camera: BESIDE_THE_CANDLE };
const AT_THE_FLAME: Stage = { candle: TABLE, camera: { from: [-0.42, 0.08, 0.3] }, zoom: 4 };
const UNDER_THE_WINDOW = lookingAt([1.55, 1.6, -0.4], [2.2, 0.46, -0.2]);
const SIZE = { width: 1280, height: 720 };
const TILE = { width: 480, height: 270 };
/** Pixels for a pixel of the page. Until all stands where it is to be nobody looks, and every step draws. */
const UNSEEN = 0.1;
/** Where the picture is shown whole, and where a part of it is. */
const [WHOLE, NEAR] = [0.5, 1];
/** Its wick spits soon after the start. */
const SPITS = [...Array(1000).keys()].find((seed) => hasSparks(seed, 54)) ?? 1;

const STAGES: Readonly<Partial<Record<Feature, Stage>>> = {
  volume: AT_THE_FLAME,
  specular: {
    candle: lookingAt([-0.45, 1.6, 0.1], [-0.02, 0.745, 0.1]),
    camera: lookingAt([-0.42, 0.98, 0.3], [0.02, 0.86, 0.08]),
  },
  translucency: { ...AT_THE_FLAME, camera: { from: [-0.42, 0.08, 0.3], aim: [0, -0.04, 0] } },
  normalMaps: { camera: lookingAt([-0.4, 1.5, -0.9], [-0.8, 1.35, -1.9]) },
  // Before the frame of the window: it bends by a few pixels, and only edges show it.
  haze: {
    candle: TABLE,
    camera: { from: [-0.463, -0.02, 0.237], aim: [-0.006, 0.086, -0.012] },
    zoom: 12,
    exposure: 1,
  },
  smoke: {
    candle: UNDER_THE_WINDOW,
    camera: { from: [-0.5, 0.25, -0.15], aim: [0, 0.2, -0.03] },
    seconds: 3,
    isOut: true,
    exposure: 3,
    moonlight: 0.3,
  },
  sparks: { ...AT_THE_FLAME, seed: SPITS },
  // Over the table's shadow: one sees motes as they move, and hardly in a still.
  dust: {
    candle: TABLE,
    camera: { from: [-0.44, 0.16, 0.7], aim: [0.186, -0.321, 0.117] },
    zoom: 6,
    seconds: 6,
    exposure: 8,
    off: ["bloom", "indirect"],
  },
  bloom: { ...AT_THE_FLAME, zoom: 2 },
  autoExposure: { camera: lookingAt([-0.8, 1.5, -0.9], [-0.8, 1.35, -1.9]) },
};

async function stage(room: RoomDriver, shown: Stage): Promise<void> {
  const { candle, camera, seed = 1, seconds = 0.5, isOut = false } = shown;
  const { exposure = 0, moonlight = 0 } = shown;
  const light = { exposure: String(exposure), moonlight: String(moonlight) };
  await room.set({ ...light, "max-pixel-ratio": String(UNSEEN) });
  await room.evaluate(
    (element, { candle, seed }) => {
      element.reset(seed);
      element.light();
      if (!candle) return;
      element.camera = candle;
      element.place();
    },
    { candle, seed },
  );
  if (isOut) {
    await room.step(0.5);
    await room.evaluate((element) => element.extinguish());
  }
  await room.step(seconds);
  if ("from" in camera) {
    const [x, y, z] = await room.evaluate((element) => element.flame?.position ?? [0, 0, 0]);
    const { from, aim = [0, 0, 0] } = camera;
    const eye = [x + from[0], y + from[1], z + from[2]] as const;
    await room.stand(lookingAt(eye, [x + aim[0], y + aim[1], z + aim[2]]));
  } else await room.stand(camera);
}

/** What of the picture is around the flame, with `aim` in the middle of it, with a feature and without. */
async function pair(room: RoomDriver, feature: Feature, stage: Stage): Promise<[Buffer, Buffer]> {
  const { camera, zoom = 1, off = [] } = stage;
  const others = Object.fromEntries(off.map((name) => [name, false]));
  const seen = await room.evaluate(({ camera, flame }) => ({
    eye: camera,
    flame: flame?.position ?? [0, 0, 0],
  }));
  const aim = ("from" in camera && camera.aim) || [0, 0, 0];
  const ratio = zoom > 1 ? NEAR : WHOLE;
  const size = { width: SIZE.width * ratio, height: SIZE.height * ratio };
  const middle = onScreen(
    seen.eye,
    seen.flame.map((value, axis) => value + (aim[axis] ?? 0)),
    size,
  );
  const width = Math.round(size.width / zoom);
  const height = Math.round(size.height / zoom);
  const inside = (middle: number, size: number, most: number) =>
    Math.round(Math.min(Math.max(middle - size / 2, 0), most - size));
  const left = inside(middle[0], width, size.width);
  const top = inside(middle[1], height, size.height);
  const cropped = async (isOn: boolean) => {
    const attributes = { "max-pixel-ratio": String(ratio) };
    const features = { ...allFeatures(), ...others, [feature]: isOn };
    const picture = await room.png({ attributes, features });
    // What is set back is drawn, too.
    await room.set({ "max-pixel-ratio": String(UNSEEN) });
    await room.switchFeatures(allFeatures());
    return sharp(picture)
      .extract({ left, top, width, height })
      .resize(TILE.width, TILE.height, { kernel: "cubic" })
      .png()
      .toBuffer();
  };
  const without = await cropped(false);
  return [await cropped(true), without];
}

test("shot: the physical look with and without each of its techniques", async ({ page }) => {
  test.setTimeout(900_000);
  const attributes = { look: "physical", quality: "medium", motion: "full" };
  const room = await new RoomDriver(page).open(
    { ...attributes, "max-pixel-ratio": String(UNSEEN) },
    SIZE,
  );
  const tiles: Tile[] = [];
  for (const feature of featuresOf("physical")) {
    const shown = STAGES[feature] ?? BESIDE;
    await stage(room, shown);
    const [whole, without] = await pair(room, feature, shown);
    const { exposure = 0, moonlight = 0, off = [] } = shown;
    const moon = moonlight > 0 ? "by the moon" : "";
    const how = [moon, exposure > 0 ? `+${exposure} EV` : "", ...off.map((name) => `no ${name}`)];
    const name = [`with ${feature}`, ...how.filter(Boolean)].join(", ");
    tiles.push({ name, picture: whole }, { name: "and without", picture: without });
  }
  await writeSheet("docs/shots/techniques.jpg", tiles, 4);
  expect(room.complaints).toEqual([]);
});
