import { afterEach, expect, test, vi } from "vitest";
import { type Model, type Part, PLAIN_MATERIAL } from "../../../src/assets/model.ts";
import { withMeanColors } from "../../../src/scenes/mean-colors.ts";

const modelOf = (colors: readonly number[] | null) => {
  const material = { ...PLAIN_MATERIAL, baseColor: [1, 0.5, 0.5, 1] as const };
  const part = { material, colors: colors && Float32Array.from(colors) } as Part;
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

test("those of one colour are exact, and parts without any as they were", () => {
  const blue = withMeanColors(modelOf([0, 0, 1, 1, 0, 0, 1, 1])).parts[0];
  expect(blue?.material.baseColor).toEqual([0, 0, 0.5, 1]);
  const plain = modelOf(null);
  expect(withMeanColors(plain).parts).toEqual(plain.parts);
  expect(warn).not.toHaveBeenCalled();
});
