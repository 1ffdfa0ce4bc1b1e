import { describe, expect, test } from "vitest";
import { advance } from "../../../../src/world/advance.ts";
import { moveCamera } from "../../../../src/world/commands.ts";
import { type Intent, STILL } from "../../../../src/world/player/intent.ts";
import { MAX_PITCH } from "../../../../src/world/player/player.ts";
import type { World } from "../../../../src/world/world.ts";
import { WALL_MARGIN } from "../../../../src/world/world-setup.ts";
import { createWorld } from "../../../support/world.ts";
import { chance } from "../../chance.ts";

const WALKING: Intent = { ...STILL, forward: 1, right: 0.3, turn: 0.4, runs: true };

function gapToWalls({ player, setup }: World): number {
  return Math.min(
    ...player.position.flatMap((coordinate, axis) => [
      coordinate - setup.room.min[axis]!,
      setup.room.max[axis]! - coordinate,
    ]),
  );
}

describe("walls (I2)", () => {
  test("stand around the visitor from the first, with the candle in his hand", () => {
    const world = createWorld("paper", 1);
    expect(gapToWalls(world)).toBeGreaterThanOrEqual(WALL_MARGIN);
    expect(world.candle.isHeld).toBe(true);
  });

  test("hold through a long random walk at uneven frame rates", () => {
    const between = chance(11);
    const world = createWorld("paper", 1);
    let nearest = Number.POSITIVE_INFINITY;
    for (let i = 0; i < 1500; i++) {
      const wish = { forward: between(-1, 1.5), right: between(-1, 1), yaw: between(-0.3, 0.3) };
      advance(world, { ...STILL, ...wish, runs: true }, between(0, 0.1));
      nearest = Math.min(nearest, gapToWalls(world));
      const { eye } = world.interpolated;
      for (const axis of [0, 2] as const) expect(Math.abs(eye[axis])).toBeLessThanOrEqual(4.5);
    }
    expect(nearest).toBe(WALL_MARGIN);
  });

  const ABSURD: readonly (readonly number[])[] = [
    [1e308, -1e308, 1e308],
    [Number.NaN, Number.NaN, Number.NaN],
    [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY],
    [Number.NEGATIVE_INFINITY, Number.NaN, 0],
    [5, 0, -5],
    [],
  ];
  const ANGLES = [0, 1e6, Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  const finite = ({ player, candle, emitter, interpolated, sample }: World) =>
    [
      ...player.position,
      player.yaw,
      player.pitch,
      ...candle.position,
      ...emitter,
      ...interpolated.eye,
      ...interpolated.foot,
      ...interpolated.flame,
      ...(sample?.state ?? []),
    ].every(Number.isFinite);

  test.each(ABSURD)("hold against being put at %d, %d, %d", (...position) => {
    for (const angle of ANGLES) {
      const world = createWorld("paper", 1);
      moveCamera(world, position, angle, -angle);
      expect(gapToWalls(world)).toBeGreaterThanOrEqual(WALL_MARGIN);
      expect(Math.abs(world.player.pitch)).toBeLessThanOrEqual(MAX_PITCH);
      advance(world, WALKING, 0.1);
      expect(gapToWalls(world)).toBeGreaterThanOrEqual(WALL_MARGIN);
      expect(finite(world)).toBe(true);
    }
  });

  test.each([
    [Number.NaN, Number.NaN, Number.NaN],
    [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, 0],
  ])("or not, nobody can be at %d, %d, %d", (...position) => {
    const world = createWorld("original", 1);
    moveCamera(world, position, Number.NaN, Number.NaN);
    advance(world, WALKING, 0.1);
    expect(finite(world)).toBe(true);
  });

  test("a point beyond a wall is the nearest one before it", () => {
    const world = createWorld("paper", 1);
    moveCamera(world, [100, 1.6, -100], 0, 0);
    expect(world.player.position).toEqual([4.5, 1.6, -4.5]);
  });

  test("let the visitor of the original through", () => {
    const world = createWorld("original", 1);
    advance(world, { ...STILL, forward: 1 }, 10);
    expect(gapToWalls(world)).toBeLessThan(-1);
    moveCamera(world, [0, 1.6, 40], 0, 0);
    expect(world.player.position[2]).toBe(40);
  });
});
