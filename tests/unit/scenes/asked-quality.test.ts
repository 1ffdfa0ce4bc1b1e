import { expect, test } from "vitest";
import { AutoQuality, WORK } from "../../../src/render/auto-quality.ts";
import { askedQuality } from "../../../src/scenes/asked-quality.ts";

function asked(pixel: number, isPlaying: boolean, inspect: "picture" | "depth") {
  const auto = new AutoQuality(WORK.physical);
  auto.pixel = pixel;
  const { tier, share } = askedQuality("auto", auto, isPlaying, inspect);
  return [tier.name, share];
}

test("passes are inspected at medium, and coarsely while a CPU draws one frame after the other", () => {
  const [cpu, gpu] = [4e-7, 6e-9];
  expect(asked(cpu, true, "picture")[0]).toBe("low");
  expect(asked(gpu, true, "depth")).toEqual(["medium", 1]);
  expect(asked(cpu, true, "depth")).toEqual(["medium", 0.35]);
  expect(asked(cpu, false, "depth"), "one that stays").toEqual(["medium", 1]);
});
