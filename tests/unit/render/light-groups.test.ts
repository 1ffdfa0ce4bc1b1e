import { expect, test } from "vitest";
import { FIRST_FLAMES, LightGroups } from "../../../src/render/lone-candle/light-groups.ts";
import { Flame } from "../../../src/world/flame/flame.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";

test("A group's image is of its flames until they glow no more, not until they are put out", () => {
  const groups = new LightGroups(7);
  const rooted = Array.from({ length: 7 }, (_, i) => {
    return { root: [i, 0, 0] as Vec3, flame: new Flame(0.002, true) };
  });
  const imaged = () => groups.flamesOf(rooted)[FIRST_FLAMES];
  expect(imaged()).toEqual([0, 6]);
  const first = rooted[0]!.flame;
  first.extinguish();
  expect(first.glow).toBeGreaterThan(0);
  expect(imaged()).toEqual([0, 6]);
  first.advance([0, 0, 0], [0, 0, 0], { velocity: () => [0, 0, 0] } as never, true, 5);
  expect(first.glow).toBe(0);
  expect(imaged()).toEqual([6]);
});
