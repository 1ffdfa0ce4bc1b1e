import { describe, expect, test } from "vitest";
import { clipFromWorld } from "../../../src/render/camera.ts";
import { frameBlock } from "../../../src/render/frame-block.ts";
import type { FrameSettings } from "../../../src/render/frame-settings.ts";
import { advance } from "../../../src/world/advance.ts";
import { moveCamera } from "../../../src/world/commands.ts";
import { fieldOfViewOf } from "../../../src/world/player/field-of-view.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { TICK } from "../../../src/world/timeline.ts";
import type { World } from "../../../src/world/world.ts";
import { createWorld } from "../../support/world.ts";

const RATES = [50, 60, 75, 144, 240];
const TURNING = { ...STILL, turn: 1, tilt: 0.5 };

function drawn(world: World): { yaw: number; pitch: number } {
  const { yaw, pitch } = world.interpolated;
  return { yaw, pitch };
}

describe("the view that is drawn", () => {
  test.each(RATES)("turns evenly by keys at %d Hz, from the first frame to the last", (rate) => {
    const world = createWorld("paper", 1);
    advance(world, STILL, 0.4 * TICK);
    const first = world.player.yaw;
    for (let frame = 0; frame < rate; frame++) {
      const before = drawn(world);
      const isHeld = frame >= 5 && frame < rate / 2;
      advance(world, isHeld ? TURNING : STILL, 1 / rate);
      const { yaw, pitch } = drawn(world);
      expect((yaw - before.yaw) * rate, `frame ${frame}`).toBeCloseTo(isHeld ? 1.6 : 0, 9);
      expect((pitch - before.pitch) * rate, `frame ${frame}`).toBeCloseTo(isHeld ? 0.5 : 0, 9);
    }
    advance(world, STILL, TICK);
    expect(world.interpolated.yaw).toBe(world.player.yaw);
    expect(world.player.yaw - first).toBeCloseTo((1.6 * (Math.ceil(rate / 2) - 5)) / rate, 9);
  });

  test("is that of the frame's camera, and of the candle that turns with it", () => {
    const world = createWorld("paper", 1);
    advance(world, TURNING, 1.6 * TICK);
    const { yaw, pitch, eye, candleYaw } = world.interpolated;
    expect(Math.abs(yaw - world.player.yaw)).toBeGreaterThan(0.005);
    expect(candleYaw).toBe(yaw);
    const settings = { features: {} } as FrameSettings;
    const block = frameBlock(world, settings, { width: 2, height: 1 }, 1);
    expect(block.clipFromWorld).toEqual(clipFromWorld(eye, yaw, pitch, 2, fieldOfViewOf(world)));
  });

  test("looks as high and as low as the camera may, and no farther", () => {
    const world = createWorld("paper", 1);
    for (let i = 0; i < 500; i++) advance(world, { ...STILL, tilt: 1 }, 0.6 * TICK);
    const { pitch } = world.player;
    advance(world, { ...STILL, tilt: 1 }, 0.6 * TICK);
    expect(world.interpolated.pitch).toBe(pitch);
  });

  test("is exactly where the camera is put while keys turn it, and turns on if it is only moved", () => {
    const world = createWorld("paper", 1);
    advance(world, TURNING, 1.6 * TICK);
    const before = drawn(world);
    moveCamera(world, [1, 1.6, 1], world.player.yaw, world.player.pitch);
    expect(drawn(world)).toEqual(before);
    moveCamera(world, [1, 1.6, 1], 0.3, 0.1);
    expect(drawn(world)).toEqual({ yaw: 0.3, pitch: 0.1 });
  });
});
