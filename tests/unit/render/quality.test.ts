import { expect, test } from "vitest";
import { isSoftware, type Tier, tierNamed } from "../../../src/render/quality.ts";
import { SETTINGS } from "../../../src/settings.ts";

const NAMES = SETTINGS.quality.choices.filter((name) => name !== "auto");

test.each(NAMES)("%s is what it says", (name) => {
  expect(tierNamed(name).name).toBe(name);
});

test("Renderers that run on the CPU are known", () => {
  for (const name of [
    "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)",
    "llvmpipe (LLVM 15.0.7, 256 bits)",
    "Microsoft Basic Render Driver",
  ]) {
    expect(isSoftware(name)).toBe(true);
  }
  expect(isSoftware("ANGLE (NVIDIA, NVIDIA GeForce RTX 3060, OpenGL 4.5)")).toBe(false);
});

/** Samples kept for each pixel of the canvas. */
function storedSamples({ resolutionScale, samples }: Tier): number {
  return resolutionScale ** 2 * Math.max(1, samples);
}

test("Every further quality costs more than the one before", () => {
  const tiers = NAMES.map(tierNamed);
  for (const [i, tier] of tiers.entries()) {
    const less = tiers[i - 1];
    if (!less) continue;
    expect(tier.resolutionScale).toBeGreaterThanOrEqual(less.resolutionScale);
    expect(storedSamples(tier)).toBeGreaterThan(storedSamples(less));
  }
  expect(tiers).toHaveLength(4);
});
