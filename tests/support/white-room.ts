// A closed room, and how much of its flame's light its walls absorb.
import { expect } from "playwright/test";
import { luma } from "../../src/light/color.ts";
import type { RoomDriver } from "./room-driver.ts";

export const WHITE_ROOM = { min: [-2, 0, -2], max: [2, 2.6, 2] } as const;
const EYE = [0.3, 1.4, 0.2] as const;
/** CSS pixels of the element that looks at its walls. */
export const SIZE = { width: 96, height: 96 };
const FIELD_OF_VIEW = 1.85;
/** Cells along each edge of a wall. */
const CELLS = 6;
/** Share of the light from all around that rough dielectrics reflect specularly: `lib/reflectance.glsl`. */
const SPECULAR = 0.02;

/** Cell of the wall that a ray from the eye hits, its area, and the area of a pixel there but for a factor. */
function hit(direction: readonly number[]): { cell: string; area: number; weight: number } {
  let nearest = { distance: Number.POSITIVE_INFINITY, axis: 0, side: 0 };
  for (const axis of [0, 1, 2]) {
    const way = direction[axis] ?? 0;
    const end = (way > 0 ? WHITE_ROOM.max : WHITE_ROOM.min)[axis] ?? 0;
    const distance = (end - (EYE[axis] ?? 0)) / way;
    if (distance < nearest.distance) nearest = { distance, axis, side: Math.sign(way) };
  }
  const sizes = [0, 1, 2].map((axis) => (WHITE_ROOM.max[axis] ?? 0) - (WHITE_ROOM.min[axis] ?? 0));
  const places = [0, 1, 2].map((axis) => {
    const place = (EYE[axis] ?? 0) + nearest.distance * (direction[axis] ?? 0);
    return Math.min(
      Math.floor(((place - (WHITE_ROOM.min[axis] ?? 0)) / (sizes[axis] ?? 1)) * CELLS),
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

/** Share of the flame's flux that walls of an albedo absorb, by their luminance. */
export async function absorbedShare(room: RoomDriver, albedo: number): Promise<number> {
  await room.evaluate((element, position) => {
    element.camera = { position, yaw: 0.4, pitch: -1.3 };
    element.place();
  }, EYE);
  const { integral, luminousIntensity } = await measure(room);
  const reflectance = albedo + (1 - albedo) * SPECULAR;
  // Outgoing luminance is reflectance times illuminance over pi; what is not reflected is absorbed.
  const absorbed = ((integral * Math.PI) / reflectance) * (1 - reflectance);
  return absorbed / (4 * Math.PI * luminousIntensity);
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
