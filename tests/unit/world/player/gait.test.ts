import { describe, expect, test } from "vitest";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import {
  accelerate,
  advanceStride,
  EYE_HEIGHT,
  headBob,
  RUN,
  WALK,
} from "../../../../src/world/player/gait.ts";
import {
  advanceHand,
  calmHand,
  createHand,
  type Hand,
  holdOut,
} from "../../../../src/world/player/hand.ts";
import type { Player } from "../../../../src/world/player/player.ts";
import { CollisionMesh } from "../../../../src/world/room/collision-mesh.ts";
import { FloorPlan } from "../../../../src/world/room/floor-plan.ts";
import { chance } from "../../chance.ts";
import { box, FURNISHED, insideOf, modelRoom, Rubble } from "../rooms.ts";

const HOLD = [0.25, -0.4, 0.55] as const;
const CANDLE = { radius: 0.07, height: 0.3 };
const NOTHING = new CollisionMesh([]);
const AT_REST: Omit<Player, "pitch"> = { position: [0, 0, 0], velocity: [0, 0, 0], yaw: 0 };

describe("the walker", () => {
  test("is 1.6 m tall to the eye, walks at 1.4 and runs at 2.8 m/s", () => {
    expect([EYE_HEIGHT, WALK, RUN]).toEqual([1.6, 1.4, 2.8]);
  });

  test("gets as far and as fast in one step as in a hundred", () => {
    const once: Vec3 = [0, 0, -1];
    const often: Vec3 = [0, 0, -1];
    const way: Vec3 = [0, 0, 0];
    accelerate(once, [0, 0, WALK], 0.5, way);
    const stretch: Vec3 = [0, 0, 0];
    let ways = 0;
    for (let i = 0; i < 100; i++) {
      accelerate(often, [0, 0, WALK], 0.005, stretch);
      ways += stretch[2];
    }
    expect(ways).toBeCloseTo(way[2], 12);
    expect(often[2]).toBeCloseTo(once[2], 12);
  });

  test("is at 95 % of his pace after a quarter of a second, and stands after half of one", () => {
    const velocity: Vec3 = [0, 0, 0];
    const way: Vec3 = [0, 0, 0];
    accelerate(velocity, [WALK, 0, 0], 0.25, way);
    expect(velocity[0]).toBeGreaterThan(0.95 * WALK);
    accelerate(velocity, [0, 0, 0], 0.5, way);
    expect(velocity[0]).toBeLessThan(0.01);
  });

  test("stands still two thirds of a second after a stop, as far on as if that took for ever", () => {
    const [velocity, stretch]: [Vec3, Vec3] = [
      [WALK, 0, 0],
      [0, 0, 0],
    ];
    const whole: Vec3 = [0, 0, 0];
    accelerate([WALK, 0, 0], [0, 0, 0], 1e3, whole);
    let way = 0;
    for (let i = 0; i < 40; i++) {
      accelerate(velocity, [0, 0, 0], 1 / 60, stretch);
      way += stretch[0];
    }
    expect(velocity).toEqual([0, 0, 0]);
    expect(way).toBeCloseTo(whole[0], 9);
  });
});

describe("the head", () => {
  const over = (speed: number): Vec3[] =>
    Array.from({ length: 400 }, (_, i) =>
      headBob({ stride: i / 400, player: { ...AT_REST, velocity: [speed, 0, 0] } }, [0, 0, 0]),
    );

  test.each([WALK, RUN])("bobs by at most 12 mm, and sways by at most 6, at %d m/s", (speed) => {
    const heights = over(speed).map(([, y]) => y);
    const sides = over(speed).map(([x]) => x);
    expect(Math.max(...heights) - Math.min(...heights)).toBeLessThanOrEqual(0.012 + 1e-12);
    expect(Math.max(...heights) - Math.min(...heights)).toBeGreaterThan(0.008);
    expect(Math.max(...sides.map(Math.abs))).toBeLessThanOrEqual(0.006);
    expect(Math.max(...sides)).toBeGreaterThan(0.002);
  });

  test("is still when the body stands, and never jumps", () => {
    for (const bob of over(0)) for (const offset of bob) expect(offset).toBeCloseTo(0, 12);
    const bobs = over(RUN);
    bobs.forEach((bob, i) => {
      const [x, y] = bobs[(i + 1) % bobs.length]!;
      expect(Math.hypot(bob[0] - x, bob[1] - y)).toBeLessThan(3e-4);
    });
  });

  test("sways across the way that the body faces", () => {
    const [x, , z] = headBob(
      { stride: 0.25, player: { ...AT_REST, velocity: [WALK, 0, 0], yaw: Math.PI / 2 } },
      [0, 0, 0],
    );
    expect(Math.abs(x)).toBeLessThan(1e-12);
    expect(z).toBeCloseTo(-0.004, 9);
  });

  test("is where the way walked puts it, however many steps of time that took", () => {
    let stride = 0;
    for (let i = 0; i < 144; i++) stride = advanceStride(stride, WALK / 144);
    expect(stride).toBeCloseTo(advanceStride(0, WALK), 9);
    expect(advanceStride(0.3, 1.6 * 5)).toBeCloseTo(0.3, 9);
  });
});

/** The hand after an even turn and then rest, in so many steps a second. */
function turned(rate: number, turn: number, seconds: number): Hand {
  const hand = createHand(0);
  const steps = Math.round(seconds * rate);
  for (let i = 1; i <= steps; i++)
    advanceHand(hand, { ...AT_REST, yaw: (turn * i) / steps }, seconds / steps);
  return hand;
}

describe("the hand", () => {
  test("trails an even turn by twice its rate over the spring's, and catches up after it", () => {
    const hand = turned(120, 1.2, 1);
    expect(hand.lag).toBeCloseTo((2 * 1.2) / 18, 4);
    advanceHand(hand, { ...AT_REST, yaw: 1.2 }, 0.5);
    expect(Math.abs(hand.lag)).toBeLessThan(0.005);
  });

  test("is in the same place at 30, 60 and 144 steps a second, and in a single one", () => {
    const once = turned(2, 0.8, 0.5);
    for (const rate of [30, 60, 144]) {
      const hand = turned(rate, 0.8, 0.5);
      expect(hand.lag).toBeCloseTo(once.lag, 10);
      expect(hand.turning).toBeCloseTo(once.turning, 9);
    }
    const sway = (steps: number) => {
      const hand = createHand(0);
      for (let i = 1; i <= steps; i++) {
        advanceHand(hand, { ...AT_REST, velocity: [(WALK * i) / steps, 0, 0] }, 0.2 / steps);
      }
      return hand;
    };
    for (const steps of [6, 12, 29]) {
      expect(sway(steps).sway[0]).toBeCloseTo(sway(1).sway[0], 10);
      expect(sway(steps).swaying[0]).toBeCloseTo(sway(1).swaying[0], 9);
    }
    expect(sway(1).sway[0]).toBeLessThan(-0.01);
  });

  test("does not overshoot", () => {
    const hand = createHand(0);
    advanceHand(hand, { ...AT_REST, yaw: 0.5 }, 1 / 120);
    expect(hand.lag).toBeGreaterThan(0.4);
    let last = hand.lag;
    for (let i = 0; i < 240; i++) {
      advanceHand(hand, { ...AT_REST, yaw: 0.5 }, 1 / 120);
      expect(hand.lag).toBeGreaterThanOrEqual(0);
      expect(hand.lag).toBeLessThanOrEqual(last);
      last = hand.lag;
    }
  });

  test("turns the short way past the back", () => {
    const hand = createHand(Math.PI - 0.1);
    advanceHand(hand, { ...AT_REST, yaw: -Math.PI + 0.1 }, 1 / 60);
    expect(hand.lag).toBeGreaterThan(0);
    expect(hand.lag).toBeLessThan(0.2);
  });

  test("holds the candle where a stiff arm would when all is calm", () => {
    const hand = createHand(0.7);
    const foot: Vec3 = [0, 0, 0];
    holdOut(
      hand,
      { ...AT_REST, position: [1, 1.6, 2], yaw: 0.7 },
      HOLD,
      NOTHING,
      CANDLE,
      1 / 60,
      foot,
    );
    const [sin, cos] = [Math.sin(0.7), Math.cos(0.7)];
    expect(foot[0]).toBeCloseTo(1 + 0.25 * cos - 0.55 * sin, 12);
    expect(foot[1]).toBeCloseTo(1.2, 12);
    expect(foot[2]).toBeCloseTo(2 - 0.25 * sin - 0.55 * cos, 12);
  });

  test("keeps the candle in view, however wildly the head is turned", () => {
    const hand = createHand(0);
    const foot: Vec3 = [0, 0, 0];
    for (let i = 1; i < 200; i++) {
      advanceHand(hand, { ...AT_REST, velocity: [(i % 3) * 2, 0, 0], yaw: (i % 7) * 0.9 }, 1 / 120);
      holdOut(
        hand,
        { ...AT_REST, position: [0, 1.6, 0], yaw: (i % 7) * 0.9 },
        HOLD,
        NOTHING,
        CANDLE,
        1 / 120,
        foot,
      );
      const yaw = (i % 7) * 0.9;
      const ahead = -foot[0] * Math.sin(yaw) - foot[2] * Math.cos(yaw);
      expect(ahead).toBeGreaterThan(0.3);
    }
    calmHand(hand, { ...AT_REST, yaw: 1 });
    expect([hand.lag, hand.turning, hand.sway, hand.swaying]).toEqual([0, 0, [0, 0, 0], [0, 0, 0]]);
  });

  test("draws the candle back from a wall, and gently puts it out again", () => {
    const collision = new CollisionMesh([insideOf([-2, 0, -2], [2, 2.6, 2])]);
    const hand = createHand(0);
    const foot: Vec3 = [0, 0, 0];
    const hold = (z: number, seconds: number) => {
      holdOut(hand, { ...AT_REST, position: [0, 1.6, z] }, HOLD, collision, CANDLE, seconds, foot);
      return foot[2] - z;
    };
    expect(hold(0, 1 / 60)).toBeCloseTo(-0.55, 9);
    expect(hold(-1.75, 1 / 60)).toBeGreaterThan(-0.25 + 0.07 - 1e-9);
    const near = hold(-1.75, 0.1);
    expect(hold(0, 1 / 60)).toBeGreaterThan(near - 0.1);
    expect(hold(0, 2)).toBeCloseTo(-0.55, 5);
  });

  test("draws back before it has to: walking up to a wall moves the candle by no leap", () => {
    const collision = new CollisionMesh([insideOf([-2, 0, -2], [2, 2.6, 2])]);
    const hand = createHand(0);
    const foot: Vec3 = [0, 0, 0];
    let last = 0.55;
    for (let z = 0; z > -1.74; z -= WALK / 120) {
      holdOut(hand, { ...AT_REST, position: [0, 1.6, z] }, HOLD, collision, CANDLE, 1 / 120, foot);
      expect(Math.abs(z - foot[2] - last)).toBeLessThan(1.2 * (WALK / 120));
      last = z - foot[2];
    }
  });

  test("is not moved by a look ahead", () => {
    const collision = new CollisionMesh([insideOf([-2, 0, -2], [2, 2.6, 2])]);
    const hand = createHand(0);
    const foot: Vec3 = [0, 0, 0];
    holdOut(hand, { ...AT_REST, position: [0, 1.6, -1.7] }, HOLD, collision, CANDLE, 0, foot);
    expect(foot[2]).toBeCloseTo(-1.93, 6);
    expect(hand).toEqual(createHand(0));
  });

  test("passes over a table that is lower than the candle", () => {
    const collision = new CollisionMesh([box([-1, 0, -1], [1, 0.75, -0.3])]);
    const foot: Vec3 = [0, 0, 0];
    holdOut(
      createHand(0),
      { ...AT_REST, position: [0, 1.6, 0] },
      HOLD,
      collision,
      CANDLE,
      1 / 60,
      foot,
    );
    expect(foot[2]).toBeCloseTo(-0.55, 9);
  });

  test.each(["a furnished room", "cabin.glb"])(
    "never lets the candle touch anything on five hundred walks in %s",
    { timeout: 30_000 },
    (name) => {
      const { parts, spawn } = modelRoom(name) ?? FURNISHED;
      const collision = new CollisionMesh(parts);
      const plan = new FloorPlan(collision, spawn);
      const y = plan.floor + EYE_HEIGHT + HOLD[1];
      const rubble = new Rubble(parts, y, y + CANDLE.height);
      const between = chance(21);
      const position: Vec3 = [...plan.start];
      const before: Vec3 = [0, 0, 0];
      const velocity: Vec3 = [0, 0, 0];
      const foot: Vec3 = [0, 0, 0];
      const hand = createHand(0);
      let yaw = 0;
      let nearest = Infinity;
      let shortest = 1;
      for (let walk = 0; walk < 500; walk++) {
        const heading = between(0, 2 * Math.PI);
        const turning = between(-4, 4);
        for (let i = 0; i < 12; i++) {
          before[0] = position[0];
          before[2] = position[2];
          plan.walk(position, [Math.cos(heading) * (RUN / 30), 0, Math.sin(heading) * (RUN / 30)]);
          velocity[0] = (position[0] - before[0]) * 30;
          velocity[2] = (position[2] - before[2]) * 30;
          yaw += turning / 30;
          const eye: Vec3 = [position[0], plan.floor + EYE_HEIGHT, position[2]];
          advanceHand(hand, { ...AT_REST, velocity, yaw }, 1 / 30);
          holdOut(hand, { ...AT_REST, position: eye, yaw }, HOLD, collision, CANDLE, 1 / 30, foot);
          shortest = Math.min(shortest, hand.stretch);
          if (i % 3 === 0) nearest = Math.min(nearest, rubble.distance(foot[0], foot[2]));
        }
      }
      expect(nearest).toBeGreaterThan(CANDLE.radius - 1e-6);
      expect(nearest).toBeLessThan(CANDLE.radius + 0.02);
      expect(shortest).toBeLessThan(0.6);
    },
  );
});
