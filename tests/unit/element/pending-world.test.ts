import { expect, test, vi } from "vitest";
import type { CandleFlame } from "../../../src/candle-flame.ts";
import { PendingWorld } from "../../../src/element/pending-world.ts";
import { createWorld } from "../../../src/world/create-world.ts";
import { takeSnapshot } from "../../../src/world/snapshot.ts";

const REQUEST = {
  scene: "room",
  look: "physical",
  src: "",
  assetRoot: "",
  isStepped: true,
} as const;

test("between two worlds a candle that stood is taken up, once", () => {
  const pending = new PendingWorld();
  expect(pending.take()).toBe(false);
  const stand = { position: [1, 0, 1], yaw: 0 } as const;
  pending.save({ ...takeSnapshot(createWorld("physical", 1)), stand }, REQUEST);
  expect(pending.isHeld).toBe(false);
  expect([pending.take(), pending.isHeld, pending.take()]).toEqual([true, true, false]);
});

test("a new world that is as the page asks is kept", () => {
  const resume = vi.fn();
  const candle = { world: createWorld("physical", 1), isLit: () => true, resume };
  const apply = (pending: PendingWorld) =>
    pending.applyTo(candle as unknown as CandleFlame, REQUEST, false);
  const pending = new PendingWorld();
  expect(apply(pending)).toBe(false);
  pending.setLit(true);
  expect(apply(pending)).toBe(false);
  expect(resume).not.toHaveBeenCalled();
  pending.setLit(false);
  expect(apply(pending)).toBe(true);
  expect(resume).toHaveBeenCalledOnce();
  pending.setLit(true);
  pending.moveCamera({ yaw: 1 });
  expect(apply(pending)).toBe(true);
});
