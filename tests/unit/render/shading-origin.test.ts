import { expect, test } from "vitest";
import { shadingOrigin } from "../../../src/render/gbuffer/shading-origin.ts";
import { captureLight } from "../../../src/render/light-block.ts";
import { advance } from "../../../src/world/advance.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { lightFrom } from "../../../src/world/moon.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { createWorld } from "../../support/world.ts";

const WICKS = [6, -2].map((x) => ({
  name: `wick.${x}`,
  position: [x, 1, 0] as Vec3,
  wickDiameter: 0.002,
}));

test("Relief is lit from a light that shines: the carried flame, else the nearest standing one, else the moon", () => {
  const world = createWorld("physical", 1, { wicks: WICKS });
  world.moon = { illuminance: 0.15, direction: lightFrom(90, 30) };
  const origin = () =>
    shadingOrigin(
      { world, captureLight: captureLight(world, true) },
      world.moon?.direction ?? null,
    );
  const distanceTo = (place: readonly number[]) =>
    Math.hypot(...origin().map((x, axis) => x - (place[axis] ?? 0)));
  const [far, near] = world.standing;
  advance(world, STILL, 0);
  expect(distanceTo(captureLight(world, true).position), "the carried flame's").toBeLessThan(0.05);

  far?.flame.light();
  near?.flame.light();
  world.flame.extinguish();
  advance(world, STILL, 20);
  const [x, y, z] = near?.root ?? [0, 0, 0];
  expect(distanceTo([x, y + 0.02, z]), "the nearest's").toBeLessThan(0.05);
  near?.flame.extinguish();
  advance(world, STILL, 20);
  expect(distanceTo([6, 1.02, 0]), "the other's").toBeLessThan(0.05);

  far?.flame.extinguish();
  advance(world, STILL, 20);
  const before = origin();
  const length = Math.hypot(...before);
  const cosine = lightFrom(90, 30).reduce((sum, x, axis) => sum - x * (before[axis] ?? 0), 0);
  expect(length, "as far as the moon").toBeGreaterThan(1e5);
  expect(cosine / length).toBeGreaterThan(0.99);
  world.moon = { illuminance: 0.15, direction: lightFrom(90.2, 30.1) };
  expect(JSON.stringify(origin()), "the same while it moves a little").toBe(JSON.stringify(before));

  world.moon = null;
  expect(distanceTo(captureLight(world, true).position), "the ember's").toBeLessThan(0.05);
});
