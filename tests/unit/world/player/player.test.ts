import { describe, expect, test } from "vitest";
import { type Bounds, inset } from "../../../../src/world/geometry.ts";
import { type Intent, STILL } from "../../../../src/world/player/intent.ts";
import { MAX_PITCH, type Player, turnHead, walk } from "../../../../src/world/player/player.ts";
import { boxBounds, UNBOUNDED } from "../../../../src/world/room/movement-bounds.ts";
import { WALL_MARGIN, WORLD_SETUPS } from "../../../../src/world/world-setup.ts";
import { chance } from "../../chance.ts";

const { gait, room } = WORLD_SETUPS.paper;
const WALLS = inset(room, WALL_MARGIN);
const BOX = boxBounds(WALLS);

function standing(yaw = 0): Player {
  return { position: [0, 1.6, 0], velocity: [0, 0, 0], yaw, pitch: 0 };
}
const intent = (part: Partial<Intent>): Intent => ({ ...STILL, ...part });
const speedOf = ({ velocity }: Player) => Math.hypot(...velocity);

/** Distance to the nearest face of a box; negative outside. */
function gap({ position: [x, y, z] }: Player, { min, max }: Bounds): number {
  return Math.min(x - min[0], max[0] - x, y - min[1], max[1] - y, z - min[2], max[2] - z);
}

describe("walking (I1)", () => {
  test.each([
    ["starts", [0, 0, 0], intent({ forward: 1 })],
    ["turns on his heel at a run", [0, 0, 4], intent({ forward: 1, right: -0.5, runs: true })],
    ["stops", [1, 0, -2], STILL],
  ] as const)("ends in the same place in one step as in many: he %s", (_, velocity, wish) => {
    const once: Player = { ...standing(0.7), velocity: [...velocity] };
    const often: Player = { ...standing(0.7), velocity: [...velocity] };
    walk(once, wish, gait, UNBOUNDED, 0.5);
    for (let i = 0; i < 60; i++) walk(often, wish, gait, UNBOUNDED, 1 / 120);
    for (const axis of [0, 1, 2] as const) {
      expect(Math.abs(once.position[axis] - often.position[axis])).toBeLessThan(1e-9);
      expect(Math.abs(once.velocity[axis] - often.velocity[axis])).toBeLessThan(1e-9);
    }
  });

  test.each([
    ["2 m/s", false, 2],
    ["4 m/s at a run", true, 4],
  ])("reaches %s, no more, within half a second", (_, runs, speed) => {
    const player = standing();
    for (let i = 0; i < 60; i++) {
      walk(player, intent({ forward: 1, runs }), gait, UNBOUNDED, 1 / 120);
      expect(speedOf(player)).toBeLessThanOrEqual(speed);
    }
    expect(speedOf(player)).toBeGreaterThan(0.99 * speed);
    expect(speedOf(player)).toBeLessThanOrEqual(speed);
  });

  test("is no faster across the diagonal", () => {
    const player = standing();
    walk(player, intent({ forward: 1, right: 1 }), gait, UNBOUNDED, 5);
    expect(speedOf(player)).toBeCloseTo(2, 9);
  });

  test("obeys a stick pushed half-way by half the speed", () => {
    const player = standing();
    walk(player, intent({ forward: 0.5 }), gait, UNBOUNDED, 5);
    expect(speedOf(player)).toBeCloseTo(1, 9);
  });

  test("ends when the keys are let go", () => {
    const player: Player = { ...standing(), velocity: [2, 0, 0] };
    walk(player, STILL, gait, UNBOUNDED, 2);
    expect(speedOf(player)).toBeLessThan(1e-9);
    expect(player.position[0]).toBeLessThan(0.25);
  });

  test("looks up by key at the same pace in one step as in many, and no higher than the pointer", () => {
    const once = standing();
    const often = standing();
    walk(once, intent({ tilt: 0.5 }), gait, UNBOUNDED, 1);
    for (let i = 0; i < 120; i++) walk(often, intent({ tilt: 0.5 }), gait, UNBOUNDED, 1 / 120);
    expect(once.pitch).toBeCloseTo(0.5, 9);
    expect(often.pitch).toBeCloseTo(once.pitch, 9);
    walk(once, intent({ tilt: -1 }), gait, UNBOUNDED, 9);
    expect(once.pitch).toBe(-MAX_PITCH);
  });

  test("never leaves the floor", () => {
    const player: Player = { ...standing(), pitch: MAX_PITCH };
    walk(player, intent({ forward: 1 }), gait, UNBOUNDED, 1);
    expect(player.position[1]).toBe(1.6);
  });

  // Yaw 0 looks along -Z; counter-clockwise from above is positive.
  test.each([
    ["ahead at yaw 0 is -Z", 0, { forward: 1 }, [0, -1]],
    ["ahead a quarter turn to the left is -X", Math.PI / 2, { forward: 1 }, [-1, 0]],
    ["ahead a quarter turn to the right is +X", -Math.PI / 2, { forward: 1 }, [1, 0]],
    ["back at yaw 0 is +Z", 0, { forward: -1 }, [0, 1]],
    ["right at yaw 0 is +X", 0, { right: 1 }, [1, 0]],
    ["right a quarter turn to the left is -Z", Math.PI / 2, { right: 1 }, [0, -1]],
  ])("%s", (_, yaw, wish, [x, z]) => {
    const player = standing(yaw);
    walk(player, intent(wish), gait, UNBOUNDED, 100);
    const length = Math.hypot(...player.position.filter((_, axis) => axis !== 1));
    expect(player.position[0] / length).toBeCloseTo(x!, 9);
    expect(player.position[2] / length).toBeCloseTo(z!, 9);
  });
});

describe("looking", () => {
  test("turns left for positive yaw and up for positive pitch", () => {
    const player = standing();
    turnHead(player, intent({ yaw: 0.3, pitch: 0.2 }));
    expect(player.yaw).toBeCloseTo(0.3, 12);
    expect(player.pitch).toBeCloseTo(0.2, 12);
  });

  test("never goes beyond straight up or down", () => {
    const player = standing();
    turnHead(player, intent({ pitch: 100 }));
    expect(player.pitch).toBe(MAX_PITCH);
    turnHead(player, intent({ pitch: -1000 }));
    expect(player.pitch).toBe(-MAX_PITCH);
    expect(MAX_PITCH).toBeLessThan(Math.PI / 2);
  });

  test("keeps the yaw within half a turn of 0, however often one turns", () => {
    const player = standing();
    for (let i = 0; i < 1000; i++) {
      turnHead(player, intent({ yaw: 0.1 }));
      expect(Math.abs(player.yaw)).toBeLessThanOrEqual(Math.PI + 1e-9);
    }
    expect(Math.cos(player.yaw)).toBeCloseTo(Math.cos(100), 9);
    expect(Math.sin(player.yaw)).toBeCloseTo(Math.sin(100), 9);
  });

  test("by keys is as fast at any frame rate", () => {
    const yaws = [30, 60, 144].map((rate) => {
      const player = standing();
      for (let i = 0; i < rate; i++) walk(player, intent({ turn: 1 }), gait, UNBOUNDED, 1 / rate);
      return player.yaw;
    });
    expect(yaws[0]).toBeGreaterThan(1);
    for (const yaw of yaws) expect(yaw).toBeCloseTo(yaws[0]!, 9);
  });

  test("by keys goes left for a positive turn, right for a negative", () => {
    const player = standing();
    walk(player, intent({ turn: -1 }), gait, UNBOUNDED, 0.1);
    expect(player.yaw).toBeLessThan(0);
  });
});

describe("collision (I2)", () => {
  test("ten thousand random walks come no nearer to a wall than 0.5 m", () => {
    const between = chance(2024);
    let nearest = Number.POSITIVE_INFINITY;
    let touched = 0;
    for (let i = 0; i < 10_000; i++) {
      const player = standing(between(-Math.PI, Math.PI));
      player.position[0] = between(-4.5, 4.5);
      player.position[2] = between(-4.5, 4.5);
      // Every fourth one through frames far longer than the loop would ever ask for.
      const longest = i % 4 === 0 ? 10 : 1 / 20;
      for (let step = 0; step < 25; step++) {
        const wish = intent({
          forward: between(-1, 1),
          right: between(-1, 1),
          turn: between(-1, 1),
          runs: between(0, 1) < 0.5,
        });
        walk(player, wish, gait, BOX, between(0, longest));
        nearest = Math.min(nearest, gap(player, room));
        if (gap(player, WALLS) === 0) touched++;
      }
    }
    expect(nearest).toBe(WALL_MARGIN);
    expect(touched).toBeGreaterThan(1000);
  });

  test("a wall stops what leads into it and lets the rest slide by", () => {
    const player = standing(0);
    player.position[2] = -4;
    const wish = intent({ forward: 1, right: 1 });
    for (let i = 0; i < 120; i++) walk(player, wish, gait, BOX, 1 / 120);
    expect(player.position[2]).toBe(-4.5);
    expect(player.velocity[2]).toBe(0);
    expect(player.velocity[0]).toBeCloseTo(Math.SQRT2, 3);
    expect(player.position[0]).toBeGreaterThan(1);
  });

  test("who turns away from a wall leaves it at once", () => {
    const player = standing(0);
    walk(player, intent({ forward: 1, runs: true }), gait, BOX, 60);
    walk(player, intent({ forward: -1 }), gait, BOX, 0.1);
    expect(player.position[2]).toBeGreaterThan(-4.5);
  });

  test("without walls, as in the original, he walks out", () => {
    const player = standing(0);
    walk(player, intent({ forward: 1 }), gait, UNBOUNDED, 10);
    expect(player.position[2]).toBeLessThan(room.min[2]);
  });
});
