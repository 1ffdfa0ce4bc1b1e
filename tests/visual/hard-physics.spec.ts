import type { Page } from "playwright/test";
import type { Camera } from "../../src/candle-flame-element.ts";
import { luma } from "../../src/light/color.ts";
import { carriedFlame, flameLight, TAPER } from "../../src/light/flame-light.ts";
import { drawOneSample } from "../support/one-sample.ts";
import { plainRoom } from "../support/plain-room.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";
import { absorbedShare, SIZE as SQUARE, WHITE_ROOM } from "../support/white-room.ts";
import { createWorld } from "../support/world.ts";

const SIZE = { width: 320, height: 180 };
const FIELD_OF_VIEW = (56 * Math.PI) / 180;
const ALBEDO = 0.5;
/** Walls at z = -4 and 4; a slab stands on the floor before the latter. Metres. */
const WALL = 4;
const ROOM = { min: [-3, 0, -WALL], max: [3, 3, WALL] } as const;
const SLAB = { min: [-0.8, 0, 2], max: [0, 0.25, 2.01] } as const;
/** A wire close before the wall at 4. */
const WIRE = { min: [1.3, 0.3, WALL - 0.026], max: [1.7, 0.306, WALL - 0.02] } as const;
/** What a matt surface as rough as can be loses of the light to the mirror on top, seen from ahead. */
const MIRRORED = 0.0134;

interface Seen {
  /** Luminance, cd/m², rows from the top. */
  readonly luminance: number[];
  readonly flame: { position: readonly [number, number, number]; luminousIntensity: number };
}

let page: Page;
let room: RoomDriver;

/** The room from there, in the flame's own light alone. */
async function look(camera: Camera, shadows = true): Promise<Seen> {
  const { radiance, flame } = await room.evaluate(
    (element, { camera, shadows, width, height }) => {
      element.features.shadows = shadows;
      element.camera = camera;
      element.step(0);
      const radiance = element.readRadiance(0, 0, width, height);
      return { radiance, flame: element.flame };
    },
    { camera, shadows, ...SIZE },
  );
  if (!flame) throw new Error("There is no flame.");
  const luminance = Array.from({ length: radiance.length / 3 }, (_, i) =>
    luma([radiance[i * 3] ?? 0, radiance[i * 3 + 1] ?? 0, radiance[i * 3 + 2] ?? 0]),
  );
  return { luminance, flame };
}

/** Where on the wall a pixel's middle lies, looking straight at it: x and y, metres. */
function onWall({ position: [x, y, z] }: Camera, column: number, row: number): [number, number] {
  const away = WALL - Math.abs(z);
  const scale = (2 * away * Math.tan(FIELD_OF_VIEW / 2)) / SIZE.height;
  const right = (column + 0.5 - SIZE.width / 2) * scale;
  return [x + Math.sign(-z) * right, y + (SIZE.height / 2 - row - 0.5) * scale];
}

function pixels(): { column: number; row: number; index: number }[] {
  return Array.from({ length: SIZE.width * SIZE.height }, (_, index) => ({
    column: index % SIZE.width,
    row: Math.floor(index / SIZE.width),
    index,
  }));
}

/** How far ahead the flame is held. */
let reach: number | undefined;

/** A view of the wall at -z, with the flame in the hand so far from it. */
async function before(distance: number): Promise<Camera> {
  const camera: Camera = { position: [0, 1.6, distance - WALL + 0.56], yaw: 0, pitch: 0 };
  reach ??= camera.position[2] - (await look(camera)).flame.position[2];
  return { ...camera, position: [0, 1.6, distance - WALL + reach] };
}

/** Irradiance, lx, of a matt wall that is seen from ahead. */
const illuminance = (luminance: number) => (luminance * Math.PI) / (ALBEDO * (1 - MIRRORED));

const mean = (values: readonly number[]) => values.reduce((sum, x) => sum + x, 0) / values.length;

/** Illuminance at the point of the wall that is nearest to the flame, and how far that is. */
async function nearest(distance: number) {
  const camera = await before(distance);
  const { luminance, flame } = await look(camera);
  const [x, y, z] = flame.position;
  const near = pixels().filter(({ column, row }) => {
    const [u, v] = onWall(camera, column, row);
    return Math.hypot(u - x, v - y) < 0.03 * distance;
  });
  expect(near.length).toBeGreaterThan(3);
  return {
    distance: z + WALL,
    illuminance: illuminance(mean(near.map(({ index }) => luminance[index] ?? 0))),
    luminousIntensity: flame.luminousIntensity,
  };
}

/** Where a falling or rising curve passes a level, between samples. */
function crossing(places: readonly number[], values: readonly number[], level: number): number {
  for (let i = 1; i < values.length; i++) {
    const [a, b] = [values[i - 1] ?? 0, values[i] ?? 0];
    if (a > level !== b > level) {
      return (
        (places[i - 1] ?? 0) + ((level - a) / (b - a)) * ((places[i] ?? 0) - (places[i - 1] ?? 0))
      );
    }
  }
  throw new Error(`The curve does not pass ${level}.`);
}

/** Width of a whole penumbra whose edge rises evenly, from the middle four fifths of the rise. */
function penumbra(places: readonly number[], values: readonly number[]): number {
  return Math.abs(crossing(places, values, 0.9) - crossing(places, values, 0.1)) / 0.8;
}

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await drawOneSample(page);
  room = await new RoomDriver(page).open(
    { look: "physical", quality: "high", motion: "reduced" },
    { ...SIZE, model: plainRoom(ROOM, [SLAB, WIRE], ALBEDO) },
  );
  await room.switchFeatures({ indirect: false, specular: false, candle: false, volume: false });
});
test.afterAll(() => page.close());
test.afterEach(() => expect(room.complaints).toEqual([]));

test("A wall has as many lux as the flame has candela at 1 m, and a quarter of them at 2 m", async () => {
  const [one, two] = [await nearest(1), await nearest(2)];
  expect(one.distance).toBeCloseTo(1, 3);
  expect(two.distance).toBeCloseTo(2, 3);
  const share = one.illuminance / one.luminousIntensity;
  const falloff = two.illuminance / one.illuminance;
  console.log(`E(1 m)/I ${share.toFixed(4)}, E(2 m)/E(1 m) ${falloff.toFixed(4)}`);
  expect(Math.abs(share - 1)).toBeLessThan(0.03);
  expect(Math.abs(falloff / 0.25 - 1)).toBeLessThan(0.02);
});

test("The wall's light is smooth, and follows cosine and distance everywhere", async () => {
  const camera = await before(1);
  const { luminance, flame } = await look(camera);
  const [x, y, z] = flame.position;
  const errors = pixels().map(({ column, row, index }) => {
    const [u, v] = onWall(camera, column, row);
    const d = z + WALL;
    const distance = Math.hypot(u - x, v - y, d);
    const expected = (flame.luminousIntensity * d) / distance ** 3;
    return illuminance(luminance[index] ?? 0) / expected - 1;
  });
  const worst = Math.max(...errors.map(Math.abs));
  const deviation = Math.sqrt(mean(errors.map((error) => error ** 2)));
  console.log(`wall: worst ${worst.toFixed(4)}, deviation ${deviation.toFixed(4)}`);
  expect(worst).toBeLessThan(0.03);
  expect(deviation).toBeLessThan(0.01);
});

test("Radiance is that of the room, whatever the exposure, and the picture is not", async () => {
  const camera = await before(1);
  const plain = await look(camera);
  const picture = await room.pixels();
  await room.set({ exposure: "2" });
  expect((await look(camera)).luminance).toEqual(plain.luminance);
  expect(await room.pixels()).not.toBe(picture);
  await room.set({ exposure: "0" });
});

test("Penumbras are as wide as the flame's width and height make them", async () => {
  await room.evaluate((element) => {
    element.camera = { position: [0, 1.6, 0.7], yaw: Math.PI, pitch: -1.107 };
    element.place();
  });
  const camera: Camera = { position: [-0.15, 0.3, WALL - 0.55], yaw: Math.PI, pitch: 0 };
  const { luminance, flame } = await look(camera);
  const { luminance: unshadowed } = await look(camera, false);
  const [x, y, z] = flame.position;
  const shares = pixels().map(({ column, row, index }) => {
    const [u, v] = onWall(camera, column, row);
    return { u, v, share: (luminance[index] ?? 0) / (unshadowed[index] ?? 1), column, row };
  });
  const stretch = (WALL - z) / (SLAB.min[2] - z);
  const corner = [x + (SLAB.max[0] - x) * stretch, y + (SLAB.max[1] - y) * stretch] as const;
  const profile = (line: "column" | "row", isIn: (u: number, v: number) => boolean) => {
    const inside = shares.filter(({ u, v }) => isIn(u, v));
    const curve = [...new Set(inside.map((pixel) => pixel[line]))].map((number) => {
      const all = inside.filter((pixel) => pixel[line] === number);
      return {
        place: mean(all.map(({ u, v }) => (line === "column" ? u : v))),
        share: mean(all.map(({ share }) => share)),
      };
    });
    curve.sort((a, b) => a.place - b.place);
    return [curve.map(({ place }) => place), curve.map(({ share }) => share)] as const;
  };
  const upright = profile("column", (_, v) => v < corner[1] - 0.12);
  const level = profile("row", (u) => u < corner[0] - 0.1);
  const [width, height] = [penumbra(...upright), penumbra(...level)];
  const { radius, halfHeight } = flameLight(carriedFlame(createWorld("physical", 1)), TAPER);
  const expected = [2 * radius * (stretch - 1), 2 * halfHeight * (stretch - 1)] as const;
  console.log(
    `penumbra ${width.toFixed(4)} of ${expected[0].toFixed(4)}, ${height.toFixed(4)} of ${expected[1].toFixed(4)} m`,
  );
  // A texel of the shadow cube, thrown from the slab onto the wall, is a centimetre.
  expect(Math.abs(crossing(...upright, 0.5) - corner[0])).toBeLessThan(0.012);
  expect(Math.abs(crossing(...level, 0.5) - corner[1])).toBeLessThan(0.012);
  expect(Math.abs(width / expected[0] - 1)).toBeLessThan(0.35);
  expect(Math.abs(height / expected[1] - 1)).toBeLessThan(0.35);
  expect(height / width).toBeGreaterThan(3);
  expect(height / width).toBeLessThan(5);
});

test("Nothing is in its own shadow, however grazing the light", async () => {
  await room.evaluate((element) => {
    element.camera = { position: [0, 1.6, 0.7], yaw: Math.PI, pitch: -1.107 };
    element.place();
  });
  // Floor and walls up to 5.5 m from a flame 0.2 m above the floor.
  const camera: Camera = { position: [0, 1.6, 1.2], yaw: 0, pitch: -0.3 };
  const { luminance } = await look(camera);
  const { luminance: unshadowed } = await look(camera, false);
  const shares = luminance.map((x, index) => x / Math.max(unshadowed[index] ?? 0, 1e-9));
  const dark = shares.filter((share) => share < 0.99).length / shares.length;
  console.log(
    `grazing: least ${Math.min(...shares).toFixed(3)}, share in shadow ${dark.toFixed(5)}`,
  );
  expect(Math.min(...unshadowed)).toBeGreaterThan(0);
  // Where a wall meets the floor far away, a texel of the cube has both: two centimetres at five metres.
  expect(dark).toBeLessThan(0.0025);
});

test("The shadow of a wire close before a wall is one line", async () => {
  await room.evaluate((element, z) => {
    element.take();
    element.camera = { position: [1.5, 1.6, z], yaw: Math.PI, pitch: -1.107 };
    element.place();
  }, WALL - 1.6);
  const camera: Camera = { position: [1.5, 0.45, WALL - 0.4], yaw: Math.PI, pitch: 0 };
  const { luminance } = await look(camera);
  const { luminance: unshadowed } = await look(camera, false);
  const darkest = new Map<number, number>();
  for (const { column, row, index } of pixels()) {
    const [u, v] = onWall(camera, column, row);
    if (u < 1.35 || u > 1.65 || v < 0.3 || v > 0.312) continue;
    const share = (luminance[index] ?? 0) / (unshadowed[index] ?? 1);
    darkest.set(column, Math.min(share, darkest.get(column) ?? 1));
  }
  const broken = [...darkest.values()].filter((share) => share > 0.5).length;
  console.log(`wire: ${broken} of ${darkest.size} columns without a shadow`);
  expect(darkest.size).toBeGreaterThan(100);
  expect(broken).toBe(0);
});

// At the end: of another room.
for (const [quality, tolerance, albedo] of [
  ["high", 0.05, 0.9],
  ["low", 0.1, 0.8],
] as const) {
  test(`A closed room of albedo ${albedo} absorbs all that its flame sends out, at ${quality}`, async () => {
    const src = `${LIBRARY}white-${albedo}.glb`;
    await page.route(src, (route) =>
      route.fulfill({
        contentType: "model/gltf-binary",
        body: plainRoom(WHITE_ROOM, [], albedo),
      }),
    );
    await room.evaluate(
      async (element, { src, quality, width, height }) => {
        const loaded = new Promise((resolve) =>
          element.addEventListener("load", resolve, { once: true }),
        );
        Object.assign(element.style, { width: `${width}px`, height: `${height}px` });
        Object.assign(element, { src, quality });
        await loaded;
        element.reset();
      },
      { src, quality, ...SQUARE },
    );
    await expect.poll(async () => (await room.stats()).quality).toBe(quality);
    await room.switchFeatures({
      shadows: true,
      indirect: true,
      specular: true,
      candle: false,
      volume: false,
      smoke: false,
      haze: false,
      dust: false,
    });
    const share = await absorbedShare(room, albedo);
    console.log(
      `${quality}, albedo ${albedo}: ${share.toFixed(3)} of the flame's flux is absorbed`,
    );
    expect(Math.abs(share - 1)).toBeLessThan(tolerance);
  });
}
