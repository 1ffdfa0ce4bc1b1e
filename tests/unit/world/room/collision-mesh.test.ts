import { describe, expect, test } from "vitest";
import type { Vec3 } from "../../../../src/world/geometry.ts";
import { CollisionMesh, type Triangles } from "../../../../src/world/room/collision-mesh.ts";
import { chance } from "../../chance.ts";
import { box, floorOf, insideOf, modelRoom, quad, Rubble, sphere } from "../rooms.ts";

const DOWN: Vec3 = [0, -1, 0];

/** Triangles strewn in a box of 4 m. */
function strewn(count: number, size: number, seed: number): Triangles {
  const between = chance(seed);
  const positions = new Float32Array(count * 9);
  for (let i = 0; i < count; i++) {
    const middle = [between(-2, 2), between(-2, 2), between(-2, 2)];
    for (let k = 0; k < 9; k++) positions[i * 9 + k] = middle[k % 3]! + between(-size, size);
  }
  return { positions, indices: Uint32Array.from({ length: count * 3 }, (_, i) => i) };
}

function unit(between: (min: number, max: number) => number): Vec3 {
  for (;;) {
    const v: Vec3 = [between(-1, 1), between(-1, 1), between(-1, 1)];
    const length = Math.hypot(...v);
    if (length > 0.1 && length < 1) return v.map((value) => value / length) as Vec3;
  }
}

const sub = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Nearest triangle along a ray, each by its plane and the three sides of its edges. */
function nearest({ positions }: Triangles, origin: Vec3, direction: Vec3): number {
  let least = Infinity;
  for (let i = 0; i < positions.length; i += 9) {
    const corner = (k: number): Vec3 => [positions[k]!, positions[k + 1]!, positions[k + 2]!];
    const [a, b, c] = [corner(i), corner(i + 3), corner(i + 6)];
    const normal = cross(sub(b, a), sub(c, a));
    const distance = dot(normal, sub(a, origin)) / dot(normal, direction);
    const point = origin.map((value, axis) => value + direction[axis]! * distance) as Vec3;
    if (!(distance >= 0 && distance < least)) continue;
    const isLeftOf = (p: Vec3, q: Vec3) => dot(normal, cross(sub(q, p), sub(point, p))) >= 0;
    if (isLeftOf(a, b) && isLeftOf(b, c) && isLeftOf(c, a)) least = distance;
  }
  return least;
}

describe("a ray", { timeout: 30_000 }, () => {
  test("meets the same of 2,000 triangles, large or small, as one that tries each", () => {
    for (const [size, seed] of [
      [0.1, 1],
      [0.8, 2],
    ] as const) {
      const triangles = strewn(2000, size, seed);
      const collision = new CollisionMesh([triangles]);
      const between = chance(seed + 10);
      let hits = 0;
      for (let i = 0; i < 300; i++) {
        const origin: Vec3 = [between(-2, 2), between(-2, 2), between(-2, 2)];
        const direction = unit(between);
        const expected = nearest(triangles, origin, direction);
        const hit = collision.raycast(origin, direction, Infinity);
        if (Number.isFinite(expected)) hits++;
        expect(hit?.distance ?? Infinity).toBeCloseTo(expected, 6);
      }
      expect(hits).toBeGreaterThan(20);
    }
  });

  test("meets a surface from either side, with its normal towards the ray", () => {
    const collision = new CollisionMesh([floorOf(4, 1)]);
    const above = collision.raycast([0.3, 3, 0.2], DOWN, 9);
    expect(above?.distance).toBeCloseTo(2, 6);
    expect(above?.normal[1]).toBeCloseTo(1, 9);
    const below = collision.raycast([0.3, 0, 0.2], [0, 1, 0], 9);
    expect(below?.distance).toBeCloseTo(1, 6);
    expect(below?.normal[1]).toBeCloseTo(-1, 9);
  });

  test("reaches as far as it is told, and no farther", () => {
    const collision = new CollisionMesh([floorOf(4)]);
    expect(collision.raycast([0, 2, 0.5], DOWN, 1.99)).toBeNull();
    expect(collision.raycast([0, 2, 0.5], DOWN, 2.01)).not.toBeNull();
    expect(collision.raycast([0, 2, 0.5], [0, 1, 0], 9)).toBeNull();
    expect(collision.raycast([2.1, 2, 0], DOWN, 9)).toBeNull();
  });

  test("says where in its triangle it met it, and from which side", () => {
    const triangles = strewn(200, 0.8, 3);
    const collision = new CollisionMesh([triangles]);
    const between = chance(4);
    const sides = new Set<boolean>();
    for (let i = 0; i < 100; i++) {
      const origin: Vec3 = [between(-2, 2), between(-2, 2), between(-2, 2)];
      const direction = unit(between);
      const hit = collision.raycast(origin, direction, Infinity);
      if (!hit) continue;
      const { distance, triangle, isBack, u, v } = hit;
      const [a, b, c] = [0, 3, 6].map((at): Vec3 => {
        const [x = 0, y = 0, z = 0] = triangles.positions.subarray(triangle * 9 + at);
        return [x, y, z];
      }) as [Vec3, Vec3, Vec3];
      for (const [axis, from] of origin.entries()) {
        const place = a[axis]! + u * (b[axis]! - a[axis]!) + v * (c[axis]! - a[axis]!);
        expect(place).toBeCloseTo(from + distance * direction[axis]!, 4);
      }
      expect(isBack).toBe(dot(cross(sub(b, a), sub(c, a)), direction) > 0);
      sides.add(isBack);
    }
    expect(sides.size).toBe(2);
  });

  test("names the triangle by its place in the parts, whatever order the tree keeps", () => {
    const parts = [floorOf(4), quad([-2, 1, 2], [2, 1, 2], [2, 1, -2], [-2, 1, -2])];
    const collision = new CollisionMesh(parts);
    const from: Vec3 = [0.5, 2, 0.7];
    const upper = collision.raycast(from, DOWN, 9)?.triangle ?? -1;
    const lower = collision.raycast([0.5, 0.5, 0.7], DOWN, 9)?.triangle ?? -1;
    const before = (parts[0]?.indices.length ?? 0) / 3;
    expect(upper).toBeGreaterThanOrEqual(before);
    expect(upper).toBeLessThan(before + 2);
    expect(lower).toBeLessThan(before);
  });

  test("meets the first listed of things that are equally near", () => {
    const things = Array.from({ length: 40 }, () => floorOf(3));
    const between = chance(9);
    const collision = new CollisionMesh(things);
    const perThing = things[0]!.indices.length / 3;
    for (let ray = 0; ray < 50; ray++) {
      const hit = collision.raycast([between(-1, 1), 1, between(-1, 1)], DOWN, 2);
      expect(hit!.triangle).toBeLessThan(perThing);
    }
  });

  test("does not slip through the seams of a floor of 50 x 50 squares", () => {
    const parts: Triangles[] = [];
    for (let i = 0; i < 50; i++) {
      for (let j = 0; j < 50; j++) {
        // Of one corner, each square has its own opinion.
        const [x0, z0] = [i * 0.1 - 2.5, j * 0.1 - 2.5];
        const [x1, z1] = [x0 + 0.1, z0 + 0.1];
        parts.push(quad([x0, 0, z1], [x1, 0, z1], [x1, 0, z0], [x0, 0, z0]));
      }
    }
    const collision = new CollisionMesh(parts);
    for (let i = 0; i < 2000; i++) {
      // Along grid lines and diagonals, and on their crossings.
      const x = Math.fround(((i % 40) - 20) * 0.1);
      const z = i % 2 ? x : Math.fround((((i / 50) | 0) - 20) * 0.1);
      expect(collision.raycast([x, 1.6, z], DOWN, 9)).not.toBeNull();
    }
  });

  test("along an axis in the very plane of a box's faces meets the box", () => {
    const collision = new CollisionMesh([box([-1, 0, -1], [1, 1, 1])]);
    expect(collision.raycast([-1, 3, 0], DOWN, 9)?.distance).toBeCloseTo(2, 6);
    expect(collision.raycast([-3, 1, -1], [1, 0, 0], 9)?.distance).toBeCloseTo(2, 6);
  });
});

describe("an upright cylinder", { timeout: 30_000 }, () => {
  test("overlaps what its middle is nearer to than its radius, between its foot and its top", () => {
    const triangles = strewn(300, 0.3, 4);
    const collision = new CollisionMesh([triangles]);
    const between = chance(5);
    const truth = new Rubble([triangles], -0.2, 0.1);
    let overlaps = 0;
    for (let i = 0; i < 400; i++) {
      const [x, z, radius] = [between(-2, 2), between(-2, 2), between(0.02, 0.35)];
      const distance = truth.distance(x, z);
      if (Math.abs(distance - radius) < 1e-6) continue;
      const isNear = distance < radius;
      expect(collision.overlapsCylinder([x, -0.2, z], radius, 0.3)).toBe(isNear);
      if (isNear) overlaps++;
    }
    expect(overlaps).toBeGreaterThan(40);
    expect(overlaps).toBeLessThan(360);
  });

  test("stops on its way where it touches, and not before", () => {
    const collision = new CollisionMesh([
      box([1, 0, -1], [1.5, 1, 1]),
      box([-0.01, 0.5, -3], [0.01, 2, -2.98]),
    ]);
    const sweep = (dx: number, dz: number, y = 0.6) =>
      collision.sweepCylinder([0, y, 0], [dx, 0, dz], { radius: 0.07, height: 0.25 }).fraction;
    expect(sweep(2, 0)).toBeCloseTo((1 - 0.07) / 2, 6);
    expect(sweep(0.9, 0)).toBe(1);
    expect(sweep(2, 0, 1.01)).toBe(1);
    expect(sweep(-2, 0)).toBe(1);
    // A rod, touched with the rim and passed beside.
    expect(sweep(0, -4)).toBeCloseTo((2.98 - 0.07) / 4, 6);
    expect(sweep(0.2, -4)).toBe(1);
    // Past the corner of the box, within a radius of it.
    const corner = collision.sweepCylinder([0, 0.6, 1.05], [2, 0, 0], {
      radius: 0.07,
      height: 0.25,
    }).fraction;
    expect(corner).toBeCloseTo((1 - Math.sqrt(0.07 ** 2 - 0.05 ** 2)) / 2, 6);
    expect(
      collision.sweepCylinder([1.45, 0.6, 0], [1, 0, 0], { radius: 0.07, height: 0.25 }).fraction,
    ).toBe(0);
  });

  test("is free all the way to where it stops, and touches a thousandth beyond", () => {
    const triangles = strewn(300, 0.3, 8);
    const collision = new CollisionMesh([triangles]);
    const between = chance(9);
    const truth = new Rubble([triangles], 0, 0.3);
    let stops = 0;
    for (let i = 0; i < 600; i++) {
      const [x, z, dx, dz] = [between(-2, 2), between(-2, 2), between(-1, 1), between(-1, 1)];
      const fraction = collision.sweepCylinder([x, 0, z], [dx, 0, dz], {
        radius: 0.1,
        height: 0.3,
      }).fraction;
      if (truth.distance(x, z) < 0.1) {
        expect(fraction).toBe(0);
        continue;
      }
      for (let k = 0; k <= 20; k++) {
        const t = (fraction * k) / 20;
        expect(truth.distance(x + dx * t, z + dz * t)).toBeGreaterThan(0.1 - 1e-6);
      }
      if (fraction === 1) continue;
      stops++;
      const beyond = fraction + 1e-3;
      expect(truth.distance(x + dx * beyond, z + dz * beyond)).toBeLessThan(0.1);
    }
    expect(stops).toBeGreaterThan(100);
  });
});

describe("a collision", { timeout: 30_000 }, () => {
  test("has the bounds of its triangles", () => {
    const { bounds } = new CollisionMesh([box([-1, 0, -2], [3, 2, 1]), floorOf(1, -0.25)]);
    expect(bounds).toEqual({ min: [-1, -0.25, -2], max: [3, 2, 1] });
  });

  test("of nothing is met by nothing", () => {
    const collision = new CollisionMesh([]);
    expect(collision.raycast([0, 1, 0], DOWN, 9)).toBeNull();
    expect(collision.overlapsCylinder([0, 0, 0], 1, 1)).toBe(false);
    expect(collision.sweepCylinder([0, 0, 0], [1, 0, 0], { radius: 0.1, height: 1 }).fraction).toBe(
      1,
    );
  });

  test("leaves out triangles that are not finite, or whose corners do not exist", () => {
    const floor = floorOf(2);
    const lying = { positions: floor.positions, indices: new Uint16Array([0, 1, 2, 0, 1, 9]) };
    const infinite = box([0, 0, 0], [1, 1, 1]);
    infinite.positions[0] = Infinity;
    const collision = new CollisionMesh([lying, infinite, floorOf(3, -1)]);
    expect(collision.triangles.every(Number.isFinite)).toBe(true);
    // Of the box's twelve, three share the corner that is not there.
    expect(collision.triangles.length / 9).toBe(1 + 9 + 2);
  });

  test("of ten thousand copies of one triangle is none the slower", () => {
    const { positions } = floorOf(2);
    const indices = new Uint16Array(30_000).map((_, i) => i % 3);
    const collision = new CollisionMesh([{ positions, indices }]);
    expect(collision.raycast([0.5, 1, 0.5], DOWN, 9)?.distance).toBe(1);
    expect(collision.triangles.length / 9).toBe(10_000);
  });

  test("too large for the memory keeps its largest triangles", () => {
    const collision = new CollisionMesh(
      [sphere([0, 1, 0], 0.3, 30), insideOf([-3, 0, -3], [3, 2, 3])],
      500,
    );
    expect(collision.triangles.length / 9).toBe(500);
    expect(collision.raycast([2, 1, 2], DOWN, 9)?.distance).toBeCloseTo(1, 6);
  });

  test("too large for the memory keeps what is larger than many equal triangles", () => {
    const { positions } = floorOf(0.1);
    const equal = { positions, indices: new Uint16Array(3000).map((_, i) => i % 3) };
    const collision = new CollisionMesh([equal, insideOf([-3, 0, -3], [3, 2, 3])], 500);
    expect(collision.raycast([2, 1, 2], DOWN, 9)?.distance).toBeCloseTo(1, 6);
  });

  test("of the cabin is closed: no ray escapes through a wall, the floor or the ceiling", () => {
    const cabin = modelRoom("cabin.glb");
    if (!cabin) throw new Error("cabin.glb is missing: make it with npm run assets.");
    const collision = new CollisionMesh(cabin.parts);
    const between = chance(12);
    let escapes = 0;
    for (let i = 0; i < 3000; i++) {
      if (
        !collision.raycast([cabin.spawn?.[0] ?? 0, 1.6, cabin.spawn?.[2] ?? 0], unit(between), 20)
      )
        escapes++;
    }
    expect(escapes).toBe(0);
  });
});
