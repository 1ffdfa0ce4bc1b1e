import { describe, expect, test, vi } from "vitest";
import { sampleOf } from "../../../src/light/candle-light.ts";
import { SETTINGS } from "../../../src/settings.ts";
import { advance } from "../../../src/world/advance.ts";
import { createPlume } from "../../../src/world/air/plume.ts";
import { moveCamera } from "../../../src/world/commands.ts";
import { GROUPS } from "../../../src/world/particles/particle-layer.ts";
import { PARTICLE_FLOATS } from "../../../src/world/particles/particles.ts";
import { type Intent, STILL } from "../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import { TICK } from "../../../src/world/timeline.ts";
import { currentTime, type World } from "../../../src/world/world.ts";
import { temperatureAt } from "../../support/plume.ts";
import { createWorld } from "../../support/world.ts";
import { chance } from "../chance.ts";
import { FURNISHED } from "./rooms.ts";

const LOOKS = SETTINGS.look.choices;
const WALKING: Intent = { ...STILL, forward: 1, right: 0.3, turn: 0.4, runs: true };

function advanced(world: World, seconds: number, times: number, intent = STILL): World {
  for (let i = 0; i < times; i++) advance(world, intent, seconds);
  return world;
}

const furnished = () => createRoom(new CollisionMesh(FURNISHED.parts), null);

/** Everything of a world that is drawn. */
function shownOf({ player, candle, emitter, interpolated, timeline, sample, remainder }: World) {
  return {
    player,
    candle,
    emitter,
    interpolated,
    tick: timeline.tick,
    particles: sample?.state,
    remainder,
  };
}

describe("time (P7)", () => {
  test.each(LOOKS)("is the same world at 30, 60 and 144 Hz, standing or walking: %s", (look) => {
    for (const intent of [STILL, WALKING]) {
      const worlds = [30, 60, 144].map((rate) =>
        shownOf(advanced(createWorld(look, 5), 1 / rate, rate, intent)),
      );
      expect(worlds[0]?.tick).toBe(120);
      expect(worlds[0]?.remainder).toBe(0);
      expect(worlds[1]).toEqual(worlds[0]);
      expect(worlds[2]).toEqual(worlds[0]);
    }
  });

  test("is the same world through frames of any length", () => {
    const between = chance(3);
    const world = createWorld("paper", 5);
    let left = 1;
    while (left > 0.06) {
      const seconds = between(0, 0.05);
      advance(world, WALKING, seconds);
      left -= seconds;
    }
    advance(world, WALKING, left);
    const whole = advanced(createWorld("paper", 5), 1, 1, WALKING);
    expect(world.timeline.tick).toBe(120);
    expect(world.player).toEqual(whole.player);
    expect(sampleOf(world).state).toEqual(sampleOf(whole).state);
  });

  test.each([
    ["a tick", TICK],
    ["a little less than a tick", TICK * 0.9995],
    ["a little more than a tick", TICK * 1.0005],
    ["far less than a tick", 1e-4],
    ["far less than the error of a sum", 1e-9],
    ["a frame at 144 Hz", 1 / 144],
    ["a frame at 60 Hz", 1 / 60],
    ["no round number", 0.0314159],
  ])("sums what it was given, in steps of %s", (_, seconds) => {
    const world = createWorld("paper", 1);
    expect(currentTime(world)).toBe(0);
    for (let i = 1; i <= 2000; i++) {
      advance(world, STILL, seconds);
      expect(Math.abs(currentTime(world) - i * seconds)).toBeLessThan(1e-6);
    }
  });

  test("does not pass in a step of nothing", () => {
    const world = advanced(createWorld("paper", 1), 1 / 60, 10, WALKING);
    const before = structuredClone(shownOf(world));
    advance(world, STILL, 0);
    expect(shownOf(world)).toEqual(before);
  });

  test("a turn of the head moves the flame as far at 240 Hz as at 60, and a jump after it does not", () => {
    const wayOf = ({ timeline }: World, tick: number) =>
      Math.hypot(timeline.way(tick, 0), timeline.way(tick, 2));
    const ways = [60, 240].map((rate) => {
      const world = createWorld("physical", 1);
      const turning = { ...STILL, yaw: 1 / rate };
      advanced(world, 1 / rate, rate, turning);
      const ticks = Array.from({ length: world.timeline.tick }, (_, tick) => wayOf(world, tick));
      advance(world, turning, TICK / 2);
      moveCamera(world, [1, 1.6, 0], 0, 0);
      advance(world, STILL, TICK / 2);
      expect(wayOf(world, 120)).toBe(0);
      return ticks.reduce((sum, way) => sum + way);
    });
    expect(ways[0]).toBeGreaterThan(0.1);
    expect(ways[1]! / ways[0]!).toBeCloseTo(1, 2);
  });

  test("a turn of the head is seen in its own frame, and felt in as many ticks as it took", () => {
    const world = createWorld("physical", 1, { room: furnished() });
    const { player, hand } = world;
    const { yaw } = player;
    const turning = { ...STILL, yaw: 0.012, pitch: 0.004 };
    advance(world, turning, TICK / 4); // no tick
    expect(player.yaw - yaw).toBeCloseTo(0.012, 12);
    expect(hand.yaw).toBe(yaw);
    const felt: number[] = [];
    const spy = vi.spyOn(world.flame, "advance").mockImplementation(() => felt.push(hand.yaw));
    advance(world, turning, 3 * TICK);
    spy.mockRestore();
    expect(player.yaw - yaw).toBeCloseTo(0.024, 12);
    expect(player.pitch - world.setup.pitch).toBeCloseTo(0.008, 12);
    // The first tick has the frame before, and three quarters of a tick of this one.
    [0.015, 0.019, 0.023].forEach((turned, i) => {
      expect((felt[i] ?? Number.NaN) - yaw).toBeCloseTo(turned, 12);
    });
    advance(world, STILL, TICK);
    expect(hand.yaw).toBe(player.yaw);
  });

  test("a brisk turn of the head costs the flame as much at any frame rate", () => {
    const leasts = [10, 20, 30, 60, 120, 144, 240].map((rate) => {
      const world = createWorld("physical", 1, { room: furnished() });
      let least = 1;
      for (let frame = 0; frame < 1.5 * rate; frame++) {
        const yaw = frame < 0.5 * rate ? (2 * Math.PI) / rate : 0; // half a turn in half a second
        advance(world, { ...STILL, yaw }, 1 / rate);
        least = Math.min(least, world.flame.fuel);
      }
      return least;
    });
    expect(leasts[0]).toBeGreaterThan(0.5);
    expect(Math.max(...leasts) - Math.min(...leasts)).toBeLessThan(0.05);
  });

  test("shows a walker between the ticks where he will be", () => {
    const world = advanced(createWorld("paper", 1), 1, 1, { ...STILL, forward: 1 });
    const { position, velocity } = world.player;
    advance(world, { ...STILL, forward: 1 }, TICK / 2);
    expect(world.remainder).toBeCloseTo(TICK / 2, 9);
    for (const axis of [0, 1, 2] as const) {
      const ahead = velocity[axis] * (TICK / 2);
      expect(world.interpolated.eye[axis] - position[axis]).toBeCloseTo(ahead, 9);
      expect(world.interpolated.flame[axis] - world.emitter[axis]).toBeCloseTo(ahead, 9);
      expect(world.interpolated.foot[axis] - world.candle.position[axis]).toBeCloseTo(ahead, 9);
    }
    expect(Math.hypot(...velocity)).toBeGreaterThan(1);
  });

  test("leads a walker nowhere between the ticks that is not free", () => {
    const room = createRoom(new CollisionMesh(FURNISHED.parts), null);
    const { plan } = room;
    let searches = 0;
    vi.spyOn(plan, "settle").mockImplementation(([x, , z]) => {
      if (!plan.isFree(x, z)) searches++;
    });
    const world = createWorld("physical", 1, { room });
    for (let i = 0; i < 4; i++) advanced(world, 1 / 144, 144, { ...WALKING, turn: 0.4 * (i % 2) });
    expect(searches).toBe(0);
  });
});

describe("birth", () => {
  test.each(["paper", "original"] as const)("is of a flame already whole: %s", (look) => {
    const world = createWorld(look, 1);
    const living = sampleOf(world).state.filter(
      (value, i) => i % PARTICLE_FLOATS === 3 && value > 0,
    ).length;
    const layer = world.setup.layers.at(-1)!;
    expect(Math.abs(living - (layer.rate * layer.life) / GROUPS)).toBeLessThanOrEqual(1);
  });

  test("is of a flame already whole, under hot air: physical", () => {
    const { flame, plume, emitter } = createWorld("physical", 1, { createPlume });
    expect(flame.height).toBeGreaterThan(0.03);
    const [x, y, z] = emitter;
    expect(plume && temperatureAt(plume.solver, [x, y + 0.2, z])).toBeGreaterThan(320);
  });

  test.each(LOOKS)("at an age gives the world that has grown that old: %s", (look) => {
    const grown = shownOf(advanced(createWorld(look, 9), 10, 1));
    expect(grown.tick).toBe(1200);
    expect(shownOf(createWorld(look, 9, { age: 1200 }))).toEqual(grown);
  });

  test("of the same seed is of the same flame, of another seed of another", () => {
    const flame = (seed: number) => sampleOf(advanced(createWorld("paper", seed), 0.5, 1)).state;
    expect(flame(3)).toEqual(flame(3));
    expect(flame(3)).not.toEqual(flame(4));
  });
});
