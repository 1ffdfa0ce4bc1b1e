import { describe, expect, test } from "vitest";
import { clipFromWorld, clipPosition } from "../../../src/render/camera.js";
import {
  bandOf,
  boundsOf,
  boxesBeside,
  clipOfBox,
  mergeOverlapping,
  screenBounds,
} from "../../../src/render/screen-bounds.js";

const SIZE = { width: 853, height: 481 };

describe("Stripes of a picture", () => {
  test("follow each other and are all of it", () => {
    let top = 0;
    for (let stripe = 0; stripe < 12; stripe++) {
      const [x, y, width, rows] = bandOf(SIZE, stripe, 12);
      expect([x, y, width]).toEqual([0, top, SIZE.width]);
      expect(rows).toBeGreaterThan(0);
      top += rows;
    }
    expect(top).toBe(SIZE.height);
  });

  test("have a clip space that ends where they do", () => {
    const clip = clipFromWorld([1, 1.6, 2], 0.4, -0.3, SIZE.width / SIZE.height);
    const stripe = bandOf(SIZE, 3, 12);
    const narrow = clipOfBox(stripe, SIZE, clip);
    const [, bottom, , rows] = stripe;
    let inside = 0;
    for (let i = 0; i < 400; i++) {
      const place = [((i * 7) % 20) / 5 - 2, ((i * 3) % 17) / 6, (i % 23) / 6 - 3] as const;
      const [x, up, w] = clipPosition(clip, ...place);
      const [across, high, depth] = clipPosition(narrow, ...place);
      expect([across, depth]).toEqual([x, w]);
      if (w <= 0) continue;
      const row = (0.5 + (0.5 * up) / w) * SIZE.height;
      expect((0.5 + (0.5 * high) / w) * rows).toBeCloseTo(row - bottom, 2);
      if (Math.abs(high) < w) inside++;
    }
    expect(inside).toBeGreaterThan(5);
  });
});

describe("Bounds on the frame", () => {
  const clip = clipFromWorld([0, 1.5, 0], 0, 0, SIZE.width / SIZE.height);
  const fit = { margin: 4, cell: 4 };
  const bounds = (...spheres: [number, number, number, number][]) =>
    screenBounds(spheres, clip, SIZE, fit);

  test("hold what is ahead, and only that", () => {
    const [x, y, width, height] = bounds([0, 1.5, -2, 0.05])!;
    expect(Math.abs(x + width / 2 - SIZE.width / 2)).toBeLessThan(4);
    expect(Math.abs(y + height / 2 - SIZE.height / 2)).toBeLessThan(4);
    expect(width).toBeLessThan(60);
    expect(bounds([0, 1.5, -2, 0.05], [0, 1.5, 2, 0.05])).toEqual([x, y, width, height]);
  });

  test("are none of what is behind or beside, and all of the frame around the eye", () => {
    expect(bounds([0, 1.5, 2, 0.05])).toBeNull();
    expect(bounds([9, 1.5, -2, 0.05])).toBeNull();
    expect(bounds()).toBeNull();
    expect(bounds([0, 1.5, 0, 0.2])).toEqual([0, 0, SIZE.width, SIZE.height]);
  });

  test("that overlap become one, those apart stay apart", () => {
    const [left, right] = [[0, 0, 10, 10] as const, [30, 0, 10, 10] as const];
    expect(mergeOverlapping([left, right])).toEqual([left, right]);
    expect(mergeOverlapping([left, right, [5, 5, 26, 2]])).toEqual([[0, 0, 40, 10]]);
    expect(boundsOf([left, right])).toEqual([0, 0, 40, 10]);
    expect(boundsOf([])).toEqual([0, 0, 0, 0]);
  });
});

test("Boxes beside others are the rest of the frame, each pixel once", () => {
  const boxes = [
    [0, 10, 30, 20],
    [50, 0, 20, 25],
    [60, 40, 33, 7],
  ] as const;
  const size = { width: 93, height: 47 };
  const counts = new Uint8Array(size.width * size.height);
  for (const [x, y, width, height] of [...boxes, ...boxesBeside(boxes, size)]) {
    for (let row = y; row < y + height; row++) {
      for (let column = x; column < x + width; column++) counts[row * size.width + column]!++;
    }
  }
  expect([...new Set(counts)]).toEqual([1]);
  expect(boxesBeside([], size)).toEqual([[0, 0, 93, 47]]);
});
