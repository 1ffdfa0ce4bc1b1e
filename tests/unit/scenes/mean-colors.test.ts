import { afterEach, expect, test, vi } from "vitest";
import { type Model, type Part, PLAIN_MATERIAL } from "../../../src/assets/model.ts";
import { withMeanColors } from "../../../src/scenes/mean-colors.ts";

/** Of a triangle, and of one of nine times its area. */
const POSITIONS = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 1, 0, 3, 1];
const modelOf = (colors: readonly number[] | null) => {
  const material = { ...PLAIN_MATERIAL, baseColor: [1, 0.5, 0.5, 1] as const };
  const count = (colors?.length ?? 0) / 4;
  const part = {
    material,
    colors: colors && Float32Array.from(colors),
    positions: Float32Array.from(POSITIONS.slice(0, 3 * count)),
    indices: Uint16Array.from(count === 6 ? [0, 1, 2, 3, 4, 5] : []),
  } as unknown as Part;
  return { parts: [part] } as unknown as Model;
};
const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
afterEach(() => warn.mockClear());

test("vertex colours tint a part in their mean, and a sentence says so where they differ", () => {
  const [part] = withMeanColors(modelOf([1, 0, 0, 1, 0, 0.5, 0, 1])).parts;
  expect(part?.material.baseColor).toEqual([0.5, 0.125, 0, 1]);
  expect(part?.colors).toBeNull();
  expect(warn).toHaveBeenCalledTimes(1);
});

test("they count by the area that they tint", () => {
  const [red, green] = [
    [1, 0, 0, 1],
    [0, 1, 0, 1],
  ] as const;
  const [part] = withMeanColors(modelOf([red, red, red, green, green, green].flat())).parts;
  const [r, g] = part?.material.baseColor ?? [];
  expect([r, g]).toEqual([expect.closeTo(0.1, 9), expect.closeTo(0.45, 9)]);
});

test("those of one colour are exact, and parts without any as they were", () => {
  const blue = withMeanColors(modelOf([0, 0, 1, 1, 0, 0, 1, 1])).parts[0];
  expect(blue?.material.baseColor).toEqual([0, 0, 0.5, 1]);
  const plain = modelOf(null);
  expect(withMeanColors(plain).parts).toEqual(plain.parts);
  expect(warn).not.toHaveBeenCalled();
});
