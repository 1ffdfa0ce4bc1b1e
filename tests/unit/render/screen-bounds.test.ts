import { describe, expect, test } from "vitest";
import { clipFromWorld, clipPosition } from "../../../src/render/camera.js";
import { bandOf, clipOfBox } from "../../../src/render/screen-bounds.js";

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
