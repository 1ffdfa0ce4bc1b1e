import { describe, expect, test } from "vitest";
import {
  type Candle,
  holdCandle,
  isWithinReach,
  placeOnGround,
} from "../../../src/world/candle.ts";
import { inset, type Vec3 } from "../../../src/world/geometry.ts";
import type { Player } from "../../../src/world/player/player.ts";
import { WALL_MARGIN, WORLD_SETUPS, type WorldSetup } from "../../../src/world/world-setup.ts";
import { chance } from "../chance.ts";

const SETUP = WORLD_SETUPS.paper;
const candle = (): Candle => ({ position: [0, 0, 0], yaw: 0, isHeld: true });
const player = (position: Vec3, yaw = 0, pitch = 0): Player => ({
  position,
  velocity: [0, 0, 0],
  yaw,
  pitch,
});

/** A point as the visitor sees it: right, up, ahead of his eye, when he looks level. */
function seen([x, y, z]: Vec3, { position, yaw }: Player): Vec3 {
  const [dx, dy, dz] = [x - position[0], y - position[1], z - position[2]];
  const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)];
  return [dx * cos - dz * sin, dy, -dx * sin - dz * cos];
}

describe("the candle in the hand (I1)", () => {
  test.each([0, 1, Math.PI / 2, -2.5, Math.PI])(
    "has its foot 0.5 m ahead and 0.4 m below the eye, a little to the right, at yaw %d",
    (yaw) => {
      const visitor = player([1, 1.6, -1], yaw);
      const held = candle();
      holdCandle(held, visitor, SETUP);
      const [right, up, ahead] = seen(held.position, visitor);
      expect(ahead).toBeCloseTo(0.5, 9);
      expect(up).toBeCloseTo(-0.4, 9);
      expect(right).toBeGreaterThan(0);
      expect(right).toBeLessThan(0.3);
    },
  );

  test("does not tilt with the head", () => {
    const level = candle();
    const tilted = candle();
    holdCandle(level, player([0, 1.6, 0], 0.4), SETUP);
    holdCandle(tilted, player([0, 1.6, 0], 0.4, 1.2), SETUP);
    expect(tilted.position).toEqual(level.position);
  });

  test("never pokes out of a wall, wherever the visitor stands and faces", () => {
    const between = chance(7);
    const { min, max } = inset(SETUP.room, WALL_MARGIN);
    const held = candle();
    let nearest = Number.POSITIVE_INFINITY;
    for (let i = 0; i < 5000; i++) {
      const corner = i % 5 === 0;
      const along = (axis: 0 | 2) =>
        corner ? (between(0, 1) < 0.5 ? min[axis] : max[axis]) : between(min[axis], max[axis]);
      holdCandle(
        held,
        player([along(0), between(min[1], max[1]), along(2)], between(-Math.PI, Math.PI)),
        SETUP,
      );
      for (const axis of [0, 2] as const) {
        nearest = Math.min(
          nearest,
          held.position[axis] - SETUP.room.min[axis],
          SETUP.room.max[axis] - held.position[axis],
        );
      }
      expect(held.position[1]).toBeGreaterThan(SETUP.room.min[1]);
      expect(held.position[1] + SETUP.candleScale).toBeLessThan(SETUP.room.max[1]);
    }
    // Room for the holder, and some for the flame's own width.
    expect(nearest).toBeGreaterThan(0.1);
    expect(nearest).toBeLessThan(0.2);
  });

  test("goes through walls where there are none", () => {
    const open: WorldSetup = { ...SETUP, hasWalls: false };
    const held = candle();
    holdCandle(held, player([0, 1.6, -20]), open);
    expect(held.position[2]).toBeCloseTo(-20.5, 9);
  });
});

describe("putting the candle down", () => {
  test("sets it on the floor, within reach ahead", () => {
    const visitor = player([0, 1.6, 0], 0.6);
    const placed = candle();
    placeOnGround(placed, visitor, SETUP);
    expect(placed.isHeld).toBe(false);
    const [right, , ahead] = seen(placed.position, visitor);
    expect(placed.position[1]).toBe(SETUP.room.min[1]);
    expect(right).toBeCloseTo(0, 9);
    expect(ahead).toBeGreaterThan(0.5);
    expect(ahead).toBeLessThan(1.2);
  });

  test("in front of a wall leaves it inside, and still within grasp", () => {
    const visitor = player([4.5, 1.6, 4.5], -Math.PI * 0.75);
    const placed = candle();
    placeOnGround(placed, visitor, SETUP);
    for (const axis of [0, 2] as const) {
      expect(placed.position[axis]).toBeLessThan(SETUP.room.max[axis] - 0.1);
    }
    expect(isWithinReach(placed, visitor)).toBe(true);
  });

  test("a candle across the room is out of grasp", () => {
    const far: Candle = { position: [3, 0, 0], yaw: 0, isHeld: false };
    expect(isWithinReach(far, player([0, 1.6, 0]))).toBe(false);
    expect(isWithinReach(far, player([2, 1.6, 0]))).toBe(true);
  });
});
