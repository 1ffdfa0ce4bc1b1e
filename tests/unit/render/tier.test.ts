import { expect, test } from "vitest";
import { type Tier, tierOf } from "../../../src/render/tier.ts";
import { SETTINGS } from "../../../src/settings.ts";

const SWIFTSHADER =
  "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)";
const GEFORCE = "ANGLE (NVIDIA, NVIDIA GeForce RTX 3060, OpenGL 4.5)";

test.each(["low", "medium", "high", "ultra"] as const)("%s is what it says, on any GPU", (name) => {
  expect(tierOf(name, SWIFTSHADER).name).toBe(name);
  expect(tierOf(name, GEFORCE).name).toBe(name);
});

test("auto asks less of a renderer that runs on the CPU", () => {
  const cost = (renderer: string) => storedSamples(tierOf("auto", renderer));
  for (const software of [
    SWIFTSHADER,
    "llvmpipe (LLVM 15.0.7, 256 bits)",
    "Microsoft Basic Render Driver",
  ]) {
    expect(cost(software)).toBeLessThan(cost(GEFORCE));
  }
});

/** Samples kept for each pixel of the canvas. */
function storedSamples({ resolutionScale, samples }: Tier): number {
  return resolutionScale ** 2 * Math.max(1, samples);
}

test("every further quality costs at least as much as the one before", () => {
  const tiers = SETTINGS.quality.choices
    .filter((name) => name !== "auto")
    .map((name) => tierOf(name, GEFORCE));
  for (const [i, tier] of tiers.entries()) {
    const less = tiers[i - 1];
    if (!less) continue;
    expect(tier.resolutionScale).toBeGreaterThanOrEqual(less.resolutionScale);
    expect(storedSamples(tier)).toBeGreaterThan(storedSamples(less));
  }
  expect(tiers).toHaveLength(4);
});
