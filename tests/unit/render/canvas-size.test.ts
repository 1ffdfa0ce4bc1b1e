import { expect, test } from "vitest";
import { canvasSize, longestSide } from "../../../src/render/canvas-size.ts";
import { tierNamed } from "../../../src/render/quality.ts";

const LONGEST = 8192;

test.each([
  ["as large as its box", { width: 640, height: 361 }, 1, { width: 640, height: 361 }],
  ["coarser, as is asked for", { width: 640, height: 361 }, 0.5, { width: 320, height: 181 }],
  ["no longer than the GPU draws", { width: 9000, height: 900 }, 1, { width: 8192, height: 819 }],
  ["no more than its memory holds", { width: 1e4, height: 1e4 }, 1, { width: 4096, height: 4096 }],
  ["a pixel, where the box has none", { width: 1, height: 1 }, 0.25, { width: 1, height: 1 }],
])("a canvas is %s", (_, box, scale, size) => {
  expect(canvasSize(box, scale, LONGEST)).toEqual(size);
});

test("a G-buffer of two samples along each axis is no longer than the GPU draws", () => {
  const sides = (["low", "medium"] as const).map((name) =>
    longestSide({ longestSide: LONGEST }, tierNamed(name)),
  );
  expect(sides).toEqual([LONGEST / 2, LONGEST]);
});

test("a canvas keeps the shape of its box", () => {
  const { width, height } = canvasSize({ width: 7680, height: 4320 }, 1, LONGEST);
  expect(width / height).toBeCloseTo(16 / 9, 3);
  expect(width * height).toBeLessThan(4096 ** 2 * 1.001);
});
