import type { Page } from "playwright/test";
import { luma } from "../../src/light/color.ts";
import { drawOneSample } from "../support/one-sample.ts";
import { plainRoom } from "../support/plain-room.ts";
import { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const ROOM = { min: [-2, 0, -2], max: [2, 2.6, 2] } as const;
const EYE = [0.3, 1.4, 0.2] as const;
const SIZE = { width: 96, height: 96 };
const FIELD_OF_VIEW = 1.85;
/** Cells along each edge of a wall. */
const CELLS = 6;
/** Share of the light from all around that rough dielectrics reflect specularly: `lib/reflectance.glsl`. */
const SPECULAR = 0.02;

let page: Page;

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await drawOneSample(page);
});
test.afterAll(() => page.close());

/** Cell of the wall that a ray from the eye hits, its area, and the area of a pixel there but for a factor. */
function hit(direction: readonly number[]): { cell: string; area: number; weight: number } {
  let nearest = { distance: Number.POSITIVE_INFINITY, axis: 0, side: 0 };
  for (const axis of [0, 1, 2]) {
    const way = direction[axis] ?? 0;
    const end = (way > 0 ? ROOM.max : ROOM.min)[axis] ?? 0;
    const distance = (end - (EYE[axis] ?? 0)) / way;
    if (distance < nearest.distance) nearest = { distance, axis, side: Math.sign(way) };
  }
  const sizes = [0, 1, 2].map((axis) => (ROOM.max[axis] ?? 0) - (ROOM.min[axis] ?? 0));
  const places = [0, 1, 2].map((axis) => {
    const place = (EYE[axis] ?? 0) + nearest.distance * (direction[axis] ?? 0);
    return Math.min(
      Math.floor(((place - (ROOM.min[axis] ?? 0)) / (sizes[axis] ?? 1)) * CELLS),
      CELLS - 1,
    );
  });
  const [u = 0, v = 0] = [0, 1, 2].filter((axis) => axis !== nearest.axis);
  const area = ((sizes[u] ?? 0) * (sizes[v] ?? 0)) / CELLS ** 2;
  return {
    cell: [nearest.axis, nearest.side, places[u], places[v]].join(),
    area,
    weight: nearest.distance ** 2 / Math.abs(direction[nearest.axis] ?? 1),
  };
}

/** Integral of the luminance over all walls, and the flame's luminous intensity. */
async function measure(room: RoomDriver) {
  const cells = new Map<string, { area: number; sum: number; weights: number }>();
  let luminousIntensity = 0;
  for (const pitch of [-1.5, 0, 1.5]) {
    for (const yaw of (pitch === 0 ? [0, 0.5, 1, 1.5] : [0]).map((turn) => turn * Math.PI)) {
      const { radiance, candela, width, height } = await room.evaluate(
        (element, camera) => {
          element.camera = camera;
          element.step(0);
          const { width, height } = element.stats;
          const radiance = element.readRadiance(0, 0, width, height);
          const candela = element.flame?.luminousIntensity ?? 0;
          return { radiance, candela, width, height };
        },
        { position: EYE, yaw, pitch, fieldOfView: FIELD_OF_VIEW },
      );
      luminousIntensity = candela;
      const reach = Math.tan(FIELD_OF_VIEW / 2);
      for (let pixel = 0; pixel < width * height; pixel++) {
        const x = reach * (((pixel % width) + 0.5) / (width / 2) - 1);
        const y = reach * (1 - (Math.floor(pixel / width) + 0.5) / (height / 2));
        // The camera looks along -Z; pitch about X, then yaw about Y.
        const [up, back] = [
          y * Math.cos(pitch) + Math.sin(pitch),
          y * Math.sin(pitch) - Math.cos(pitch),
        ];
        const direction = [
          x * Math.cos(yaw) + back * Math.sin(yaw),
          up,
          back * Math.cos(yaw) - x * Math.sin(yaw),
        ];
        const { cell, area, weight } = hit(direction);
        const known = cells.get(cell) ?? { area, sum: 0, weights: 0 };
        known.sum +=
          weight *
          luma([...radiance.subarray(3 * pixel, 3 * pixel + 3)] as [number, number, number]);
        known.weights += weight;
        cells.set(cell, known);
      }
    }
  }
  expect(cells.size, "all cells of all walls are seen").toBe(6 * CELLS ** 2);
  const integral = [...cells.values()].reduce(
    (all, { area, sum, weights }) => all + (area * sum) / weights,
    0,
  );
  return { integral, luminousIntensity };
}

for (const [quality, tolerance, albedo] of [
  ["high", 0.05, 0.9],
  ["low", 0.1, 0.8],
] as const) {
  test(`A closed room of albedo ${albedo} absorbs all that its flame sends out, at ${quality}`, async () => {
    const room = await new RoomDriver(page).open(
      { look: "physical", quality, motion: "reduced" },
      { ...SIZE, model: plainRoom(ROOM, [], albedo) },
    );
    await room.switchFeatures({
      candle: false,
      volume: false,
      smoke: false,
      haze: false,
      dust: false,
    });
    await room.evaluate((element, position) => {
      element.camera = { position, yaw: 0.4, pitch: -1.3 };
      element.place();
    }, EYE);
    const { integral, luminousIntensity } = await measure(room);
    const reflectance = albedo + (1 - albedo) * SPECULAR;
    // Outgoing luminance is reflectance times illuminance over pi; what is not reflected is absorbed.
    const absorbed = ((integral * Math.PI) / reflectance) * (1 - reflectance);
    const share = absorbed / (4 * Math.PI * luminousIntensity);
    console.log(
      `${quality}, albedo ${albedo}: ${share.toFixed(3)} of the flame's flux is absorbed`,
    );
    expect(Math.abs(share - 1)).toBeLessThan(tolerance);
  });
}
