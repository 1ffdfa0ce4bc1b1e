import { describe, expect, test } from "vitest";
import type { Model, Part } from "../../../src/assets/model.ts";
import { lightRays } from "../../../src/render/gi/light-rays.ts";
import { entersRoom } from "../../../src/render/moon/entry.ts";
import {
  clipFromFrustum,
  moonCasters,
  moonFrustum,
} from "../../../src/render/moon/moon-frustum.ts";
import { panesOf, stopsMoonlight } from "../../../src/render/moon/panes.ts";
import {
  moonlitPoints,
  traceSurfelVisibility,
} from "../../../src/render/moon/surfel-visibility.ts";
import { groupLitPoints } from "../../../src/render/moon/virtual-lights.ts";
import { tierNamed } from "../../../src/render/quality.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { lightFrom } from "../../../src/world/moon.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { finish } from "../../../src/world/steps.ts";
import { box, floorOf, insideOf, quad } from "../world/rooms.ts";

/** A rectangle across the light of a window in the wall at x = 2, that faces the room. */
function upright(name: string, x: number, low: Vec3, high: Vec3): Part {
  const { positions, indices } = quad(
    [x, low[1], low[2]],
    [x, low[1], high[2]],
    [x, high[1], high[2]],
    [x, high[1], low[2]],
  );
  return { positions, indices, material: { name, alphaMode: "opaque" } } as Part;
}

const BOUNDS = { min: [-2, 0, -2], max: [2.2, 2.5, 2] } as const;
const NIGHT = upright("night", 2.15, [0, 0.8, -0.6], [0, 2, 0.6]);
const GLASS = upright("pane", 2.1, [0, 1, -0.4], [0, 1.8, 0.4]);
const FAR_GLASS = upright("pane", 1, [0, 1, -0.4], [0, 1.8, 0.4]);
const ROOM: Model = {
  parts: [NIGHT, GLASS, FAR_GLASS],
  anchors: {},
  wicks: [],
  bounds: BOUNDS,
  warnings: [],
};

describe("the panes of a window", () => {
  test("are the glass before an upright night", () => {
    const panes = panesOf(ROOM);
    expect(panes?.normal[0]).toBeCloseTo(-1);
    expect(Math.hypot(...(panes?.across ?? []))).toBeCloseTo(0.8);
    expect(Math.hypot(...(panes?.up ?? []))).toBeCloseTo(0.8);
    expect(panes?.corner[0]).toBeCloseTo(2.1);
    expect(panes?.corner[1]).toBeCloseTo(1);
  });

  test("are none where no night lies behind", () => {
    expect(panesOf({ ...ROOM, parts: [GLASS] })).toBeNull();
    expect(panesOf({ ...ROOM, parts: [NIGHT, FAR_GLASS] })).toBeNull();
  });
});

test("what is blended stops moonlight as it does that of flames: where most of it is drawn", () => {
  const stops = (opacity: number, mapOpacity: number) => {
    const material = { alphaMode: "blend", baseColor: [1, 1, 1, opacity], mapOpacity };
    return stopsMoonlight({ ...GLASS, material } as unknown as Part, 0, null);
  };
  expect([stops(1, 1), stops(0.9, 0.7)]).toEqual([true, true]);
  expect([stops(0.1, 1), stops(0.9, 0.3)]).toEqual([false, false]);
});

describe("the moon's map", () => {
  const frustum = moonFrustum(lightFrom(-90, 30), BOUNDS, panesOf(ROOM));
  const clip = clipFromFrustum(frustum);
  const project = ([x, y, z]: Vec3) =>
    [0, 1, 2].map(
      (row) => clip[row]! * x + clip[4 + row]! * y + clip[8 + row]! * z + clip[12 + row]!,
    );

  test("holds the panes, and the room's whole depth", () => {
    for (const y of [1, 1.8]) {
      for (const z of [-0.4, 0.4]) {
        const place = project([2.1, y, z]);
        for (const share of place) expect(Math.abs(share)).toBeLessThan(1);
      }
    }
    const [, , near] = project([2.2, 2.5, 0]);
    const [, , far] = project([-2, 0, 0]);
    expect(near).toBeGreaterThan(-1);
    expect(near).toBeLessThan(far!);
    expect(far).toBeLessThan(1);
  });

  test("holds what stops the light, and neither panes nor the night behind them", () => {
    const [night, glass, far] = moonCasters(ROOM.parts, frustum);
    expect(night?.indices.length).toBe(0);
    expect(glass?.indices.length).toBe(0);
    expect(far?.indices.length).toBe(6);
  });
});

test("moonlight enters a room through its opening, and no other way", () => {
  const room = insideOf([-2, 0, -2], [2, 2.5, 2]);
  const bounds = { min: [-2, 0, -2], max: [2, 2.5, 2] } as const;
  const without = { ...room, indices: room.indices.slice(6) }; // the wall at +X
  for (const azimuth of [0, 90, 180, 270]) {
    expect(
      entersRoom(lightFrom(azimuth, 20), new CollisionMesh([room]), bounds),
      `closed, ${azimuth}`,
    ).toBe(false);
    expect(
      entersRoom(lightFrom(azimuth, 20), new CollisionMesh([without]), bounds),
      `open, ${azimuth}`,
    ).toBe(azimuth === 270);
  }
});

test("a map's edges are at right angles to the light, also near the zenith", () => {
  for (const [azimuth, elevation] of [
    [90, 88],
    [-90, 89.9],
    [10, 90],
    [30, 27],
  ] as const) {
    const direction = lightFrom(azimuth, elevation);
    const { across, up } = moonFrustum(direction, BOUNDS, null);
    for (const [one, other] of [
      [across, up],
      [across, direction],
      [up, direction],
    ] as const) {
      const cosine = one.reduce((sum, x, axis) => sum + x * other[axis]!, 0);
      expect(Math.abs(cosine), `${azimuth} ${elevation}`).toBeLessThan(1e-3);
    }
  }
});

test("a probe sees the moonlit floor on its side of a wall, and not that behind it", () => {
  const wall = box([-0.05, 0, -2], [0.05, 2, 2]);
  const room = new CollisionMesh([floorOf(4), wall]);
  const pane = { alphaMode: "blend", baseColor: [1, 1, 1, 0.1], mapOpacity: 1 };
  const glazed = [
    { ...floorOf(4), material: { alphaMode: "opaque" } },
    { ...wall, material: pane },
  ] as Part[];
  const bounds = { min: [-2, 0, -2], max: [2, 2.5, 2] } as const;
  const frustum = moonFrustum([0, -1, 0], bounds, null);
  const probes = new Float32Array([-1, 0.3, 0, 1, 1, 0.3, 0, 1, 0, 2.4, 0, 1, -1, 0.3, 0, 0]);
  const detail = { ...tierNamed("low").physical.indirect, probes: [4, 1, 1] } as const;
  const lit = moonlitPoints(frustum, room, detail);
  const { width, height, data } = finish(traceSurfelVisibility(lit, room, probes, detail));
  const throughPane = lightRays(room, glazed);
  const glazedData = finish(traceSurfelVisibility(lit, throughPane, probes, detail)).data;
  const { rays, surfels, surfelGroup: group } = detail;
  const groupColumns = (6 * surfels) / group;
  const groups = groupColumns * (surfels / group - 1);
  expect([width, height]).toEqual([4 * rays, Math.ceil((groupColumns * surfels) / group / rays)]);
  /** Share of the groups on a side, the sign of their x, that a probe sees. */
  const seen = (probe: number, side: number, visible = data) => {
    const places = Array.from({ length: groups }, (_, i) => {
      const column = (i % groupColumns) + 0.5;
      const x = frustum.corner[0] + (frustum.across[0] * column) / groupColumns;
      const texel = Math.floor(i / rays) * width + probe * rays + (i % rays);
      return { x: x * side, isSeen: visible[texel] === 255 };
    }).filter(({ x }) => x > 0.2 && x < 1.9);
    expect(places.length).toBeGreaterThan(50);
    return places.filter(({ isSeen }) => isSeen).length / places.length;
  };
  expect([seen(0, -1), seen(0, 1)]).toEqual([1, 0]);
  expect([seen(1, -1), seen(1, 1)]).toEqual([0, 1]);
  expect([seen(0, 1, glazedData), seen(1, -1, glazedData)], "through a pane").toEqual([1, 1]);
  expect(seen(2, 1), "from above, beside the wall's shadow").toBeGreaterThan(0.9);
  expect(seen(3, -1), "inside a solid").toBe(0);
});

test("what the moon lights outside the panes does not shine indoors", () => {
  const sash = upright("frame", 2.12, [0, 1.3, -0.4], [0, 1.35, 0.4]);
  const floor = floorOf(4);
  const frustum = moonFrustum([-0.6, -0.8, 0], BOUNDS, panesOf(ROOM));
  const { indirect } = tierNamed("low").physical;
  const heights = moonlitPoints(frustum, new CollisionMesh([floor, sash]), indirect).flatMap(
    (point) => (point && !point.isPane ? point.position[1] : []),
  );
  expect(heights.length).toBeGreaterThan(100);
  expect(Math.max(...heights)).toBeLessThan(0.01);
});

test("virtual lights stand for surfaces apart from each other, and for all points together", () => {
  const floor = Array.from({ length: 60 }, (_, i) => ({
    position: [(i % 10) * 0.1, 0, Math.floor(i / 10) * 0.1] as Vec3,
    normal: [0, 1, 0] as Vec3,
    isPane: false,
  }));
  const wall = floor.map(({ position: [x, , z] }) => ({
    position: [x, 0.02 + z, -0.02] as Vec3,
    normal: [0, 0, 1] as Vec3,
    isPane: false,
  }));
  const points = [...floor, null, ...wall];
  const groups = groupLitPoints(points, 8);
  expect(groups.length).toBe(8);
  const members = groups.flatMap((group) => group.members).toSorted((a, b) => a - b);
  expect(members).toEqual(points.flatMap((point, i) => (point ? [i] : [])));
  for (const { members, normal, position, extent } of groups) {
    const isOnFloor = members.every((i) => i < floor.length);
    expect(isOnFloor || members.every((i) => i > floor.length), "of one surface").toBe(true);
    expect(normal).toEqual(isOnFloor ? [0, 1, 0] : [0, 0, 1]);
    expect(members.map((i) => points[i]?.position)).toContain(position);
    expect(extent).toBeLessThan(0.25);
  }
  expect(groupLitPoints([null, null], 8)).toEqual([]);
  expect(groupLitPoints([floor[0]!, floor[0]!], 8).length, "none of them empty").toBe(1);
});
