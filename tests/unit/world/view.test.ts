import { describe, expect, test } from "vitest";
import { clipFromWorld } from "../../../src/render/camera.ts";
import { frameBlock } from "../../../src/render/frame-block.ts";
import type { FrameSettings } from "../../../src/render/frame-settings.ts";
import { advance } from "../../../src/world/advance.ts";
import { moveCamera } from "../../../src/world/commands.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import { TICK } from "../../../src/world/timeline.ts";
import type { World } from "../../../src/world/world.ts";
import { fieldOfViewOf } from "../../../src/world/world.ts";
import { createWorld } from "../../support/world.ts";
import { insideOf } from "./rooms.ts";

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

describe("the candle in the hand", () => {
  const room = () => createRoom(new CollisionMesh([insideOf([-9, 0, -9], [9, 2.6, 9])]), null);

  /** Its angle from the line of sight in each frame, radians, while the head turns to and fro. */
  function angles(rate: number): number[] {
    const world = createWorld("physical", 1, { room: room() });
    return Array.from({ length: rate }, (_, frame) => {
      const swing = 0.5 * (Math.cos((9 * frame) / rate) - Math.cos((9 * (frame + 1)) / rate));
      advance(world, { ...STILL, yaw: swing, right: 0.2 }, 1 / rate);
      const { eye, foot, yaw } = world.interpolated;
      const angle = Math.atan2(eye[0] - foot[0], eye[2] - foot[2]) - yaw;
      return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
    });
  }

  test.each([75, 144, 165, 240])("moves as evenly as the view at %d Hz", (rate) => {
    const shown = angles(rate);
    expect(Math.max(...shown) - Math.min(...shown)).toBeGreaterThan(0.3);
    const jolts = shown.map((angle, i) => {
      const [before = angle, last = angle] = [shown[i - 2], shown[i - 1]];
      return Math.abs(angle - 2 * last + before) * rate * rate;
    });
    expect(Math.max(...jolts.slice(10)), "rad/s²").toBeLessThan(60);
  });

  test("is left as it was at the last tick", () => {
    const world = createWorld("physical", 1, { room: room() });
    const turning = { ...STILL, yaw: 0.02, turn: 1, forward: 1 };
    advance(world, turning, 5 * TICK);
    const [hand, candle, emitter] = structuredClone([world.hand, world.candle, world.emitter]);
    expect(world.interpolated.foot).toEqual(candle.position);
    advance(world, turning, 0.9 * TICK);
    expect([world.hand, world.candle, world.emitter]).toEqual([hand, candle, emitter]);
    expect(world.interpolated.foot).not.toEqual(candle.position);
  });

  test("is shown where the next tick has it", () => {
    const [shown, felt] = [0.99999, 1].map((part) => {
      const world = createWorld("physical", 1, { room: room() });
      const turning = { ...STILL, turn: 1 };
      for (let i = 0; i < 30; i++) advance(world, turning, TICK);
      advance(world, { ...turning, yaw: 0.02 }, part * TICK);
      return world;
    }) as [World, World];
    shown.interpolated.foot.forEach((x, axis) => {
      expect(x).toBeCloseTo(felt.candle.position[axis] ?? Number.NaN, 5);
    });
  });
});
