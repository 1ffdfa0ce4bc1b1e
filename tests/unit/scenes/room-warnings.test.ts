import { afterEach, expect, test, vi } from "vitest";
import type { Model } from "../../../src/assets/model.ts";
import { warnOfRoom } from "../../../src/scenes/room-warnings.ts";
import type { Vec3 } from "../../../src/world/geometry.ts";
import { CollisionMesh, type Triangles } from "../../../src/world/room/collision-mesh.ts";
import { createRoom } from "../../../src/world/room/room.ts";
import { box, insideOf } from "../world/rooms.ts";

afterEach(() => void vi.restoreAllMocks());

const INSIDE_OUT = "The room's faces point away from its visitor and are invisible.";
const BESIDE =
  "Nowhere in the model can one stand, and its faces point away from where its visitor starts, beside it.";

function warningsOf(
  make: (min: Vec3, max: Vec3) => Triangles,
  max: Vec3,
  isDoubleSided = false,
): string[] {
  const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
  const part = { ...make([0, 0, 0], max), material: { alphaMode: "opaque", isDoubleSided } };
  const collision = new CollisionMesh([part]);
  const model = { parts: [part], bounds: collision.bounds } as unknown as Model;
  warnOfRoom(model, collision, createRoom(collision, null));
  return warn.mock.calls.map(([text]) => text);
}

test("a room, and a thing that one walks around, are as they should be", () => {
  expect(warningsOf(insideOf, [4, 2.6, 4])).toEqual([]);
  expect(warningsOf(box, [0.5, 0.8, 0.5])).toEqual([]);
});

test("a room that is turned inside out is invisible from within", () => {
  expect(warningsOf(box, [4, 2.6, 4])).toEqual([INSIDE_OUT]);
});

test("of double-sided faces it does not matter where they point", () => {
  expect(warningsOf(box, [4, 2.6, 4], true)).toEqual([]);
  expect(warningsOf(insideOf, [4, 1.3, 4], true)).toEqual([]);
});

test("a room that is too low to stand in is invisible from beside it", () => {
  expect(warningsOf(insideOf, [4, 1.3, 4])).toEqual([BESIDE]);
});

test("a model of millimetres has another unit", () => {
  const unit = "The model is 5 mm wide: the unit of a glTF file is a metre.";
  expect(warningsOf(insideOf, [0.005, 0.003, 0.005])).toEqual([unit, BESIDE]);
});
