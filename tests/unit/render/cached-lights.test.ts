import { expect, test } from "vitest";
import { groupedAroundFirst } from "../../../src/render/cached-lights.ts";
import { createStandingCandle } from "../../../src/world/standing-candle.ts";

test("A candle beyond those with shadows lights from the place of the nearest that has them", () => {
  const candles = [0, 3, 2.4, 0.5, -1].map((x, i) =>
    createStandingCandle(
      { name: `wick.${i}`, position: [x, 1, 0], wickDiameter: 0.002 },
      i + 1,
      1,
      true,
    ),
  );
  const names = (most: number) =>
    groupedAroundFirst(candles, most).map((group) => group.map(({ name }) => name));
  expect(names(2)).toEqual([
    ["wick.0", "wick.3", "wick.4"],
    ["wick.1", "wick.2"],
  ]);
  expect(names(8)).toEqual(candles.map(({ name }) => [name]));
  expect(names(0)).toEqual([]);
});
