import { expect, test } from "vitest";
import { PostTiming } from "../../../src/render/post/post-timing.ts";

test("Bloom and exposure are updated in every second frame at rest, and in the first of each image", () => {
  const timing = new PostTiming();
  const at = (images: number) => timing.of("full", { canSkip: true, isShadowNew: false, images });
  const BEFORE = "before display";
  expect([at(1), at(1), at(1), at(1)]).toEqual([BEFORE, "skip", BEFORE, "skip"]);
  expect([at(1), at(2), at(3), at(3)]).toEqual([BEFORE, BEFORE, BEFORE, "skip"]);
});

test("A frame that may skip nothing is metered, and a reprojected one after it was shown", () => {
  const timing = new PostTiming();
  const of = (canSkip: boolean, isShadowNew = false) =>
    timing.of("reprojected", { canSkip, isShadowNew, images: undefined });
  expect([of(false), of(false)]).toEqual(["before display", "before display"]);
  expect(of(true), "with time to spare").toBe("after display");
  expect(of(true, true)).toBe("skip");
});
