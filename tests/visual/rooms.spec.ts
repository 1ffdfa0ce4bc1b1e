import type { Page } from "playwright/test";
import type { Camera } from "../../src/candle-flame-element.ts";
import { luma } from "../../src/light/color.ts";
import { openGlb, packGlb } from "../../tools/models/glb-builder.mjs";
import { ROOMS, roomModel } from "../../tools/reference/rooms.mjs";
import { colorOf } from "../support/display-transform.ts";
import {
  type Errors,
  errorsBesideReference,
  quantile,
  renderView,
  tracedViews,
} from "../support/reference.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

/** Measured on 2026-11-29 at `high`, pixel by pixel, and at `low` by means over blocks of 6 x 6 pixels. */
const MEASURED: Readonly<Record<"high" | "low", Readonly<Record<string, Errors>>>> = {
  high: {
    "white-box": { median: 0.02, high: 0.04, mean: 0.019 },
    "coloured-box": { median: 0.018, high: 0.053, mean: 0.006 },
    "two-rooms": { median: 0.041, high: 0.115, mean: 0.021 },
    "two-rooms-dark": { median: 0.037, high: 0.147, mean: 0.003 },
    corridor: { median: 0.028, high: 0.059, mean: -0.004 },
    metals: { median: 0.027, high: 0.124, mean: 0.013 },
  },
  low: {
    "white-box": { median: 0.05, high: 0.085, mean: 0.039 },
    "coloured-box": { median: 0.048, high: 0.152, mean: 0.038 },
    "two-rooms": { median: 0.072, high: 0.239, mean: 0.041 },
    "two-rooms-dark": { median: 0.067, high: 0.246, mean: -0.001 },
    corridor: { median: 0.035, high: 0.083, mean: 0.013 },
    metals: { median: 0.05, high: 0.211, mean: -0.033 },
  },
};
/** Whatever was measured. */
const LIMITS: Readonly<Record<"high" | "low" | "through doors", Errors>> = {
  high: { median: 0.06, high: 0.15, mean: 0.03 },
  low: { median: 0.1, high: 0.25, mean: 0.06 },
  "through doors": { median: 0.1, high: 0.25, mean: 0.03 },
};
const HAVE_DOORS = /two-rooms|corridor/;
const NONE: Errors = { median: 0, high: 0, mean: 0 };
const MARGIN: Errors = { median: 0.01, high: 0.02, mean: 0.015 };
const BLOCK = { high: 1, low: 6 } as const;
const SIZE = { width: 320, height: 180 };

let page: Page;
let driver: RoomDriver | null = null;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
});
test.afterAll(() => page.close());

/** A room at a tier, in one element for all: its programs are compiled once. */
async function open(
  name: string,
  quality: string,
  model: Buffer = roomModel(ROOMS[name] ?? []),
): Promise<RoomDriver> {
  const src = `${LIBRARY}${name}.glb`;
  await page.route(src, (route) =>
    route.fulfill({ contentType: "model/gltf-binary", body: model }),
  );
  const attributes = { look: "physical", quality, wind: "0", src };
  if (!driver) driver = await new RoomDriver(page).open(attributes, SIZE);
  await driver.evaluate(async (element, { src, quality }) => {
    const loaded = new Promise((resolve) =>
      element.addEventListener("load", resolve, { once: true }),
    );
    const isAnother = element.src !== src;
    element.src = src;
    element.setAttribute("quality", quality);
    if (isAnother) await loaded;
  }, attributes);
  return driver;
}

const views = tracedViews.filter(({ room }) => room !== undefined);

test("There are rooms of several kinds", () => {
  expect(new Set(views.map(({ room }) => room)).size).toBeGreaterThanOrEqual(5);
  const names = views.map(({ name }) => name).sort();
  for (const tier of Object.values(MEASURED)) expect(Object.keys(tier).sort()).toEqual(names);
});

/** Each room is loaded once, at low, which prepares its light in a fraction of the time. */
const inTurn = [...new Set(views.map(({ room }) => room))].flatMap((room) =>
  (["low", "high"] as const).flatMap((quality) =>
    views
      .filter((view) => view.room === room && view.name in MEASURED[quality])
      .map((view) => ({ quality, view })),
  ),
);

for (const { quality, view } of inTurn) {
  const { name, room = "" } = view;
  test(`At ${quality} the light of “${name}” is a path tracer's`, async () => {
    const driver = await open(room, quality);
    const mine = await renderView(driver, view, quality === "high");
    for (const axis of [0, 1, 2] as const) {
      expect(mine.position?.[axis]).toBeCloseTo(view.flame.position[axis], 3);
    }
    const measured = errorsBesideReference(view, mine, BLOCK[quality]);
    const report = Object.entries(measured).map(([what, x]) => `${what}: ${x.toFixed(3)}`);
    console.log(`${quality} "${name}": { ${report.join(", ")} },`);
    const before = MEASURED[quality][name] ?? NONE;
    const limits = LIMITS[quality === "high" && HAVE_DOORS.test(name) ? "through doors" : quality];
    expect.soft(measured.median).toBeLessThanOrEqual(limits.median);
    expect.soft(measured.high).toBeLessThanOrEqual(limits.high);
    expect.soft(Math.abs(measured.mean)).toBeLessThanOrEqual(limits.mean);
    expect.soft(measured.median).toBeLessThanOrEqual(before.median + MARGIN.median);
    expect.soft(measured.high).toBeLessThanOrEqual(before.high + MARGIN.high);
    expect.soft(Math.abs(measured.mean - before.mean)).toBeLessThanOrEqual(MARGIN.mean);
    expect(driver.complaints).toEqual([]);
  });
}

test("A room that is turned about the vertical has the same light", async () => {
  const yaw = Math.PI / 6;
  const view = views.find(({ name }) => name === "two-rooms")!;
  const turned = <Placed extends Camera>(camera: Placed): Placed => {
    const [x, y, z] = camera.position;
    const [cosine, sine] = [Math.cos(yaw), Math.sin(yaw)];
    const position: [number, number, number] = [cosine * x + sine * z, y, cosine * z - sine * x];
    return { ...camera, position, yaw: camera.yaw + yaw };
  };
  const { json, binary } = openGlb(roomModel(ROOMS["two-rooms"] ?? []));
  const [scene] = json.scenes;
  const rotation = [0, Math.sin(yaw / 2), 0, Math.cos(yaw / 2)];
  scene.nodes = [json.nodes.push({ children: scene.nodes, rotation }) - 1];
  const driver = await open("turned", "low", packGlb(json, binary));
  const { camera, place } = view;
  const staged = { ...view, camera: turned(camera), ...(place && { place: turned(place) }) };
  const measured = errorsBesideReference(view, await renderView(driver, staged, false), BLOCK.low);
  const before = MEASURED.low["two-rooms"] ?? NONE;
  expect.soft(measured.median).toBeLessThanOrEqual(before.median + MARGIN.median);
  expect.soft(measured.high).toBeLessThanOrEqual(before.high + MARGIN.high);
  expect.soft(Math.abs(measured.mean - before.mean)).toBeLessThanOrEqual(MARGIN.mean);
  expect(driver.complaints).toEqual([]);
});

for (const quality of ["low", "high"] as const) {
  test(`At ${quality} a wall of 12 cm lets a thousandth of the light through at most`, async () => {
    const driver = await open("sealed", quality);
    const luminances = async (position: [number, number, number], yaw: number) => {
      const camera = { position, yaw, pitch: 0 };
      const { radiance } = await renderView(driver, {
        camera,
        place: { position: [2, 1.6, 4.2], yaw: 0, pitch: -1 },
      });
      const there = await driver.evaluate(({ camera, held }) => ({ ...camera, held }));
      expect(there.held).toBe(false);
      expect(there.position[0], "across the wall").toBeCloseTo(position[0], 2);
      return Array.from({ length: radiance.length / 3 }, (_, i) => luma(colorOf(radiance, i)));
    };
    const mean = (values: readonly number[]) =>
      values.reduce((sum, value) => sum + value, 0) / values.length;
    const lit = mean(await luminances([1.2, 1.6, 3.2], -1.57));
    expect(lit).toBeGreaterThan(0.05);
    for (const dark of [
      await luminances([7.5, 1.6, 4.8], 1.57),
      await luminances([8, 1.6, 2], -1.57),
    ]) {
      expect(mean(dark) / lit).toBeLessThan(1e-3);
      expect(quantile(dark, 0.99) / lit).toBeLessThan(1e-3);
    }
    expect(driver.complaints).toEqual([]);
  });
}

test("In a white room plaster a metre from the candle is shown as white paper is, in a dark one no brighter than it is", async () => {
  for (const [albedo, least, most] of [
    [0.8, 0.2, 0.5],
    [0.1, 0.005, 0.1],
  ] as const) {
    const material = { color: [albedo, albedo, albedo] as const, roughness: 1 };
    const shell = { min: [0, 0, 0], max: [4, 2.6, 4], material, isShell: true } as const;
    const driver = await open(`plaster-${albedo}`, "low", roomModel([shell]));
    // The candle in the hand is 0.55 m ahead: a metre from the wall.
    const position = [2, 1.4, 1.55] as const;
    const { data, width } = await driver.picture({
      attributes: { motion: "reduced" },
      camera: { position, yaw: 0, pitch: 0 },
      seconds: 12,
    });
    const flame = await driver.evaluate((element) => element.flame?.position);
    expect(flame?.[2]).toBeGreaterThan(0.8);
    expect(flame?.[2]).toBeLessThan(1.2);
    // Beside the flame, at its height: the wall a metre away.
    const linear = (byte = 0) => ((byte / 255 + 0.055) / 1.055) ** 2.4;
    let sum = 0;
    const columns = [...Array(20).keys()].map((i) => Math.floor(width * 0.35) + i);
    const row = Math.floor((data.length / 4 / width) * 0.6);
    for (const column of columns) {
      const at = (row * width + column) * 4;
      sum += luma([linear(data[at]), linear(data[at + 1]), linear(data[at + 2])]);
    }
    const shown = sum / columns.length;
    console.log(`albedo ${albedo}: ${shown.toFixed(3)} of white`);
    expect.soft(shown).toBeGreaterThan(least);
    expect.soft(shown).toBeLessThanOrEqual(most);
  }
});
