import { describe, expect, test } from "vitest";
import { sampleOf } from "../../../src/light/candle-light.ts";
import { SETTINGS } from "../../../src/settings.ts";
import { advance } from "../../../src/world/advance.ts";
import { moveCamera, placeCandle, standLike, takeCandle } from "../../../src/world/commands.ts";
import { emittingGroups } from "../../../src/world/particles/level-of-detail.ts";
import { GROUPS } from "../../../src/world/particles/particle-layer.ts";
import { type Intent, STILL } from "../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import { TICK } from "../../../src/world/timeline.ts";
import { WORLD_SETUPS } from "../../../src/world/world-setup.ts";
import { createWorld } from "../../support/world.ts";
import { box, floorOf } from "./rooms.ts";

const LOOKS = SETTINGS.look.choices;
const WALKING: Intent = { ...STILL, forward: 1, right: 0.3, turn: 0.4, runs: true };

describe("the flame (L1)", () => {
  test("stands on the wick, a little above its foot", () => {
    const world = createWorld("paper", 1);
    const { emitter, candle, setup } = world;
    for (const axis of [0, 1, 2] as const) {
      const wick = setup.wick[axis] * setup.candleScale;
      expect(emitter[axis] - candle.position[axis]).toBeCloseTo(wick, 9);
    }
    expect(emitter[1]).toBeGreaterThan(candle.position[1] + setup.candleScale);
    const [x, y, z] = sampleOf(world).centre([0, 0, 0]);
    expect(Math.hypot(x, z)).toBeLessThan(0.05);
    expect(y).toBeGreaterThan(0.1);
    expect(y).toBeLessThan(0.6);
  });

  test("leans back when carried, and is upright again when it stands", () => {
    const world = createWorld("paper", 1);
    moveCamera(world, [0, 1.6, 4], 0, 0);
    const lean = () => sampleOf(world).centre([0, 0, 0])[2];
    advance(world, { ...STILL, forward: 1, runs: true }, 1.2);
    expect(lean()).toBeGreaterThan(0.1); // he walks along -Z
    advance(world, STILL, 3);
    expect(Math.abs(lean())).toBeLessThan(0.03);
  });

  test("is not torn off when the visitor is put elsewhere", () => {
    const world = createWorld("paper", 1);
    const still = createWorld("paper", 1);
    moveCamera(world, [-3, 1.6, -3], 2, 0);
    advance(world, STILL, 0.5);
    advance(still, STILL, 0.5);
    expect(sampleOf(world).state).toEqual(sampleOf(still).state);
  });
});

describe("placing and taking", () => {
  test("leaves the candle where it was put while the visitor walks on", () => {
    const world = createWorld("paper", 1);
    expect(placeCandle(world)).toBe(true);
    const foot = [...world.candle.position];
    const { flame } = structuredClone(world.interpolated);
    advance(world, { ...STILL, forward: -1 }, 0.5 + TICK / 2);
    expect(world.remainder).toBeGreaterThan(TICK / 4);
    expect(world.interpolated.flame).toEqual(flame);
    expect(world.candle.position).toEqual(foot);
    expect(world.interpolated.foot).toEqual(foot);
    expect(foot[1]).toBe(WORLD_SETUPS.paper.room.min[1]);
  });

  test("only puts down what is held, and only takes up what is near", () => {
    const world = createWorld("paper", 1);
    expect(takeCandle(world)).toBe(false);
    expect(placeCandle(world)).toBe(true);
    expect(placeCandle(world)).toBe(false);
    moveCamera(world, [-4, 1.6, -4], 0, 0);
    expect(takeCandle(world)).toBe(false);
    const [x, , z] = world.candle.position;
    moveCamera(world, [x, 1.6, z + 0.5], 0, 0);
    expect(takeCandle(world)).toBe(true);
    expect(world.candle.isHeld).toBe(true);
    expect(world.candle.position[1]).toBeCloseTo(1.2, 9);
  });

  test("while walking does not make the hand lurch", () => {
    const world = createWorld("paper", 1);
    placeCandle(world);
    const [x, , z] = world.candle.position;
    moveCamera(world, [x, 1.6, z + 1], 0, 0);
    advance(world, { ...STILL, forward: 1 }, 0.4);
    expect(Math.hypot(...world.player.velocity)).toBeGreaterThan(0.3);
    expect(takeCandle(world)).toBe(true);
    advance(world, { ...STILL, forward: 1 }, 0.05);
    expect(Math.hypot(...world.hand.sway)).toBeLessThan(0.005);
  });

  test("happens once for each wish, in turns", () => {
    const world = createWorld("paper", 1);
    const wish = { ...STILL, placesOrTakes: true };
    const held = [1, 2, 3].map(() => {
      advance(world, wish, 1 / 30);
      return world.candle.isHeld;
    });
    expect(held).toEqual([false, true, false]);
  });

  test("is done from where one stands after the frame: a link gives that place", () => {
    const world = createWorld("paper", 1);
    advance(world, WALKING, 0.5);
    advance(world, { ...WALKING, placesOrTakes: true }, 1 / 20);
    const { position, yaw, pitch } = world.player;
    const other = createWorld("paper", 1);
    moveCamera(other, position, yaw, pitch);
    expect(placeCandle(other)).toBe(true);
    for (const axis of [0, 1, 2] as const) {
      expect(other.candle.position[axis]).toBeCloseTo(world.candle.position[axis], 9);
    }
  });

  test("does not tear the flame off its wick", () => {
    const world = createWorld("paper", 1);
    const still = createWorld("paper", 1);
    placeCandle(world);
    advance(world, STILL, 0.5);
    advance(still, STILL, 0.5);
    expect(sampleOf(world).state).toEqual(sampleOf(still).state);
  });

  test("is no part of the original, whose candle stands", () => {
    const world = createWorld("original", 1);
    const foot = [...world.candle.position];
    expect(world.candle.isHeld).toBe(false);
    expect(placeCandle(world)).toBe(false);
    expect(takeCandle(world)).toBe(false);
    moveCamera(world, [0, 1.6, 0.5], 0, 0);
    expect(takeCandle(world)).toBe(false);
    advance(world, WALKING, 1);
    expect(world.candle.position).toEqual(foot);
  });
});

describe("level of detail (F4)", () => {
  test.each(LOOKS)("falls with distance, group by group, and never below one: %s", (look) => {
    const world = createWorld(look, 1);
    placeCandle(world);
    const [x, y, z] = world.emitter;
    const levels: number[] = [];
    for (let distance = 0.3; distance < 300; distance += 0.1) {
      world.player.position.splice(0, 3, x + distance, y, z);
      levels.push(emittingGroups(world));
    }
    expect(levels).toEqual(levels.toSorted((a, b) => b - a));
    expect([...new Set(levels)]).toEqual([4, 3, 2, 1]);
  });

  test("is full in the hand", () => {
    expect(emittingGroups(createWorld("paper", 1))).toBe(GROUPS);
  });

  test("is what the timeline remembers", () => {
    const world = createWorld("paper", 1);
    moveCamera(world, [4, 1.6, 4], -Math.PI / 4, 0);
    placeCandle(world);
    moveCamera(world, [-4, 1.6, -4], 0, 0);
    advance(world, STILL, 0.5);
    expect(world.timeline.groups(world.timeline.tick - 1)).toBe(1);
  });

  test("keeps the sample's group, so that the light stays", () => {
    const world = createWorld("paper", 1);
    placeCandle(world);
    world.player.position.splice(0, 3, -4.5, 1.6, -4.5);
    advance(world, STILL, 3);
    expect(sampleOf(world).centre([0, 0, 0])[1]).toBeGreaterThan(0.1);
  });
});

describe("a world that takes over another's candle", () => {
  const standing = () => {
    const other = createWorld("paper", 1);
    moveCamera(other, [1, 1.6, -2], 0.5, 0);
    placeCandle(other);
    moveCamera(other, [-2, 1.6, 2], 0, 0);
    return other;
  };

  test("has it stand on the same spot, with its flame", () => {
    const other = standing();
    const world = createWorld("paper", 1);
    standLike(world, other);
    expect(world.candle).toEqual(other.candle);
    expect(world.emitter).toEqual(other.emitter);
  });

  test("has it stand on the same spot of the same room, wherever the visitor looks; in another, ahead", () => {
    const inRoom = (size: number) => {
      const collision = new CollisionMesh([floorOf(size), box([-0.5, 0, -1.4], [0.5, 0.8, -0.7])]);
      return createWorld("physical", 1, { room: createRoom(collision, null) });
    };
    const other = inRoom(8);
    moveCamera(other, [0, 1.6, 0], 0, -0.6);
    expect(placeCandle(other)).toBe(true);
    expect(other.candle.position[1], "on the box").toBeCloseTo(0.8, 3);
    moveCamera(other, [2, 1.6, 2], 2, -0.6);
    const [same, larger] = [inRoom(8), inRoom(9)];
    for (const world of [same, larger]) {
      moveCamera(world, [2, 1.6, 2], 2, -0.6);
      standLike(world, other);
    }
    expect(same.candle.position).toEqual(other.candle.position);
    expect(larger.candle.isHeld).toBe(false);
    expect(larger.candle.position[1], "on the floor").toBeCloseTo(0, 3);
  });

  test("keeps the original's, which nobody moves, and one that is carried", () => {
    const original = createWorld("original", 1);
    const { position } = createWorld("original", 1).candle;
    standLike(original, standing());
    expect(original.candle.position).toEqual(position);
    const carried = createWorld("paper", 1);
    standLike(carried, createWorld("paper", 1));
    expect(carried.candle.isHeld).toBe(true);
  });
});
