import { describe, expect, test } from "vitest";
import type { Model, Part } from "../../../src/assets/model.ts";
import { fitToRoom } from "../../../src/render/gi/fit-to-room.ts";
import { interiorBounds, turned } from "../../../src/render/gi/interior-bounds.ts";
import { PROBE_DEPTH_EDGE, probeTraceOf } from "../../../src/render/gi/probe-rays.ts";
import { octahedral, rayDirections } from "../../../src/render/gi/ray-directions.ts";
import type { Bounds, Vec3 } from "../../../src/world/geometry.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { box, modelOf } from "./boxes.ts";

const DETAIL = { probes: [2, 2, 2], inset: 0.25, rays: 8 } as const;
const ROOM = box([0, 0, 0], [4, 2, 4], false);
/** Directions of the eight probes' rays. */
const CORNERS = Array.from({ length: 8 }, (_, corner) => rayDirections(DETAIL.rays, corner));

describe("Probes of an empty room", () => {
  const rays = probeTraceOf(new CollisionMesh([ROOM]), modelOf(ROOM), DETAIL).finish();

  test("stand a quarter of a cell from the walls, one plane above the other", () => {
    const places = Array.from(rays.positions, (x) => Math.round(x * 6 * 1e4) / 1e4);
    expect(places.slice(0, 4)).toEqual([4, 2, 4, 6]);
    // Second row, second plane, second column.
    expect(places.slice(7 * 4)).toEqual([20, 10, 20, 6]);
  });

  test("look in other directions each", () => {
    const first = CORNERS.map(([direction = []]) => direction);
    for (const [i, direction] of first.entries()) {
      expect(Math.hypot(...direction)).toBeCloseTo(1, 6);
      for (const other of first.slice(0, i)) {
        const cosine = direction.reduce((sum, x, axis) => sum + x * (other[axis] ?? 0), 0);
        expect(cosine).toBeLessThan(0.99);
      }
    }
  });

  test("see its walls from inside, where they are", () => {
    const directions = octahedral(DETAIL.rays, DETAIL.rays, 0);
    for (const [ray, [dx, dy, dz]] of directions.entries()) {
      const at = ((ray >> 3) * 2 * 8 + (ray & 7)) * 4;
      const [nx = 0, ny = 0, nz = 0, distance = 0] = rays.hits.subarray(at, at + 4);
      expect(nx * dx + ny * dy + nz * dz).toBeLessThan(0);
      const ends = [2 / 3 + dx * distance, 1 / 3 + dy * distance, 2 / 3 + dz * distance] as const;
      const away = Math.min(...ends.map((x, axis) => Math.min(x, (axis === 1 ? 2 : 4) - x)));
      expect(away).toBeCloseTo(0, 5);
    }
  });

  test("know the colour's place of every hit", () => {
    expect(rays.runs).toEqual([{ part: 0, first: 0, count: 8 * 64 }]);
    expect(rays.hitUvs.length).toBe(8 * 64 * 4);
    for (let i = 0; i < rays.hitUvs.length; i += 4) {
      const [x = 0, y = 0, u = 0, v = 0] = rays.hitUvs.subarray(i, i + 4);
      const [hit, ray] = [(y * 16 + x) * 4, (y & 7) * 8 + (x & 7)];
      const [dx, dy] = CORNERS[(x >> 3) + 2 * (y >> 3)]?.[ray] ?? [0, 0];
      const distance = rays.hits[hit + 3] ?? 0;
      const probe = ((y >> 3) * 2 + (x >> 3)) * 4;
      // The box has its x and y for texture coordinates.
      expect(u).toBeCloseTo((rays.positions[probe] ?? 0) + dx * distance, 4);
      expect(v).toBeCloseTo((rays.positions[probe + 1] ?? 0) + dy * distance, 4);
    }
  });

  test("see as far as the wall is, in all directions and across the map's seam", () => {
    const detail = { ...DETAIL, rays: 16 };
    const { depths } = probeTraceOf(new CollisionMesh([ROOM]), modelOf(ROOM), detail).finish();
    const directions = octahedral(PROBE_DEPTH_EDGE, PROBE_DEPTH_EDGE - 2, 1);
    for (const [texel, [x, y, z]] of directions.entries()) {
      const at =
        (Math.floor(texel / PROBE_DEPTH_EDGE) * 2 * PROBE_DEPTH_EDGE + (texel % PROBE_DEPTH_EDGE)) *
        2;
      const wall = Math.min(
        (x > 0 ? 10 / 3 : 2 / 3) / Math.abs(x),
        (y > 0 ? 5 / 3 : 1 / 3) / Math.abs(y),
        (z > 0 ? 10 / 3 : 2 / 3) / Math.abs(z),
      );
      const mean = depths[at] ?? 0;
      const deviation = depths[at + 1] ?? 0;
      expect(Math.abs(mean - wall)).toBeLessThan(2.5 * deviation + 0.25);
    }
  });
});

test("a probe's depths deviate around an edge, not at it alone, so that its light ends softly there", () => {
  // Seen from the first probe it ends along +X, 2.5 m before the wall behind it.
  const board = box([1.5, 0, 2 / 3], [1.6, 2, 4], true);
  const detail = { ...DETAIL, rays: 16 };
  const { depths } = probeTraceOf(
    new CollisionMesh([ROOM, board]),
    modelOf(ROOM, board),
    detail,
  ).finish();
  const deviations: number[] = [];
  for (const [texel, [x, y, z]] of octahedral(PROBE_DEPTH_EDGE, 16, 1).entries()) {
    if (x < 0.8 || Math.abs(y) > 0.4 || Math.abs(z) > Math.sin(Math.PI / 15)) continue;
    const row = Math.floor(texel / PROBE_DEPTH_EDGE) * 2 * PROBE_DEPTH_EDGE;
    deviations.push(depths[(row + (texel % PROBE_DEPTH_EDGE)) * 2 + 1]!);
  }
  expect(deviations.length).toBeGreaterThan(5);
  expect(Math.min(...deviations)).toBeGreaterThan(0.15);
});

test("a probe in a block of stone moves out of it, and none sees the block's inside", () => {
  const block = box([0.4, 0, 0.37], [1.3, 0.95, 1.28], true);
  const rays = probeTraceOf(
    new CollisionMesh([ROOM, block]),
    modelOf(ROOM, block),
    DETAIL,
  ).finish();
  const [x = 0, y = 0, z = 0, isOutside] = rays.positions;
  expect(isOutside).toBe(1);
  expect(x > 1.3 || y > 0.95 || z > 1.28 || x < 0.4 || z < 0.37).toBe(true);
  for (let i = 3; i < rays.hits.length; i += 4) expect(rays.hits[i]).toBeGreaterThan(0);
});

test("no ray of a probe meets what is mostly clear", () => {
  const opaque = box([1.9, 0, 0], [2.1, 2, 4], true);
  const material = { ...opaque.material, alphaMode: "blend", baseColor: [1, 1, 1, 0.1] } as const;
  const traced = (...parts: Part[]) =>
    probeTraceOf(new CollisionMesh(parts), modelOf(...parts), DETAIL).finish();
  const [empty, glazed] = [traced(ROOM), traced(ROOM, { ...opaque, material })];
  expect(glazed).toEqual(empty);
  expect(traced(ROOM, opaque).runs.length).toBe(2);
});

test("a probe without a place in the open says so", () => {
  const stone = box([0, 0, 0], [4, 2, 4], true);
  const rays = probeTraceOf(new CollisionMesh([stone]), modelOf(stone), DETAIL).finish();
  expect([...rays.positions].every((x) => x === 0)).toBe(true);
  expect(rays.runs).toEqual([]);
});

/** A part turned about the vertical through the origin. */
function turnedPart(part: Part, yaw: number): Part {
  const positions = part.positions.slice();
  for (let at = 0; at < positions.length; at += 3) {
    positions.set(turned([...positions.slice(at, at + 3)] as Vec3, yaw), at);
  }
  return { ...part, positions };
}

function boundsOf(...parts: Part[]): Bounds {
  const along = (axis: number) =>
    parts.flatMap(({ positions }) => [...positions].filter((_, at) => at % 3 === axis));
  const ends = (most: -1 | 1) =>
    [0, 1, 2].map((axis) => most * Math.max(...along(axis).map((x) => most * x))) as Vec3;
  return { min: ends(-1), max: ends(1) };
}

describe("Bounds of the irradiance volume", () => {
  const [low, high]: [Vec3, Vec3] = [
    [-0.3, -0.1, -0.4],
    [4.2, 2.5, 4.1],
  ];
  const walls = box(low, high, true);
  const bounds = { min: low, max: high };

  test("are those of a room's inner surfaces, without its walls or a recess", () => {
    const pane = box([4, 0.8, 1.9], [4.15, 1.1, 2.1], false);
    const parts = [ROOM, walls, pane];
    const inside = interiorBounds(new CollisionMesh(parts), { ...modelOf(...parts), bounds });
    for (const axis of [0, 1, 2] as const) {
      expect(inside.min[axis]).toBeCloseTo(0, 5);
      expect(inside.max[axis]).toBeCloseTo([4, 2, 4][axis]!, 5);
    }
  });

  test("run along the walls of a room that is turned", () => {
    for (const degrees of [10, 30, 45, -20]) {
      const yaw = (degrees * Math.PI) / 180;
      const room = turnedPart(ROOM, yaw);
      const model = { ...modelOf(room), bounds: boundsOf(room) };
      const inside = interiorBounds(new CollisionMesh([room]), model);
      expect(inside.yaw).toBeCloseTo(yaw, 3);
      for (const [at, axis] of inside.min.entries()) expect(axis, `${at}`).toBeCloseTo(0, 2);
      expect(inside.max[0]).toBeCloseTo(4, 2);
      expect(inside.max[2]).toBeCloseTo(4, 2);
    }
  });

  test("run along the walls, whatever stands in a corner", () => {
    for (const yaw of [0.35, 0]) {
      const cupboard = turnedPart(box([-0.4, 0, -0.4], [0.4, 1.9, 0.4], true), yaw - 0.35);
      for (let at = 0; at < cupboard.positions.length; at += 3) {
        cupboard.positions[at]! += 3.3;
        cupboard.positions[at + 2]! += 3.3;
      }
      const parts = [ROOM, cupboard].map((part) => turnedPart(part, yaw));
      const inside = interiorBounds(new CollisionMesh(parts), {
        ...modelOf(...parts),
        bounds: boundsOf(...parts),
      });
      expect(inside.yaw).toBeCloseTo(yaw, 1);
    }
  });

  test("run along x and z in a round room", () => {
    const sides = [0, 20, 40, 60, 80, 100, 120, 140, 160].map((degrees) => {
      const yaw = (degrees * Math.PI) / 180;
      return turnedPart(box([-2, 0, -2.5], [2, 2, -2.4], true), yaw);
    });
    const floor = box([-2.5, -0.1, -2.5], [2.5, 0, 2.5], true);
    const parts = [...sides, ...sides.map((side) => turnedPart(side, Math.PI)), floor];
    const ceiling = box([-2.5, 2, -2.5], [2.5, 2.1, 2.5], true);
    const all = [...parts, ceiling];
    const model = { ...modelOf(...all), bounds: boundsOf(...all) };
    expect(interiorBounds(new CollisionMesh(all), model).yaw).toBe(0);
  });

  test("run along x and z where walls run in all directions", () => {
    const rooms = [0, 30, 60].map((degrees) => turnedPart(ROOM, (degrees * Math.PI) / 180));
    expect(interiorBounds(new CollisionMesh(rooms), modelOf(...rooms)).yaw).toBe(0);
  });

  test("are a model's own where only an alcove of it is closed", () => {
    const alcove = box([0, 0, 0], [1, 1, 1], false);
    const floor = box([0, -0.1, 0], [4, 0, 4], true);
    const parts = [alcove, floor];
    const own = modelOf(...parts);
    expect(interiorBounds(new CollisionMesh(parts), own)).toEqual({ ...own.bounds, yaw: 0 });
  });

  test("are a model's own where it has no inside", () => {
    expect(interiorBounds(new CollisionMesh([walls]), { ...modelOf(walls), bounds })).toEqual({
      ...bounds,
      yaw: 0,
    });
  });
});

describe("More probes in a large room", () => {
  const probesIn = (width: number, depth: number, probes: Vec3 = [6, 4, 6]) => {
    const room = box([0, 0, 0], [width, 2.5, depth], false);
    const bounds = { min: [0, 0, 0], max: [width, 2.5, depth] };
    const model = { parts: [room], bounds } as unknown as Model;
    return fitToRoom({ probes, inset: 0.3, rays: 8 }, new CollisionMesh([room]), model).probes;
  };

  test("are none in a small one", () => {
    expect(probesIn(5, 4)).toEqual([6, 4, 6]);
  });

  test("stand along its longer side, at most 0.9 m apart, and none in its middle", () => {
    const [columns, rows, planes] = probesIn(8, 4);
    expect(8 / columns).toBeLessThanOrEqual(0.9);
    expect(columns % 2).toBe(0);
    expect([rows, planes]).toEqual([4, 6]);
  });

  test("are at most 1.7 times as many", () => {
    for (const size of [8, 12, 30, 200]) {
      const [columns, , planes] = probesIn(size, size);
      expect(columns * planes).toBeLessThanOrEqual(1.7 * 36);
      expect(columns * planes).toBeGreaterThanOrEqual(36);
    }
  });
});
