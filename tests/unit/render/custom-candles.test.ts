import { describe, expect, test } from "vitest";
import type { Part } from "../../../src/assets/model.ts";
import { clipFromWorld, clipPosition } from "../../../src/render/camera.ts";
import { boundsWithFlames, frameBox } from "../../../src/render/lone-candle/custom-framing.ts";
import { LightMeter, MOST_EXPOSURE } from "../../../src/render/lone-candle/light-meter.ts";
import { Flame } from "../../../src/world/flame/flame.ts";
import type { Bounds, Vec3 } from "../../../src/world/geometry.ts";
import { floorOf } from "../world/rooms.ts";

const BOXES: readonly Bounds[] = [
  { min: [-0.05, 0, -0.05], max: [0.05, 0.15, 0.05] },
  { min: [-0.3, 0.1, -0.3], max: [0.3, 0.2, 0.3] },
  { min: [1, 2, 3], max: [1.02, 2.4, 3.02] },
];

describe("a model alone", () => {
  test.each([0.3, 1, 16 / 9, 4])("fills a canvas of aspect %f, whole", (aspect) => {
    for (const box of BOXES) {
      const { eye, pitch, fieldOfView } = frameBox(box, aspect);
      const clip = clipFromWorld(eye, 0, pitch, aspect, fieldOfView);
      let most = 0;
      for (let corner = 0; corner < 8; corner++) {
        const [x = 0, y = 0, z = 0] = [0, 1, 2].map(
          (axis) => (corner & (1 << axis) ? box.max : box.min)[axis] ?? 0,
        );
        const [across, up, w] = clipPosition(clip, x, y, z);
        most = Math.max(most, Math.abs(across / w), Math.abs(up / w));
      }
      expect(most).toBeCloseTo(0.92, 5);
    }
  });

  test("has room for its flames", () => {
    const [box] = BOXES;
    const wick = { name: "wick", position: [0, 0.15, 0] as Vec3, wickDiameter: 0.002 };
    const { min, max } = boundsWithFlames(box ?? { min: [0, 0, 0], max: [0, 0, 0] }, [wick]);
    expect(max[1]).toBeGreaterThan(0.15 + 0.035);
    expect(max[1]).toBeLessThan(0.15 + 0.06);
    expect(min).toEqual([-0.05, 0, -0.05]);
  });
});

describe("the exposure of a model alone", () => {
  const flame = (isLit: boolean) => new Flame(0.002, isLit);
  const plate = { ...floorOf(0.3), material: { isWax: false } } as unknown as Part;
  const roots: Vec3[] = [0, 1, 2, 3].map((i) => [0.04 * i - 0.06, 0.1, 0]);
  const exposureOf = (...areLit: boolean[]) =>
    new LightMeter([plate], roots.length).measure(
      areLit.map((isLit, i) => ({ root: roots[i] ?? [0, 0, 0], flame: flame(isLit) })),
    ).exposure;

  test("falls as flames are added, and never by more than they add", () => {
    const [one, four] = [exposureOf(true, false, false, false), exposureOf(true, true, true, true)];
    expect(four).toBeLessThan(0.6 * one);
    expect(four).toBeGreaterThan(0.2 * one);
  });

  test("is that of flames as high as their wicks are wide, and follows them", () => {
    const meter = new LightMeter([plate], 1);
    const exposures = [0.002, 0.01, 0.002].map((wick) => {
      const wide = flame(true);
      wide.wick = wick;
      return meter.measure([{ root: [0, 0.01, 0], flame: wide }]).exposure;
    });
    // From higher up more of the plate is lit by more than a grazing light.
    expect(exposures[1]).toBeLessThan(0.9 * exposures[0]!);
    expect(exposures[2]).toBe(exposures[0]);
  });

  test("is bounded where all are out", () => {
    expect(exposureOf(false, false, false, false)).toBe(MOST_EXPOSURE);
  });
});
