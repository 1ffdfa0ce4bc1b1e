import { expect, test } from "vitest";
import { type Bvh, buildBvh } from "../../../../src/world/room/bvh.ts";

/** Depth of a tree, and the items that its leaves count. */
function survey({ link, count }: Bvh): { depth: number; items: number } {
  let [depth, items] = [0, 0];
  const visit = (node: number, level: number): void => {
    depth = Math.max(depth, level);
    items += count[node] ?? 0;
    if (count[node] !== 0) return;
    const first = link[node] ?? 0;
    for (const child of [first, first + 1]) visit(child, level + 1);
  };
  visit(0, 0);
  return { depth, items };
}

test.each([
  ["of one place are halved", 5000, () => [3, 3], 11],
  ["of two places are put apart first", 5000, (i: number) => [0, i % 2], 11],
  [
    "with no number between their places are halved",
    5000,
    (i: number) => [2 ** -52 * (1 + (i % 2)), 1],
    11,
  ],
  ["that are no numbers are halved", 5000, () => [Number.NaN, Number.NaN], 11],
  [
    "of which each split leaves one are halved from some depth on",
    126,
    (i: number) => [0, 2 ** -i],
    37,
  ],
] as const)("boxes %s", (_, count, sides, depth) => {
  const ranges = Array.from({ length: count }, (_, i) => sides(i));
  const { bvh, order } = buildBvh(
    Float32Array.from(ranges.flatMap(([low, high]) => [low, low, low, high, high, high])),
  );
  expect(survey(bvh)).toEqual({ depth, items: count });
  expect([...order].sort((a, b) => a - b)).toEqual([...order.keys()]);
});
