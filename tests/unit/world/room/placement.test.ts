import { describe, expect, test } from "vitest";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { WALKER_RADIUS } from "../../../../src/world/player/player.ts";
import { CollisionMesh, type Triangles } from "../../../../src/world/room/collision-mesh.ts";
import { FloorPlan } from "../../../../src/world/room/floor-plan.ts";
import {
  type Cylinder,
  canTake,
  findAimedSpot,
  findSpot,
  findSpotAhead,
  REACH,
  type Refusal,
} from "../../../../src/world/room/placement.ts";
import { OPENING } from "../../../support/opening.ts";
import { chance } from "../../chance.ts";
import { box, floorOf, insideOf, modelRoom, quad, Rubble, table } from "../rooms.ts";

const STAND: Cylinder = { radius: 0.065, height: 0.25 };
const EYE: Vec3 = [0, 1.6, 0];
const ROOM = insideOf([-2, 0, -2], [2, 2.6, 2]);

function to(eye: Vec3, point: Vec3): Vec3 {
  const way: Vec3 = [point[0] - eye[0], point[1] - eye[1], point[2] - eye[2]];
  const length = Math.hypot(...way);
  return [way[0] / length, way[1] / length, way[2] / length];
}

/** Looks from one point at another, and tries to put the candle there. */
function put(parts: readonly Triangles[], point: Vec3, eye = EYE) {
  const collision = new CollisionMesh(parts);
  const plan = new FloorPlan(collision, [eye[0], 0, eye[2]]);
  const spot: Vec3 = [Number.NaN, Number.NaN, Number.NaN];
  const reach = { collision, plan, eye, direction: to(eye, point), cylinder: STAND };
  const refusal = findAimedSpot(reach, spot);
  return { refusal, spot, collision };
}

function expectSpot({ refusal, spot }: { refusal: Refusal | null; spot: Vec3 }, expected: Vec3) {
  expect(refusal).toBeNull();
  for (const axis of [0, 1, 2] as const) expect(spot[axis]).toBeCloseTo(expected[axis], 5);
}

describe("a candle is put down", () => {
  test("on the spot of the floor that is looked at", () => {
    expectSpot(put([ROOM], [0.3, 0, -0.9]), [0.3, 0, -0.9]);
  });

  test("on a table", () => {
    expectSpot(put([ROOM, ...table(0, -0.9)], [0.1, 0.75, -0.8]), [0.1, 0.75, -0.8]);
  });

  test("on a shelf as high as the chest, between two boards", () => {
    const shelf = [0.9, 1.2, 1.55].map((y) => box([-0.5, y - 0.02, -1], [0.5, y, -0.7]));
    expectSpot(put([ROOM, ...shelf], [0.2, 1.2, -0.8]), [0.2, 1.2, -0.8]);
  });

  test("farther off than the eye is from the spot as the crow flies, if it is low", () => {
    const low = put([ROOM], [0, 0, -1.19]);
    expect(Math.hypot(low.spot[1] - EYE[1], low.spot[2] - EYE[2])).toBeGreaterThan(1.9);
    expectSpot(low, [0, 0, -1.19]);
  });

  test("not on the visitor's own feet, but just before them", () => {
    const { refusal, spot } = put([ROOM], [0, 0, -0.05]);
    expect(refusal).toBeNull();
    expect(Math.hypot(spot[0], spot[2])).toBeGreaterThan(WALKER_RADIUS + STAND.radius);
    expect(Math.hypot(spot[0], spot[2])).toBeLessThan(0.45);
  });

  test("a little farther in, when it would overhang the edge a bit", () => {
    const parts = [ROOM, box([-0.6, 0, -1], [0.6, 0.75, -0.4])];
    const { refusal, spot } = put(parts, [0, 0.75, -0.44]);
    expect(refusal).toBeNull();
    expect(spot[1]).toBeCloseTo(0.75, 5);
    expect(spot[2]).toBeLessThanOrEqual(-0.4 - STAND.radius + 0.001);
    expect(spot[2]).toBeGreaterThan(-0.44 - 0.0401);
  });

  test("a little off the wall, when it would touch it a bit", () => {
    const { refusal, spot } = put([ROOM], [0, 0, -1.96], [0, 1.6, -1]);
    expect(refusal).toBeNull();
    expect(spot[2]).toBeGreaterThanOrEqual(-2 + STAND.radius - 1e-6);
  });

  test("on boards with cracks of a centimetre between them, on the highest", () => {
    const boards = Array.from({ length: 30 }, (_, i) =>
      box([-2 + i * 0.13, -0.05, -2], [-2 + i * 0.13 + 0.12, (i % 3) * 0.001, 2]),
    );
    const plain = floorOf(4, -0.03);
    for (let x = -0.3; x < 0.3; x += 0.043) {
      const { refusal, spot } = put([...boards, plain], [x, 0, -0.8]);
      expect(refusal).toBeNull();
      expect([0, 0.001, 0.002].some((y) => Math.abs(spot[1] - y) < 1e-6)).toBe(true);
    }
  });

  test("at the height that one walks at, in a room without a floor", () => {
    const walls = [
      quad([-2, 0, -2], [2, 0, -2], [2, 2, -2], [-2, 2, -2]),
      quad([-2, 0, 2], [2, 0, 2], [2, 2, 2], [-2, 2, 2]),
      quad([2, 0, -2], [2, 0, 2], [2, 2, 2], [2, 2, -2]),
      quad([-2, 0, -2], [-2, 0, 2], [-2, 2, 2], [-2, 2, -2]),
    ];
    expectSpot(put(walls, [0, 0, -0.9]), [0, 0, -0.9]);
  });
});

describe("a candle is not put down", () => {
  test.each([
    ["on a floor out of reach", [ROOM], [0, 0, -1.5], "nothing within reach"],
    ["on a wall out of reach", [ROOM], [0, 1.6, -2], "nothing within reach"],
    ["on the sky", [floorOf(4)], [0, 3, -1], "nothing within reach"],
    ["on the ceiling", [insideOf([-2, 0, -2], [2, 1.9, 2])], [0, 1.9, -0.8], "too steep"],
    ["on a wall", [ROOM, box([-1, 0, -1.1], [1, 2.6, -1])], [0, 1.4, -1], "too steep"],
    [
      "on a desk that slopes by 20 degrees",
      [ROOM, quad([-0.5, 0.8, -0.4], [0.5, 0.8, -0.4], [0.5, 1.02, -1], [-0.5, 1.02, -1])],
      [0, 0.9, -0.7],
      "too steep",
    ],
    [
      "on a lid that slopes by 5 degrees",
      [ROOM, quad([-0.5, 0.8, -0.4], [0.5, 0.8, -0.4], [0.5, 0.8525, -1], [-0.5, 0.8525, -1])],
      [0, 0.826, -0.7],
      "too steep",
    ],
    ["on a post", [ROOM, box([-0.04, 0, -0.84], [0.04, 0.9, -0.76])], [0, 0.9, -0.8], "overhangs"],
    [
      "half on a book",
      [ROOM, box([-0.5, 0, -1], [0, 0.03, -0.6])],
      [-0.005, 0.03, -0.8],
      "overhangs",
    ],
    [
      "between two boxes too near to each other",
      [ROOM, box([-0.5, 0, -1], [-0.055, 0.2, -0.6]), box([0.055, 0, -1], [0.5, 0.2, -0.6])],
      [0, 0, -0.8],
      "no room",
    ],
  ] as const)("%s", (_, parts, point, reason) => {
    expect(put(parts, [...point]).refusal).toBe(reason);
  });

  test("under a board too low for the flame, though one stoops to look", () => {
    const parts = [ROOM, box([-0.5, 0.2, -1.3], [0.5, 0.22, -0.9])];
    expect(put(parts, [0, 0, -1.1], [0, 0.3, -0.2]).refusal).toBe("no room");
  });

  test("behind a thin wall, when one looks at one's feet before it", () => {
    const wall = quad([-2, 0, -0.26], [2, 0, -0.26], [2, 2.6, -0.26], [-2, 2.6, -0.26]);
    expect(put([ROOM, wall], [0, 0, -0.1]).refusal).toBe("no room");
  });

  test("down a shaft", () => {
    const ledge = [box([-2, -0.1, -0.2], [2, 0, 2]), floorOf(6, -3)];
    expect(put(ledge, [0, -3, -0.9]).refusal).toBe("nothing within reach");
  });
});

describe("with a level gaze, a candle is put down", () => {
  const ahead = (parts: readonly Triangles[], direction: Vec3, eye = EYE) => {
    const collision = new CollisionMesh(parts);
    const plan = new FloorPlan(collision, [eye[0], 0, eye[2]]);
    const spot: Vec3 = [Number.NaN, Number.NaN, Number.NaN];
    const refusal = findSpotAhead({ collision, plan, eye, direction, cylinder: STAND }, spot);
    return { refusal, spot };
  };

  test("on the floor, an arm's length ahead", () => {
    expectSpot(ahead([ROOM], [0, 0, -1]), [0, 0, -0.8]);
    expectSpot(ahead([ROOM], to([0, 0, 0], [1, 0.2, 0])), [0.8, 0, 0]);
  });

  test("on the table that is there", () => {
    expectSpot(ahead([ROOM, ...table(0, -0.9)], [0, 0, -1]), [0, 0.75, -0.8]);
  });

  test("on a table that begins beyond, or ends before, rather than on the floor", () => {
    const [far, near] = [
      box([-0.6, 0.7, -2], [0.6, 0.75, -0.95]),
      box([-0.6, 0.4, -0.72], [0.6, 0.45, -0.4]),
    ];
    const beyond = ahead([ROOM, far], [0, 0, -1]);
    expect(beyond.spot[1]).toBeCloseTo(0.75, 5);
    expect(beyond.spot[2]).toBeLessThanOrEqual(-0.95 - STAND.radius + 0.001);
    expect(beyond.spot[2]).toBeGreaterThan(-REACH);
    expect(ahead([ROOM, near], [0, 0, -1]).spot[1]).toBeCloseTo(0.45, 5);
    const rug = box([-0.6, 0, -2], [0.6, 0.02, -0.95]);
    expectSpot(ahead([ROOM, rug], [0, 0, -1]), [0, 0, -0.8]);
    const [bench, shelf] = [
      box([-0.6, 0.4, -0.95], [0.6, 0.45, -0.6]),
      box([-0.6, 1, -2], [0.6, 1.05, -0.95]),
    ];
    expectSpot(ahead([ROOM, bench, shelf], [0, 0, -1]), [0, 0.45, -0.8]);
    const outOfReach = box([-0.6, 0.7, -2], [0.6, 0.75, -1.2]);
    expectSpot(ahead([ROOM, outOfReach], [0, 0, -1]), [0, 0, -0.8]);
  });

  test("before a wall that is nearer", () => {
    const { refusal, spot } = ahead([ROOM], [0, 0, -1], [0, 1.6, -1.4]);
    expect(refusal).toBeNull();
    expect(spot[2]).toBeGreaterThan(-2 + STAND.radius);
    expect(spot[2]).toBeLessThan(-1.8);
  });

  test("not at all, with the nose to the wall", () => {
    expect(ahead([ROOM], [0, 0, -1], [0, 1.6, -1.73]).refusal).toBe("no room");
  });
});

describe("wherever it is put down in the cabin", { timeout: 30_000 }, () => {
  test("it stands on the table as seen from where the page opens", () => {
    const cabin = modelRoom("cabin.glb");
    if (!cabin) throw new Error("cabin.glb is missing: make it with npm run assets.");
    const collision = new CollisionMesh(cabin.parts);
    const plan = new FloorPlan(collision, cabin.spawn);
    const { yaw, pitch, position: eye } = OPENING.camera;
    const level = Math.cos(pitch);
    const direction: Vec3 = [-Math.sin(yaw) * level, Math.sin(pitch), -Math.cos(yaw) * level];
    const spot: Vec3 = [0, 0, 0];
    expect(findSpot({ collision, plan, eye, direction, cylinder: STAND }, spot)).toBeNull();
    expect(spot[1] - plan.floor).toBeGreaterThan(0.7);
  });

  test("it stands on something, all of it, within reach, and touches nothing", () => {
    const cabin = modelRoom("cabin.glb");
    if (!cabin) throw new Error("cabin.glb is missing: make it with npm run assets.");
    const collision = new CollisionMesh(cabin.parts);
    const plan = new FloorPlan(collision, cabin.spawn);
    const between = chance(31);
    const spot: Vec3 = [0, 0, 0];
    const reasons = new Map<Refusal | null, number>();
    const heights = new Set<number>();
    const standing: Vec3 = [...plan.start];
    for (let i = 0; i < 1500; i++) {
      const heading = between(0, 2 * Math.PI);
      plan.walk(standing, [Math.cos(heading) * between(0, 1.5), 0, Math.sin(heading) * 1]);
      const eye: Vec3 = [standing[0], plan.floor + 1.6, standing[2]];
      const yaw = between(0, 2 * Math.PI);
      const pitch = between(-1.3, -0.2);
      const level = Math.cos(pitch);
      const direction: Vec3 = [-Math.sin(yaw) * level, Math.sin(pitch), -Math.cos(yaw) * level];
      const refusal = findAimedSpot({ collision, plan, eye, direction, cylinder: STAND }, spot);
      reasons.set(refusal, (reasons.get(refusal) ?? 0) + 1);
      if (refusal !== null) continue;
      expect(Math.hypot(spot[0] - eye[0], spot[2] - eye[2])).toBeLessThan(REACH + 0.0401);
      expect(canTake(collision, eye, spot, STAND)).toBe(true);
      heights.add(Math.round((spot[1] - plan.floor) * 10));
      let held = 0;
      for (let k = 0; k < 40; k++) {
        const [angle, radius] = [k * 2.4, 0.065 * Math.sqrt((k + 0.5) / 40)];
        const from: Vec3 = [
          spot[0] + Math.cos(angle) * radius,
          spot[1] + 0.003,
          spot[2] + Math.sin(angle) * radius,
        ];
        if (collision.raycast(from, [0, -1, 0], 0.009)) held++;
      }
      // The others are over the cracks of the floor.
      expect(held).toBeGreaterThanOrEqual(34);
      expect(collision.overlapsCylinder([spot[0], spot[1] + 0.006, spot[2]], 0.065, 0.24)).toBe(
        false,
      );
    }
    expect(reasons.get(null)).toBeGreaterThan(200);
    expect(reasons.get("nothing within reach")).toBeGreaterThan(20);
    expect(reasons.get("too steep")).toBeGreaterThan(20);
    expect(heights.size).toBeGreaterThan(2);
  });
});

describe("a candle that stands can be taken", () => {
  test.each([
    ["from the floor at one's feet", [0, 0, -0.4], true],
    ["from where it was put at arm's length", [REACH, 0.75, 0], true],
    ["half a step farther off", [0, 0.75, 1.45], true],
    ["not from across the room", [0, 0.75, 1.6], false],
    ["not from a beam overhead", [0, 2.2, -0.4], false],
  ] as const)("%s", (_, foot, can) => {
    expect(canTake(new CollisionMesh([]), EYE, foot, STAND)).toBe(can);
  });

  test.each([
    ["through a wall", 2.5, false],
    ["over a chest, of the flame alone", 1.25, true],
  ])("%s: %s m", (_, height, can) => {
    const wall = new CollisionMesh([box([0.5, 0, -1], [0.6, height, 1])]);
    expect(canTake(wall, EYE, [1.2, 0.75, 0], STAND)).toBe(can);
  });
});

test("a rubble heap agrees with a ruler", () => {
  // The oracle of these tests, by itself.
  const rubble = new Rubble([box([1, 0, -1], [2, 1, 1])], 0.1, 1.7);
  expect(rubble.distance(0.8, 0)).toBeCloseTo(0.2, 9);
  expect(rubble.distance(0.9, 1.1)).toBeCloseTo(Math.SQRT2 * 0.1, 9);
  expect(rubble.distance(1.5, 0)).toBe(0);
  expect(rubble.distance(0.3, 0)).toBe(0.4);
});
