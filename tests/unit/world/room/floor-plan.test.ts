import { describe, expect, test } from "vitest";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { WALKER_RADIUS } from "../../../../src/world/player/player.ts";
import { CollisionMesh, type Triangles } from "../../../../src/world/room/collision-mesh.ts";
import { FloorPlan } from "../../../../src/world/room/floor-plan.ts";
import { chance } from "../../chance.ts";
import {
  box,
  crowdedRoom,
  FURNISHED,
  floorOf,
  insideOf,
  modelRoom,
  PLAIN,
  quad,
  Rubble,
  sphere,
  table,
} from "../rooms.ts";

const RUN = 2.8;
const WHOLE_TURN = 2 * Math.PI;

/** What stands between ankle and head, from nothing but the triangles. */
const rubbleOf = (parts: readonly Triangles[], floor = 0) =>
  new Rubble(parts, floor + 0.1, floor + 1.7);

function planOf(parts: readonly Triangles[], spawn: Vec3 | null = null): FloorPlan {
  return new FloorPlan(new CollisionMesh(parts), spawn);
}

/** Walks at random, and returns how near anything came to the walker's middle, and where he went. */
function wander(plan: FloorPlan, rubble: Rubble, walks: number, seed: number) {
  const between = chance(seed);
  const { start } = plan;
  let nearest = Infinity;
  let stuck = 0;
  let steps = 0;
  const min = [...start];
  const max = [...start];
  let position: Vec3 = [...start];
  for (let walk = 0; walk < walks; walk++) {
    // Every tenth visitor comes anew, the others go on from where the last one stopped.
    if (walk % 10 === 0) position = [...start];
    const speed = between(0.1, RUN);
    const seconds = walk % 3 === 0 ? 1 / 20 : between(1 / 240, 1 / 20);
    const reach = walk % 50 === 7 ? between(1, 40) : speed * seconds;
    let heading = between(0, WHOLE_TURN);
    for (let step = 0; step < 24; step++) {
      if (between(0, 1) < 0.15) heading = between(0, WHOLE_TURN);
      plan.walk(position, [Math.cos(heading) * reach, 0, Math.sin(heading) * reach]);
      steps++;
      for (const axis of [0, 2]) {
        min[axis] = Math.min(min[axis]!, position[axis]!);
        max[axis] = Math.max(max[axis]!, position[axis]!);
      }
      if (step % 4 === 0) nearest = Math.min(nearest, rubble.distance(position[0], position[2]));
    }
    if (walk % 5 === 0 && !canMove(plan, position)) stuck++;
  }
  return { nearest, stuck, steps, min, max };
}

function canMove(plan: FloorPlan, from: Vec3): boolean {
  for (let i = 0; i < 16; i++) {
    const position: Vec3 = [...from];
    const heading = (WHOLE_TURN * i) / 16;
    plan.walk(position, [Math.cos(heading) * 0.02, 0, Math.sin(heading) * 0.02]);
    if (Math.hypot(position[0] - from[0], position[2] - from[2]) > 0.005) return true;
  }
  return false;
}

describe("ten thousand walks never lead into anything", { timeout: 30_000 }, () => {
  test.each([
    ["a plain room", PLAIN, 2500],
    ["a furnished room", FURNISHED, 4500],
  ])("in %s", (_, { parts, spawn, inside }, walks) => {
    const plan = planOf(parts, spawn);
    const { nearest, stuck, min, max } = wander(plan, rubbleOf(parts), walks, 5);
    expect(nearest).toBeGreaterThanOrEqual(WALKER_RADIUS);
    // Nor is he kept at a distance: he came as near as two squares of the grid.
    expect(nearest).toBeLessThan(WALKER_RADIUS + 0.05);
    expect(stuck).toBe(0);
    for (const axis of [0, 2] as const) {
      expect(min[axis]).toBeGreaterThan(inside.min[axis] + WALKER_RADIUS - 1e-6);
      expect(min[axis]).toBeLessThan(inside.min[axis] + WALKER_RADIUS + 0.06);
      expect(max[axis]).toBeLessThan(inside.max[axis] - WALKER_RADIUS + 1e-6);
      expect(max[axis]).toBeGreaterThan(inside.max[axis] - WALKER_RADIUS - 0.06);
    }
  });

  test.each([
    ["cabin.glb", 2000],
    ["paper-room.glb", 1000],
  ])("in %s", (name, walks) => {
    const model = modelRoom(name);
    if (!model) throw new Error(`${name} is missing: make it with npm run assets.`);
    const { parts, spawn } = model;
    const plan = planOf(parts, spawn);
    const rubble = rubbleOf(parts, plan.floor);
    const { nearest, stuck, min, max } = wander(plan, rubble, walks, 6);
    expect(plan.floor).toBeCloseTo(0, 1);
    expect(nearest).toBeGreaterThanOrEqual(WALKER_RADIUS);
    expect(nearest).toBeLessThan(WALKER_RADIUS + 0.05);
    expect(stuck).toBe(0);
    // He sees the room: he is not shut in a corner of it.
    for (const axis of [0, 2] as const) expect(max[axis]! - min[axis]!).toBeGreaterThan(2);
  });
});

describe("a walker", () => {
  test("passes a gap of 0.6 m, and not one of 0.5 m", () => {
    for (const [gap, passes] of [
      [0.6, true],
      [0.5, false],
    ] as const) {
      const plan = planOf(
        [
          insideOf([-2, 0, -2], [2, 2.6, 2]),
          box([-2, 0, -0.01], [-gap / 2, 2.6, 0.01]),
          box([gap / 2, 0, -0.01], [2, 2.6, 0.01]),
        ],
        [0, 0, 1],
      );
      const position: Vec3 = [...plan.start];
      for (let i = 0; i < 120; i++) plan.walk(position, [0, 0, -RUN / 60]);
      expect(position[2] < -1).toBe(passes);
      expect(plan.isFree(0, -1)).toBe(passes);
    }
  });

  test.each([1 / 240, 1 / 20, 1, 1e3, 1e12])(
    "does not tunnel through one triangle's wall, %d s at a run",
    (seconds) => {
      const wall = quad([-2, 0, 0], [2, 0, 0], [2, 2.6, 0], [-2, 2.6, 0]);
      const plan = planOf([insideOf([-2, 0, -2], [2, 2.6, 2]), wall], [0, 0, 1]);
      for (const slant of [-0.9, 0, 0.4]) {
        const position: Vec3 = [0, 0, 1];
        for (let i = 0; i < 300; i++) {
          plan.walk(position, [slant * RUN * seconds, 0, -RUN * seconds]);
          expect(position[2]).toBeGreaterThanOrEqual(WALKER_RADIUS);
        }
        expect(position[2]).toBeLessThan(WALKER_RADIUS + 0.04);
      }
    },
  );

  test("slides along a wall, and keeps the speed that leads along it", () => {
    const plan = planOf(PLAIN.parts, PLAIN.spawn);
    const position: Vec3 = [0, 0, -1.7];
    const velocity: Vec3 = [1, 0, -1];
    for (let i = 0; i < 60; i++) {
      velocity[2] = -1;
      plan.walk(position, [velocity[0] / 120, 0, velocity[2] / 120], velocity);
    }
    expect(position[0]).toBeCloseTo(0.5, 2);
    expect(velocity[0]).toBeCloseTo(1, 6);
    expect(Math.abs(velocity[2])).toBeLessThan(1e-6);
  });

  test("slides round a table's leg", () => {
    const plan = planOf([floorOf(4), box([-0.03, 0, -0.03], [0.03, 0.7, 0.03])], [0.05, 0, 1]);
    const position: Vec3 = [...plan.start];
    for (let i = 0; i < 200; i++) plan.walk(position, [0, 0, -1.4 / 120]);
    expect(position[2]).toBeLessThan(-0.4);
  });

  test("is not moved by no step, nor by one that is no number", () => {
    const plan = planOf(PLAIN.parts, PLAIN.spawn);
    for (const [dx, dz] of [
      [0, 0],
      [Number.NaN, 1],
      [Infinity, 0],
    ] as const) {
      const position: Vec3 = [0.3, 0, 0.4];
      plan.walk(position, [dx, 0, dz]);
      expect(position).toEqual([0.3, 0, 0.4]);
    }
  });

  test("walks around a candle on the floor, and over where it was", () => {
    const plan = planOf(PLAIN.parts, PLAIN.spawn);
    const across = (): [Vec3, number] => {
      const position: Vec3 = [0.02, 0, 1.4];
      let nearest = Infinity;
      for (let i = 0; i < 240; i++) {
        plan.walk(position, [0, 0, -1.4 / 120]);
        nearest = Math.min(nearest, Math.hypot(position[0], position[2]));
      }
      return [position, nearest];
    };
    plan.setObstacle([0, 0, 0], 0.065);
    const [around, away] = across();
    expect(away).toBeGreaterThanOrEqual(WALKER_RADIUS + 0.065);
    expect(around[2]).toBeLessThan(-0.5);
    plan.setObstacle(null);
    expect(across()[1]).toBeLessThan(0.05);
    plan.setObstacle([0, 1.75, 0], 0.065);
    expect(across()[1], "below one on a high shelf").toBeLessThan(0.05);
  });
});

describe("a walker is put", () => {
  test("to the nearest free spot, from inside of something", () => {
    const parts = [insideOf([-3, 0, -3], [3, 2.6, 3]), box([-1, 0, -1], [1, 1, 1])];
    const plan = planOf(parts, [2, 0, 2]);
    const between = chance(3);
    const rubble = rubbleOf(parts);
    for (let i = 0; i < 200; i++) {
      const position: Vec3 = [between(-1, 1), 0, between(-1, 1)];
      const wayOut = 1.25 - Math.max(Math.abs(position[0]), Math.abs(position[2]));
      const [x, , z] = position;
      plan.settle(position);
      expect(rubble.distance(position[0], position[2])).toBeGreaterThanOrEqual(WALKER_RADIUS);
      expect(Math.hypot(position[0] - x, position[2] - z)).toBeLessThan(wayOut + 0.05);
    }
  });

  test("back into the room from outside, from afar, and from nowhere", () => {
    const plan = planOf(PLAIN.parts, PLAIN.spawn);
    for (const [x, z] of [
      [2.6, 0],
      [1e9, -1e9],
      [Number.NaN, 0],
      [0, Infinity],
    ] as const) {
      const position: Vec3 = [x, 1.6, z];
      plan.settle(position);
      expect(plan.isFree(position[0], position[2])).toBe(true);
      expect(position[1]).toBe(1.6);
    }
  });

  test("nowhere else if the spot is free", () => {
    const plan = planOf(PLAIN.parts, PLAIN.spawn);
    const position: Vec3 = [1.1, 0, -0.7];
    plan.settle(position);
    expect(position).toEqual([1.1, 0, -0.7]);
  });
});

describe("the visitor starts", () => {
  test("at the spawn point", () => {
    expect(planOf(PLAIN.parts, [1, 0, 1]).start).toEqual([1, 0, 1]);
  });

  test("beside what stands on the spawn point", () => {
    const { start } = planOf([...PLAIN.parts, box([0.6, 0, 0.6], [1.4, 1, 1.4])], [1.3, 0, 1]);
    expect(start[0]).toBeGreaterThan(1.4 + WALKER_RADIUS);
    expect(start[0]).toBeLessThan(1.4 + WALKER_RADIUS + 0.05);
  });

  test("in the room, not in the cupboard that the spawn point is in", () => {
    const cupboard = box([-2.4, 0, -1.9], [-1.6, 2, -1.1]);
    const plan = planOf([...PLAIN.parts, cupboard], [-2, 0, -1.5]);
    expect(Math.max(plan.start[0] + 1.6, plan.start[2] + 1.1)).toBeGreaterThan(WALKER_RADIUS);
  });

  test("in the middle of a room without a spawn point, with elbow room", () => {
    const plan = planOf([...PLAIN.parts, ...[box([-0.3, 0, -0.3], [0.3, 1, 0.3])]]);
    expect(plan.clearance(plan.start[0], plan.start[2])).toBeGreaterThan(0.4);
    expect(Math.hypot(plan.start[0], plan.start[2])).toBeLessThan(1.1);
  });
});

describe("the floor is", () => {
  test("at 0 in a room that stands on it, whichever way its faces look", () => {
    expect(planOf([insideOf([-2, 0, -2], [2, 2.6, 2])]).floor).toBe(0);
    expect(planOf([box([-2, 0, -2], [2, 2.6, 2])]).floor).toBe(0);
  });

  test("the lower of two storeys, or the one under the spawn point", () => {
    const house = [floorOf(6, 0.4), floorOf(6, 3.4), box([-3, 0.4, -3], [3, 6, 3])];
    expect(planOf(house).floor).toBeCloseTo(0.4, 6);
    expect(planOf(house, [1, 3.5, 1]).floor).toBeCloseTo(3.4, 6);
    expect(planOf(house, [1, 2, 1]).floor).toBeCloseTo(0.4, 6);
  });

  test("not the ceiling, where that is at 0", () => {
    for (const roof of [floorOf(4), box([-2, -0.1, -2], [2, 0, 2])]) {
      expect(planOf([insideOf([-2, -2.6, -2], [2, 0, 2])]).floor).toBeCloseTo(-2.6, 6);
      expect(planOf([floorOf(4, -2.6), roof]).floor, "a roof is walked on").toBe(0);
    }
  });

  test("under a small thing, and under a low one with a spawn point before it", () => {
    for (const y of [0, -0.375]) {
      const things = table(0, 0).map(({ positions, indices }) => ({
        positions: positions.map((x, i) => (i % 3 === 1 ? x + y : x)),
        indices,
      }));
      for (const spawn of [null, [0, y, 2] as Vec3]) {
        const plan = planOf(things, spawn);
        expect(plan.floor).toBeCloseTo(y, 6);
        expect(plan.isFree(0, 0)).toBe(false);
      }
    }
    const ball = planOf([sphere([0, 0, 0], 0.5, 24)]);
    expect(ball.floor).toBe(-0.5);
    expect(ball.start[2]).toBeCloseTo(1.7, 6);
    const board = [box([-0.6, -0.3, -0.6], [0.6, 0, 0.6])];
    expect(planOf(board, [0, 0, 0]).floor, "where one is meant to stand on it").toBe(0);
  });

  test("not the table under the spawn point", () => {
    const parts = [...PLAIN.parts, box([-0.7, 0.7, 0.5], [0.7, 0.75, 1.5])];
    expect(planOf(parts, [0, 1.6, 1]).floor).toBe(0);
  });

  test("that of the house, not the land around it, under the spawn point", () => {
    const parts = [floorOf(1000, -0.5), floorOf(5, 0), insideOf([-2.5, 0, -2.5], [2.5, 2.5, 2.5])];
    const plan = planOf(parts, [0, 0, 0]);
    expect(plan.floor).toBe(0);
    expect(plan.isFree(2, 2)).toBe(true);
    expect(plan.isFree(3, 3)).toBe(false);
  });

  test("boards, not the ground that they lie on", () => {
    expect(planOf([floorOf(5, -0.03), box([-2, -0.03, -2], [2, 0.012, 2])]).floor).toBeCloseTo(
      0.012,
      3,
    );
  });

  test("that under the spawn point of a slope and of terraces, not what they rise to", () => {
    const rise = 0.2 * Math.tan(Math.PI / 90);
    const slope = Array.from({ length: 100 }, (_, i) =>
      quad(
        [-4, rise * (i + 1), 0.2 * (i + 1)],
        [4, rise * (i + 1), 0.2 * (i + 1)],
        [4, rise * i, 0.2 * i],
        [-4, rise * i, 0.2 * i],
      ),
    );
    expect(planOf(slope, [0, 10 * rise, 2]).floor).toBeLessThan(10 * rise + 0.12);
    const ramp = planOf([quad([-2, 0, 5], [2, 0, 5], [2, 2, -5], [-2, 2, -5])], [0, 1, 0]);
    expect(Math.abs(ramp.floor - 1), "a slope of two triangles").toBeLessThan(0.13);
    const terraces = Array.from({ length: 6 }, (_, i) =>
      quad(
        [-4, i * 0.08, i * 3 + 3],
        [4, i * 0.08, i * 3 + 3],
        [4, i * 0.08, i * 3],
        [-4, i * 0.08, i * 3],
      ),
    );
    expect(planOf(terraces, [0, 0, 1]).floor).toBeLessThan(0.1);
  });
});

describe("any room will do", () => {
  test("one without a floor", () => {
    const open = [
      quad([-2, 0, -2], [2, 0, -2], [2, 2.5, -2], [-2, 2.5, -2]),
      quad([-2, 0, 2], [2, 0, 2], [2, 2.5, 2], [-2, 2.5, 2]),
      quad([-2, 0, -2], [-2, 0, 2], [-2, 2.5, 2], [-2, 2.5, -2]),
      quad([2, 0, -2], [2, 0, 2], [2, 2.5, 2], [2, 2.5, -2]),
    ];
    const plan = planOf(open);
    expect([plan.floor, plan.hasFloor]).toEqual([0, false]);
    expect(plan.isFree(1.6, -1.6)).toBe(true);
    expect(plan.isFree(1.8, 0)).toBe(false);
  });

  test("a meadow without walls: its edge is the end of the world", () => {
    const plan = planOf([floorOf(30)]);
    const position: Vec3 = [...plan.start];
    for (let i = 0; i < 60; i++) plan.walk(position, [RUN / 2, 0, RUN / 20]);
    expect(position[0]).toBeGreaterThan(14.6);
    expect(position[0]).toBeLessThanOrEqual(14.75);
  });

  test("a floor that ends before its bounds do: one does not walk on air", () => {
    // The eaves reach farther than the floor, and the fourth wall is missing.
    const plan = planOf([floorOf(4), floorOf(5, 2.5)], [0, 0, 0]);
    const position: Vec3 = [0, 0, 0];
    for (let i = 0; i < 100; i++) plan.walk(position, [0.05, 0, 0]);
    expect(position[0]).toBeGreaterThan(1.5);
    expect(position[0]).toBeLessThan(2);
  });

  test("boards with cracks between them", () => {
    const boards = Array.from({ length: 20 }, (_, i) =>
      box([-2 + i * 0.2, -0.02, -2], [-2 + i * 0.2 + 0.19, 0, 2]),
    );
    const plan = planOf([...boards, insideOf([-2, -0.02, -2], [2, 2.5, 2])]);
    expect(plan.isFree(1.6, 1.6)).toBe(true);
  });

  test("a doll's house: one walks around it", () => {
    const house = [
      insideOf([-0.4, 0, -0.3], [0.4, 0.7, 0.3]),
      box([-0.4, 0.3, -0.3], [0.4, 0.32, 0.3]),
    ];
    const plan = planOf(house);
    expect(plan.start[2]).toBeCloseTo(1.5, 6);
    const { nearest, stuck, min, max } = wander(plan, rubbleOf(house), 300, 9);
    expect(nearest).toBeGreaterThanOrEqual(WALKER_RADIUS);
    expect(nearest).toBeLessThan(WALKER_RADIUS + 0.05);
    expect(stuck).toBe(0);
    for (const axis of [0, 2] as const) {
      expect(min[axis]).toBeLessThan(-1.5);
      expect(max[axis]).toBeGreaterThan(1.5);
    }
  });

  test("a model of a town where nobody fits: one walks around it", () => {
    const houses = Array.from({ length: 400 }, (_, i) => {
      const [x, z] = [(i % 20) - 10, Math.floor(i / 20) - 10];
      return box([x, 0, z], [x + 0.8, 1.8, z + 0.8]);
    });
    const plan = planOf([floorOf(20), ...houses]);
    expect(plan.start[2]).toBeCloseTo(11.2, 6);
    expect(plan.hasFloor, "a candle can be put down there").toBe(false);
    expect(plan.isFree(-11, -11)).toBe(true);
  });

  test("a kilometre of land with a wall in it", () => {
    const parts = [floorOf(1000), box([-20, 0, -5.05], [20, 3, -4.95])];
    const plan = planOf(parts, [0, 0, 0]);
    expect(plan.start).toEqual([0, 0, 0]);
    const position: Vec3 = [0, 0, 0];
    plan.walk(position, [0, 0, -30]);
    expect(position[2]).toBeGreaterThanOrEqual(-4.95 + WALKER_RADIUS);
    expect(position[2]).toBeLessThan(-4.95 + WALKER_RADIUS + 0.2);
    plan.walk(position, [1e4, 0, 0]);
    expect(position[0]).toBeGreaterThan(35);
  });

  test.each([
    ["nothing", []],
    ["one triangle of no area", [quad([0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0])]],
    ["coordinates that are no numbers", [box([Number.NaN, 0, 0], [1, Infinity, 1]), floorOf(5)]],
    [
      "a collision block",
      [
        box([-1, 0, -1], [1, 3, 1]),
        box([-0.8, 0, -0.8], [0.8, 3, 0.8]),
        box([-0.5, 0, -0.5], [0.5, 3, 0.5]),
        box([-0.2, 0, -0.2], [0.2, 3, 0.2]),
      ],
    ],
  ] as const)("%s", (_, parts) => {
    const plan = planOf(parts);
    expect(plan.start.every(Number.isFinite)).toBe(true);
    expect(plan.isFree(plan.start[0], plan.start[2])).toBe(true);
    expect(canMove(plan, [...plan.start])).toBe(true);
  });
});

test.each([
  ["60,000 triangles in 5 m", 5, 60_000, 150],
  ["60,000 triangles in 20 m", 20, 60_000, 250],
  ["a million triangles", 20, 1_000_000, 2500],
] as const)(
  "a room of %s is ready in time",
  { timeout: 60_000 },
  (_, size, triangles, milliseconds) => {
    const parts = crowdedRoom(size, triangles);
    let least = Infinity;
    for (let i = 0; i < (triangles > 1e5 ? 1 : 4); i++) {
      // The processor's time, not the clock's: others may be using the machine.
      const before = process.cpuUsage().user;
      const collision = new CollisionMesh(parts);
      const plan = new FloorPlan(collision);
      least = Math.min(least, (process.cpuUsage().user - before) / 1000);
      expect(plan.isFree(plan.start[0], plan.start[2])).toBe(true);
    }
    expect(least).toBeLessThan(milliseconds);
  },
);

test("one starts on the floor of a bent corridor, not in the middle of its bounds", () => {
  const wall = (x0: number, z0: number, x1: number, z1: number) =>
    quad([x0, 0, z0], [x1, 0, z1], [x1, 2.4, z1], [x0, 2.4, z0]);
  const corners = [0, 0, 0, 5, 1.3, 5, 1.3, 1.3, 5, 1.3, 5, 0] as const;
  const walls = [0, 2, 4, 6, 8, 10].map((i) =>
    wall(corners[i]!, corners[i + 1]!, corners[(i + 2) % 12]!, corners[(i + 3) % 12]!),
  );
  const legs = [
    quad([0, 0, 5], [1.3, 0, 5], [1.3, 0, 0], [0, 0, 0]),
    quad([1.3, 0, 1.3], [5, 0, 1.3], [5, 0, 0], [1.3, 0, 0]),
  ];
  const { start } = planOf([...walls, ...legs]);
  expect(Math.min(start[0], start[2])).toBeLessThan(1.3);
  expect(Math.min(start[0], start[2])).toBeGreaterThan(0);
});
