import { expect, test } from "vitest";
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
