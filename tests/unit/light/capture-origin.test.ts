import { expect, test } from "vitest";
import { captureOrigin } from "../../../src/light/capture-origin.ts";
import { captureLight } from "../../../src/render/light-block.ts";
import { advance } from "../../../src/world/advance.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { createWorld } from "../../support/world.ts";

test("a flame that only flickers is captured from one place", () => {
  const places = Array.from({ length: 50 }, (_, i) => {
    const sway = 0.006 * Math.sin(i);
    return captureOrigin(
      [1, 0.95, -0.5],
      [1 + sway, 0.95 + 0.018 + sway, -0.5 - sway],
      0.04,
    ).join();
  });
  expect(new Set(places).size).toBe(1);
});

test("it is within the flame's reach of the light, wherever the flame stands and leans", () => {
  for (let i = 0; i < 200; i++) {
    const foot = [i * 0.0137, 1 + i * 0.0021, -i * 0.0093] as const;
    const light = [foot[0] + 0.05 * Math.sin(i), foot[1] + 0.001 * i, foot[2]] as const;
    const from = captureOrigin([...foot], [...light], 0.04);
    for (const axis of [0, 1, 2] as const) {
      expect(Math.abs(from[axis] - light[axis])).toBeLessThan(0.0225);
    }
  }
});

test("it stays where it is in calm air, however far a wide wick's flame puffs", () => {
  for (const wick of [0.002, 0.01, 0.04, 0.05]) {
    const wind = { speed: 0.05, direction: 0, gustiness: 0.5 };
    const world = createWorld("physical", 1, { wick, wind });
    world.candle.isHeld = false;
    const places = Array.from({ length: 300 }, () => {
      advance(world, STILL, 1 / 30);
      return captureLight(world, true).position.join();
    });
    expect(new Set(places).size, `${wick} m`).toBe(1);
  }
});
