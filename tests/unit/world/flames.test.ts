import { describe, expect, test } from "vitest";
import { advance } from "../../../src/world/advance.ts";
import { blow, blowAt, moveCamera, standCandle } from "../../../src/world/commands.ts";
import type { WorldOptions } from "../../../src/world/create-world.ts";
import { litFlames, wickAtFlame } from "../../../src/world/flames.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { pcg, unit } from "../../../src/world/random.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import type { World } from "../../../src/world/world.ts";
import { LONE_CANDLE_SETUP } from "../../../src/world/world-setup.ts";
import { createWorld } from "../../support/world.ts";
import { box, floorOf, modelRoom } from "./rooms.ts";

const room = () =>
  createRoom(new CollisionMesh([floorOf(8), box([-0.5, 0, -2], [0.5, 1, -1.2])]), null);
const E = { ...STILL, togglesFlame: true };

/** A room with a block 1 m high, and candles whose wicks are there. */
function worldWith(wicks: readonly Vec3[], birth: WorldOptions = {}): World {
  const ofPlaces = wicks.map((position, i) => ({
    name: `wick.${i}`,
    position,
    wickDiameter: 0.002,
  }));
  return createWorld("physical", 1, { room: room(), wicks: ofPlaces, ...birth });
}

/** Places the eye so that the carried flame's root is at a place. */
function carryTo(world: World, [x, y, z]: Vec3): void {
  moveCamera(world, [0, 1.6, 2], 0, 0);
  const { position } = world.player;
  const [fx, fy, fz] = world.emitter;
  moveCamera(world, [position[0] + x - fx, position[1] + y - fy, position[2] + z - fz], 0, 0);
  for (const [axis, value] of world.emitter.entries()) {
    expect(value).toBeCloseTo([x, y, z][axis] ?? 0, 6);
  }
}

describe("E", () => {
  const wick: Vec3 = [0, 1.4, 1];

  test.each([
    ["lights the wick", "at the flame", 0.09],
    ["puts out the carried candle", "beyond 10 cm", 0.13],
  ])("%s %s", (_, __, distance) => {
    const world = worldWith([wick, [2, 1, 2]]);
    carryTo(world, [wick[0] + distance, wick[1], wick[2]]);
    advance(world, E, 0);
    expect(litFlames(world)).toEqual(distance < 0.1 ? [true, true, false] : [false, false, false]);
  });

  test("lights one wick after another, the nearest first, and then is for the carried flame", () => {
    const world = worldWith([wick, [wick[0] + 0.04, wick[1], wick[2]]]);
    carryTo(world, [wick[0] + 0.05, wick[1], wick[2]]);
    const seen = [1, 2, 3].map(() => {
      advance(world, E, 0);
      return litFlames(world);
    });
    expect(seen).toEqual([
      [true, false, true],
      [true, true, true],
      [false, true, true],
    ]);
  });

  test("reaches a wick along the whole flame", () => {
    const world = worldWith([wick]);
    carryTo(world, [wick[0], wick[1] - 0.12, wick[2]]);
    advance(world, E, 0);
    expect(litFlames(world)).toEqual([true, true]);
  });

  test("lights the carried wick at a burning one", () => {
    const world = worldWith([wick], { isLit: false, areLit: [true] });
    carryTo(world, [wick[0] + 0.05, wick[1], wick[2]]);
    advance(world, E, 0);
    expect(litFlames(world)).toEqual([true, true]);
  });
});

describe("the hand", () => {
  // On the block, as candles of 17, 12 and 6 cm would have them.
  test.each([1.17, 1.12, 1.06])("reaches out to a wick at %s m, so that E lights it", (height) => {
    const wick: Vec3 = [0.2, height, -1.3];
    const world = worldWith([wick]);
    moveCamera(world, [0, 1.6, -0.65], 0, 0);
    const before = [...world.emitter];
    expect(Math.abs((before[1] ?? 0) - wick[1])).toBeGreaterThan(0.2);
    advance(world, STILL, 1.5);
    const [x, , z] = world.emitter;
    expect(Math.hypot(x - wick[0], z - wick[2])).toBeLessThan(0.1);
    advance(world, E, 0);
    expect(litFlames(world)).toEqual([true, true]);
    advance(world, STILL, 2);
    for (const [axis, x] of world.emitter.entries()) expect(x).toBeCloseTo(before[axis] ?? 0, 2);
  });

  test("stays as it is where there is none", () => {
    const [alone, among] = [worldWith([]), worldWith([[3, 1, 3]])];
    for (const world of [alone, among]) advance(world, { ...STILL, forward: 1, turn: 0.2 }, 1);
    expect(among.emitter).toEqual(alone.emitter);
  });
});

describe("in the cabin", () => {
  const cabin = modelRoom("cabin.glb");
  if (!cabin) throw new Error("There is no cabin.");
  const room = createRoom(new CollisionMesh(cabin.parts), null);
  const wicks = cabin.wicks.map((wick) => ({ ...wick, wickDiameter: 0.002 }));
  const world = createWorld("physical", 1, { room, wicks });
  /** Of the flame held out ahead: its bearing to the right, and its distance. */
  const [bearing, distance] = [Math.atan2(0.24, 0.56), Math.hypot(0.24, 0.56)];

  test.each(wicks)("the candle $name can be lit by hand", ({ name, position: [x, , z] }) => {
    const directions = Array.from({ length: 16 }, (_, i) => (2 * Math.PI * i) / 16);
    const isReached = directions.some((direction) => {
      const eye: Vec3 = [
        x + distance * Math.sin(direction),
        1.6,
        z + distance * Math.cos(direction),
      ];
      moveCamera(world, eye, direction + bearing, 0);
      advance(world, STILL, 1.5);
      const candle = wickAtFlame(world);
      return candle > 0 && wicks[candle - 1]?.name === name;
    });
    expect(isReached).toBe(true);
  });

  test("the hand comes to rest wherever one stands, near wicks and walls too", () => {
    for (let i = 0; i < 150; i++) {
      const [x, z, yaw] = [0, 1, 2].map((k) => unit(pcg(3 * i + k)));
      moveCamera(world, [4 * x! - 2, 1.6, 3 * z! - 1.5], 2 * Math.PI * yaw!, 0);
      advance(world, STILL, 2.5);
      const before = [...world.emitter];
      advance(world, STILL, 0.1);
      const way = Math.hypot(...world.emitter.map((value, axis) => value - before[axis]!));
      expect(way, `at ${world.player.position}, ${world.player.yaw}`).toBeLessThan(1e-4);
    }
  });
});

describe("a breath", () => {
  test("is for the flame nearest to the line of sight, and blows out those beside it", () => {
    const world = worldWith(
      [
        [0, 1.6, 0.8],
        [0.03, 1.6, 0.8],
        [0.8, 1.6, 0.8],
      ],
      { areLit: [true, true, true] },
    );
    moveCamera(world, [0, 1.62, 1.5], 0, 0);
    blow(world, 2);
    advance(world, STILL, 1.5);
    expect(litFlames(world)).toEqual([true, false, false, true]);
  });

  /** A world without and with a wall at 0.3 m, seen from a gaze at 1.5 m along -Z. */
  const beforeWall = (...wicks: readonly Vec3[]) =>
    [[], [box([-1, 0, 0.3], [1, 3, 0.35])]].map((walls) => {
      const room = createRoom(new CollisionMesh([floorOf(8), ...walls]), null);
      const world = worldWith(wicks, { room, isLit: false, areLit: wicks.map(() => true) });
      moveCamera(world, [0, 1.6, 1.5], 0, 0);
      return world;
    });

  test("is not for a flame behind a wall", () => {
    const lit = beforeWall([0, 1.6, 0.1], [-0.3, 1.6, 0.8]).map((world) => {
      blow(world, 3);
      advance(world, STILL, 1.5);
      return litFlames(world);
    });
    expect(lit).toEqual([
      [false, false, true],
      [false, true, false],
    ]);
  });

  test("is for the carried candle that stands there, unless it stands behind a wall", () => {
    const lit = beforeWall().map((world) => {
      standCandle(world, [0, 1.4, 0.1], 0);
      world.flame.light();
      advance(world, STILL, 2);
      blow(world, 3);
      advance(world, STILL, 1.5);
      return litFlames(world);
    });
    expect(lit).toEqual([[false], [true]]);
  });

  test("along the gaze ends at a wall", () => {
    const felt = beforeWall([3, 1, 3]).map((world) => {
      blow(world, 1);
      advance(world, STILL, 0.8);
      return Math.abs(world.air.velocity([0, 1.6, -0.3], [0, 0, 0])[2]);
    });
    expect(felt[0]).toBeGreaterThan(0.5);
    expect(felt[1]).toBeLessThan(0.05);
  });

  test("at one candle ends at the wall behind it", () => {
    const lit = beforeWall([0, 1.6, 0.5], [0, 1.6, 0.1]).map((world) => {
      blowAt(world, 1, 3);
      advance(world, STILL, 1.5);
      return litFlames(world);
    });
    expect(lit).toEqual([
      [false, false, false],
      [false, false, true],
    ]);
  });

  test("at one candle is for that one; several at a time blow out all of them", () => {
    const wicks: Vec3[] = [0, 1, 2].map((i) => [i - 1, 1.2, 0]);
    const world = worldWith(wicks, { areLit: [true, true, true] });
    moveCamera(world, [0, 1.6, 3], 0, 0);
    blowAt(world, 2, 1);
    advance(world, STILL, 1.5);
    expect(litFlames(world)).toEqual([true, true, false, true]);
    for (const index of [0, 1, 3]) blowAt(world, index, 1);
    advance(world, STILL, 1.5);
    expect(litFlames(world)).toEqual([false, false, false, false]);
    blowAt(world, 9, 1);
  });
});

test.each([1, 4, 16])(
  "a breath at %i candles alone blows out all, and a faint one none",
  (count) => {
    const wicks = Array.from({ length: count - 1 }, (_, i) => {
      const angle = (2 * Math.PI * (i + 1)) / count;
      const position: Vec3 = [0.08 * Math.cos(angle) - 0.08, 0.2, 0.08 * Math.sin(angle)];
      return { name: `wick.${i}`, position, wickDiameter: 0.002 };
    });
    for (const [strength, isLit] of [
      [1, false],
      [0.05, true],
    ] as const) {
      const areLit = wicks.map(() => true);
      const world = createWorld("physical", 1, { setup: LONE_CANDLE_SETUP, wicks, areLit });
      blow(world, strength);
      advance(world, STILL, 1.5);
      expect(litFlames(world)).toEqual(Array.from({ length: count }, () => isLit));
    }
  },
);

test("around candles alone nobody walks or turns, whom no frame shows; their flames are in reach", () => {
  const world = createWorld("physical", 1, { setup: LONE_CANDLE_SETUP });
  const before = structuredClone(world.player);
  advance(world, { ...E, forward: 1, turn: 1, yaw: 0.3, pitch: 0.1 }, 1);
  expect(world.player).toEqual(before);
  expect(litFlames(world)).toEqual([false]);
});
