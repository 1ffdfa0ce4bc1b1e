import { describe, expect, test } from "vitest";
import { AutoQuality } from "../../../src/render/auto-quality.ts";
import { tierNamed } from "../../../src/render/tier.ts";

const SWIFTSHADER =
  "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)";
const GEFORCE = "ANGLE (NVIDIA, NVIDIA GeForce RTX 3060, OpenGL 4.5)";
const IRIS = "ANGLE (Intel, Mesa Intel(R) Iris(R) Xe Graphics (TGL GT2), OpenGL 4.6)";
const FRAME = 1 / 60;

/** A machine on which a pixel at high, drawn at full size, takes so many seconds in all. */
interface Machine {
  readonly full: number;
  /** Time that no resolution saves, seconds. */
  readonly fixed?: number;
  /** Frames end with the display's. */
  readonly waits?: boolean;
}

function frameOn({ full, fixed = 0, waits = true }: Machine, auto: AutoQuality): number {
  const { tier, share } = auto.rung;
  const { resolutionScale, pixelCost } = tierNamed(tier);
  const work = fixed + full * pixelCost * (resolutionScale * share) ** 2;
  return waits ? Math.ceil(work / FRAME - 1e-6) * FRAME : work;
}

/** Lets it run for so long, seconds, and lists the rungs it went to with the moment it did. */
function run(auto: AutoQuality, machine: Machine, duration: number) {
  const changes: { tier: string; share: number; at: number }[] = [];
  for (let time = 0; time < duration; ) {
    const seconds = frameOn(machine, auto);
    time += seconds;
    if (auto.take(seconds)) changes.push({ ...auto.rung, at: time });
  }
  return changes;
}

test("It begins with what the renderer's name promises", () => {
  expect(new AutoQuality(SWIFTSHADER).rung).toEqual({ tier: "low", share: 1 });
  expect(new AutoQuality(IRIS).rung).toEqual({ tier: "medium", share: 1 });
  expect(new AutoQuality(GEFORCE).rung).toEqual({ tier: "high", share: 1 });
});

test("A machine that holds the display's rate is left alone", () => {
  expect(run(new AutoQuality(GEFORCE), { full: 0.01 }, 60)).toEqual([]);
});

test("A second of late frames lowers the resolution, and less than that nothing", () => {
  const auto = new AutoQuality(GEFORCE);
  const changes = run(auto, { full: 0.02, waits: false }, 10);
  expect(changes[0]).toMatchObject({ tier: "high", share: 0.87 });
  expect(changes[0]?.at).toBeGreaterThan(1);
  expect(changes[0]?.at).toBeLessThan(1.2);
  const hiccups = new AutoQuality(GEFORCE);
  for (let i = 0; i < 6000; i++) {
    // Half a second late every other second.
    expect(hiccups.take(i % 100 < 10 ? 0.05 : FRAME)).toBe(false);
  }
});

test("Where resolution is not enough the tier follows, and each in its turn", () => {
  const changes = run(new AutoQuality(GEFORCE), { full: 0.001, fixed: 0.025, waits: false }, 60);
  const tiers = changes.map(({ tier }) => tier);
  expect(tiers.indexOf("medium")).toBeGreaterThan(tiers.indexOf("high"));
  expect(tiers.indexOf("low")).toBeGreaterThan(tiers.indexOf("medium"));
  for (const tier of ["high", "medium"] as const) {
    const shares = changes.filter((change) => change.tier === tier).map(({ share }) => share);
    expect(shares, "falling").toEqual(shares.toSorted((a, b) => b - a));
  }
  for (const [i, { at }] of changes.entries()) {
    expect(at - (changes[i - 1]?.at ?? 0), "a second each").toBeGreaterThan(1);
  }
});

test("A machine better than its name is found out, step by step", () => {
  const auto = new AutoQuality(IRIS);
  const changes = run(auto, { full: 0.012 }, 60);
  expect(changes.at(-1)).toMatchObject({ tier: "high", share: 1 });
  for (const [i, { at }] of changes.entries()) {
    expect(at - (changes[i - 1]?.at ?? 0)).toBeGreaterThan(3);
  }
});

describe("It comes to rest", () => {
  const machines = [0.004, 0.01, 0.015, 0.018, 0.022, 0.03, 0.05, 0.1, 0.3, 2].flatMap((full) =>
    [true, false].flatMap((waits) => [0, 0.012].map((fixed) => ({ full, waits, fixed }))),
  );
  test.each([SWIFTSHADER, IRIS, GEFORCE])("with %s", (renderer) => {
    for (const machine of machines) {
      const auto = new AutoQuality(renderer);
      const changes = run(auto, machine, 120);
      expect(run(auto, machine, 600), JSON.stringify({ machine, changes })).toEqual([]);
      // Up and down again once at each rung, at most.
      const reversals = changes.filter(({ tier, share }, i) =>
        changes.slice(0, i).some((before) => before.tier === tier && before.share === share),
      );
      expect(reversals.length, JSON.stringify({ machine, changes })).toBeLessThanOrEqual(2);
    }
  });
});

test("Frames that come to nothing, or after a hidden page, are no evidence", () => {
  const auto = new AutoQuality(GEFORCE);
  for (let i = 0; i < 100; i++) {
    expect(auto.take(i % 2 === 0 ? 4 : 0)).toBe(false);
    expect(auto.take(Number.NaN)).toBe(false);
  }
  expect(auto.rung).toEqual({ tier: "high", share: 1 });
});

test("A GPU that is idle did not make the frames late, and one that is busy did", () => {
  const idle = new AutoQuality(GEFORCE);
  const busy = new AutoQuality(GEFORCE);
  const taken = Array.from({ length: 100 }, () => [idle.take(0.05, 0.004), busy.take(0.05, 0.045)]);
  expect(taken.some(([isLowered]) => isLowered)).toBe(false);
  expect(taken.some(([, isLowered]) => isLowered)).toBe(true);
});

test("What was too slow is tried again after a change that could have helped, and not before", () => {
  const auto = new AutoQuality(GEFORCE);
  run(auto, { full: 0.1 }, 60);
  const slow = auto.rung;
  expect(slow.tier).not.toBe("high");
  run(auto, { full: 0.001 }, 60);
  const capped = auto.rung;
  expect(capped).not.toEqual({ tier: "high", share: 1 });
  auto.renew();
  expect(auto.rung, "for now").toEqual(capped);
  run(auto, { full: 0.001 }, 60);
  expect(auto.rung).toEqual({ tier: "high", share: 1 });
});
