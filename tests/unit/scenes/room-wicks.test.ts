import { afterEach, expect, test, vi } from "vitest";
import type { Model } from "../../../src/assets/model.ts";
import { placeWicks } from "../../../src/scenes/room-wicks.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { CollisionMesh, type Triangles } from "../../../src/world/room/collision-mesh.ts";
import { box, insideOf } from "../world/rooms.ts";

afterEach(() => void vi.restoreAllMocks());

const ROOM = insideOf([-2, 0, -2], [2, 3, 2]);
const EYE: Vec3 = [1.5, 1.6, 1.5];
const PILLAR = box([-0.5, -0.1, -0.5], [0.5, 3.1, 0.5]);

/** Where wicks at these places burn in a room with a pillar, and what is warned of. */
const placed = (alphaMode: "opaque" | "blend", ...places: readonly Vec3[]) =>
  placedIn(ROOM, alphaMode, ...places);

function placedIn(room: Triangles, alphaMode: "opaque" | "blend", ...places: readonly Vec3[]) {
  const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
  const parts = [room, PILLAR].map((part) => ({ ...part, material: { alphaMode } }));
  const wicks = places.map((position) => ({
    name: "wick",
    position,
    up: [0, 1, 0],
    wickDiameter: 1,
  }));
  const model = { wicks, parts } as unknown as Model;
  const positions = placeWicks(model, new CollisionMesh(parts), EYE).map(
    ({ position }) => position,
  );
  return { positions, warnings: warn.mock.calls.map(([text]) => text) };
}

test("wicks in the room stay where they are", () => {
  expect(placed("opaque", [1, 1, 1], [-1, 0.01, 0])).toEqual({
    positions: [
      [1, 1, 1],
      [-1, 0.01, 0],
    ],
    warnings: [],
  });
});

test("wicks outside and in the pillar are moved, with a warning for each kind", () => {
  const { positions, warnings } = placed(
    "opaque",
    [1, 1, 1000],
    [3, 1, 1],
    [0.4, 1, 0],
    [0, 1, 0.4],
  );
  expect(positions.map((place) => place.map((x) => +x.toFixed(3)))).toEqual([
    [1, 1, 1.95],
    [1.95, 1, 1],
    [0.53, 1, 0],
    [0, 1, 0.53],
  ]);
  expect(warnings).toEqual([
    "Wicks outside of the room were moved into it.",
    "Wicks inside of walls or furniture were moved out.",
  ]);
});

test("wicks in a room whose faces point outwards stay where they are", () => {
  const outside = box([-2, 0, -2], [2, 3, 2]);
  const places: Vec3[] = [
    [1, 0.5, 1],
    [-1, 0.01, 0],
  ];
  expect(placedIn(outside, "opaque", ...places)).toEqual({ positions: places, warnings: [] });
});

test("wicks in a lantern of glass stay there", () => {
  expect(placed("blend", [0.4, 1, 0])).toEqual({ positions: [[0.4, 1, 0]], warnings: [] });
});

test("a wick that is the highest thing of an open scene stays where it is", () => {
  const candle = box([-0.02, 0.86, -0.02], [0.02, 0.9, 0.02]);
  const part = { ...box([-2, -0.01, -2], [2, 0, 2]), material: { alphaMode: "opaque" } };
  const wax = { ...candle, material: { alphaMode: "opaque" } };
  const wicks = [{ name: "wick", position: [0, 0.9, 0], wickDiameter: 1 }];
  const model = { wicks, parts: [part, wax] } as unknown as Model;
  expect(placeWicks(model, new CollisionMesh([part, wax]), EYE)).toEqual(wicks);
});
