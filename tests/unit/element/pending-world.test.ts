import { describe, expect, test, vi } from "vitest";
import type { CandleFlame } from "../../../src/candle-flame.ts";
import { PendingWorld } from "../../../src/element/pending-world.ts";
import type { SceneRequest } from "../../../src/scenes/scene.ts";
import { takeSnapshot } from "../../../src/world/snapshot.ts";
import { createWorld } from "../../support/world.ts";

const REQUEST: SceneRequest = {
  scene: "room",
  look: "physical",
  src: "",
  assetRoot: "",
  baseURI: "",
  isStepped: true,
};

describe("between two worlds", () => {
  const world = createWorld("physical", 1);
  const [x, , z] = world.player.position;
  const standing = (away: number, request = REQUEST): PendingWorld => {
    const pending = new PendingWorld();
    const stand = { position: [x, 0, z - away], yaw: 0 } as const;
    pending.save({ ...takeSnapshot(world), stand }, request);
    return pending;
  };

  test("a candle that stood is taken up, once", () => {
    expect(new PendingWorld().take()).toBe(false);
    const pending = standing(1);
    expect(pending.isHeld).toBe(false);
    expect([pending.take(), pending.isHeld, pending.take()]).toEqual([true, true, false]);
  });

  test("one out of reach of the camera is not", () => {
    const pending = standing(3);
    expect([pending.take(), pending.isHeld]).toEqual([false, false]);
    pending.moveCamera({ position: [x, 1.6, z - 2] });
    expect(pending.take()).toBe(true);
  });

  test.each([{ scene: "candle" }, { look: "original" }] as const)(
    "nor one that is fixed: %o",
    (fixed) => {
      const pending = standing(1, { ...REQUEST, ...fixed });
      expect([pending.take(), pending.isHeld]).toEqual([false, false]);
    },
  );
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
