import { expect, test } from "vitest";
import type { Box } from "../../../src/gl/gpu.ts";
import { RestTurns } from "../../../src/render/opaque/rest-turns.ts";
import { tiles } from "../../../src/render/screen-bounds.ts";

const SIZE = { width: 400, height: 300 };
const NEAR: Box = [100, 100, 20, 20];
const TILES = tiles(SIZE, { rows: 3, columns: 4 });

/** What is drawn in frames between which the flame moves by `step` (m): "near", a tile's number, or nothing. */
function drawn(frames: number, step: number, near: Box | null = NEAR): unknown[] {
  const turns = new RestTurns();
  return Array.from({ length: frames }, (_, frame) => {
    turns.begin();
    const box = turns.next(near, [step * (frame + 1), 1, 0], SIZE);
    if (box === near) return box && "near";
    return box && TILES.findIndex((tile) => `${tile}` === `${box}`);
  });
}

test("what is near a flame that sways and a tile take turns", () => {
  expect(drawn(6, 0.002)).toEqual(["near", 0, "near", 1, "near", 2]);
  expect(drawn(26, 0.002).filter((box) => box !== "near")).toEqual([
    ...[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0],
  ]);
});

test("while the flame is calm, a tile waits for two turns", () => {
  const none = null;
  expect(drawn(9, 0.0002)).toEqual(["near", 0, "near", none, "near", 1, "near", none, "near"]);
});

test("with the flame out of view each turn is a tile's", () => {
  expect(drawn(4, 0.002, null)).toEqual([0, 1, 2, 3]);
});

test("a flame that has stopped is followed everywhere, a tile in every other frame, and then no more", () => {
  const turns = new RestTurns();
  turns.begin();
  const boxes = Array.from({ length: 26 }, () => turns.next(null, [0, 1, 0], SIZE));
  expect(boxes).toEqual([...TILES.flatMap((tile) => [tile, null]), null, null]);
  expect(turns.isStale).toBe(false);
});
