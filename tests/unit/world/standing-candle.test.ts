import { describe, expect, test } from "vitest";
import { flameReport } from "../../../src/light/flame-light.ts";
import { advance } from "../../../src/world/advance.ts";
import { createPlume } from "../../../src/world/air/plume.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { STILL } from "../../../src/world/player/intent.ts";
import { CollisionMesh } from "../../../src/world/room/collision-mesh.ts";
import { freePlace } from "../../../src/world/room/enclosed.ts";
import type { World } from "../../../src/world/world.ts";
import { createWorld } from "../../support/world.ts";
import { box, insideOf } from "./rooms.ts";

const WIND = { speed: 0.25, direction: 0, gustiness: 1 };
const WICKS = [
  { name: "wick", position: [0, 1, 0], wickDiameter: 0.002 },
  { name: "wick.001", position: [0.05, 1, 0], wickDiameter: 0.002 },
  { name: "wick.002", position: [0.1, 1, 0], wickDiameter: 0.004 },
] as const;

const withCandles = (...areLit: boolean[]) =>
  createWorld("physical", 1, { wind: WIND, wicks: WICKS, areLit, createPlume });

const candleOf = ({ standing }: World, index: number) => {
  const candle = standing[index];
  if (!candle) throw new Error(`There is no standing candle ${index}.`);
  return candle;
};

describe("standing candles", () => {
  test("burn each at its own wick, as large as that is wide", () => {
    const world = withCandles(true, true, true);
    advance(world, STILL, 0.5);
    const reports = world.standing.map((candle) => flameReport(candle));
    for (const [i, { lit, position, luminousIntensity }] of reports.entries()) {
      expect(lit).toBe(true);
      const { position: root } = WICKS[i] ?? { position: [0, 0, 0] };
      expect(Math.hypot(position[0] - root[0], position[2] - root[2])).toBeLessThan(0.02);
      expect(luminousIntensity).toBeGreaterThan(0.5);
    }
    expect(reports[2]?.luminousIntensity).toBeGreaterThan(
      1.5 * (reports[0]?.luminousIntensity ?? Number.NaN),
    );
  });

  test("change nothing about the carried one", () => {
    const [alone, among] = [createWorld("physical", 1, { wind: WIND }), withCandles(true, true)];
    for (const world of [alone, among]) advance(world, STILL, 1);
    expect(flameReport({ root: among.emitter, flame: among.flame })).toEqual(
      flameReport({ root: alone.emitter, flame: alone.flame }),
    );
    expect(among.flame.spine.positions).toEqual(alone.flame.spine.positions);
  });

  test("sway each in its own way, and the same way each time", () => {
    const tips = [1, 2].map(() => {
      const world = withCandles(true, true);
      return Array.from({ length: 60 }, () => {
        advance(world, STILL, 1 / 60);
        return world.standing.map(({ flame }) => flame.spine.positions[3 * 12] ?? 0);
      });
    });
    expect(tips[0]).toEqual(tips[1]);
    const apart = (tips[0] ?? []).map(([a = 0, b = 0]) => Math.abs(a - b));
    expect(Math.max(...apart)).toBeGreaterThan(0.001);
  });

  test("do not exist in the paper's looks", () => {
    expect(createWorld("paper", 1, { wicks: WICKS, areLit: [true] }).standing).toEqual([]);
  });

  test("smoke when they go out, and have no air of their own before and after", () => {
    const world = withCandles(true, false);
    const [burning, unlit] = [candleOf(world, 0), candleOf(world, 1)];
    advance(world, STILL, 0.5);
    expect(burning.plume).toBeNull();
    burning.flame.extinguish();
    advance(world, STILL, 1);
    expect(burning.plume?.smoke.count).toBeGreaterThan(30);
    expect(unlit.plume).toBeNull();
    for (let second = 0; burning.plume && second < 20; second++) advance(world, STILL, 1);
    expect(burning.plume).toBeNull();
    expect(flameReport(burning).luminousIntensity).toBeLessThan(1e-6);
  });

  test("grow as the carried one does when they are lit", () => {
    const world = createWorld("physical", 1, { wicks: WICKS, isLit: false });
    const { flame } = candleOf(world, 0);
    advance(world, STILL, 1);
    expect(flame.glow).toBe(0);
    for (const each of [flame, world.flame]) each.light();
    for (const seconds of [0.2, 0.2, 0.4]) {
      advance(world, STILL, seconds);
      expect(flame.relativeLight).toBeCloseTo(world.flame.relativeLight, 3);
    }
    expect(flame.relativeLight).toBeGreaterThan(0.5);
  });
});

describe("a place for a flame", () => {
  const solids = () => true;
  const wall: readonly [Vec3, Vec3] = [
    [-1.9, -0.1, -1.9],
    [-1.5, 3.1, 1.9],
  ];
  const collision = new CollisionMesh([insideOf([-2, 0, -2], [2, 3, 2]), box(...wall)]);

  test("in the open is left alone", () => {
    const place = [0.5, 1, 0.5] as const;
    expect(freePlace(collision, [...place], 0.03, solids)).toEqual(place);
  });

  test("inside a wall is moved into the room, by the nearest way", () => {
    const [x, y, z] = freePlace(collision, [-1.65, 1, 0.5], 0.03, solids);
    expect(x).toBeCloseTo(-1.47, 5);
    expect([y, z]).toEqual([1, 0.5]);
  });

  test("inside a box that stands on the floor is moved out of it", () => {
    const standing = box([-0.5, 0, -0.5], [0.5, 1, 0.5]);
    const collision = new CollisionMesh([insideOf([-2, 0, -2], [2, 3, 2]), standing]);
    const [x, y, z] = freePlace(collision, [0.3, 0.4, 0], 0.03, solids);
    expect(x).toBeCloseTo(0.53, 5);
    expect([y, z]).toEqual([0.4, 0]);
  });

  test("near the rim of a cup without a top is left alone", () => {
    const cup = box([-0.05, 0, -0.05], [0.05, 0.2, 0.05]);
    // Its top: of the faces across Y the one above.
    const isTop = (at: number) =>
      [1, 4, 7].every(
        (y) => Math.abs(cup.positions[cup.indices[at + Math.floor(y / 3)]! * 3 + 1]! - 0.2) < 1e-6,
      );
    const indices = [...cup.indices].filter((_, i) => !isTop(3 * Math.floor(i / 3)));
    const open = { ...cup, indices: Uint16Array.from(indices) };
    expect(indices.length).toBe(cup.indices.length - 6);
    const collision = new CollisionMesh([insideOf([-2, -0.1, -2], [2, 3, 2]), open]);
    const place = [0, 0.17, 0] as const;
    expect(freePlace(collision, [...place], 0.03, solids)).toEqual(place);
  });

  test("is not inside of what has two sides", () => {
    expect(freePlace(collision, [-1.65, 1, 0.5], 0.03, () => false)).toEqual([-1.65, 1, 0.5]);
  });
});
