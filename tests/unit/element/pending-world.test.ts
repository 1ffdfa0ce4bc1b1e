import { describe, expect, test, vi } from "vitest";
import type { CandleFlame } from "../../../src/candle-flame.ts";
import { PendingWorld } from "../../../src/element/pending-world.ts";
import type { SceneRequest } from "../../../src/scenes/scene.ts";
import { standCandle } from "../../../src/world/commands.ts";
import type { WorldOptions } from "../../../src/world/create-world.ts";
import { LONE_CANDLE_SETUP, WORLD_SETUPS } from "../../../src/world/world-setup.ts";
import { createWorld } from "../../support/world.ts";

const REQUEST: SceneRequest = {
  scene: "room",
  look: "physical",
  src: "",
  assetRoot: "",
  baseURI: "",
  isStepped: true,
};

/** Between two worlds, in the first of which the candle stood so far ahead of the camera. */
function standing(away: number, birth: WorldOptions = {}): PendingWorld {
  const pending = new PendingWorld();
  const world = createWorld("physical", 1, birth);
  const [x, , z] = world.player.position;
  standCandle(world, [x, 0, z - away], 0);
  pending.save(world, REQUEST);
  return pending;
}

describe("between two worlds", () => {
  test("a candle that stood is taken up, once", () => {
    expect(new PendingWorld().take()).toBe(false);
    const pending = standing(1);
    expect(pending.isHeld).toBe(false);
    expect([pending.take(), pending.isHeld, pending.take()]).toEqual([true, true, false]);
  });

  test("one out of reach of the camera is not", () => {
    expect(standing(1.49).take()).toBe(true);
    expect(standing(1.51).take()).toBe(false);
    const pending = standing(3);
    expect([pending.take(), pending.isHeld]).toEqual([false, false]);
    const [x, y, z] = pending.cameraFor("physical").position;
    pending.moveCamera({ position: [x, y, z - 2] });
    expect(pending.take()).toBe(true);
  });

  test.each([
    ["of a model alone", LONE_CANDLE_SETUP],
    ["of the original", WORLD_SETUPS.original],
  ])("nor one that is fixed: %s", (_, setup) => {
    const pending = standing(1, { setup });
    expect([pending.take(), pending.isHeld]).toEqual([false, false]);
  });
});

test("a new world that is as the page asks is kept", () => {
  const resume = vi.fn();
  const candle = { world: createWorld("physical", 1), resume };
  const apply = (pending: PendingWorld) =>
    pending.applyTo(candle as unknown as CandleFlame, REQUEST, false);
  const pending = new PendingWorld();
  expect(apply(pending)).toBe(false);
  pending.setLit(true, true);
  expect(apply(pending)).toBe(false);
  expect(resume).not.toHaveBeenCalled();
  pending.setLit(false, true);
  expect(apply(pending)).toBe(true);
  expect(resume).toHaveBeenCalledOnce();
  pending.setLit(true, true);
  pending.moveCamera({ yaw: 1 });
  expect(apply(pending)).toBe(true);
});

test("what the page has set outlasts removals, until attributes or a reset decide", () => {
  const pending = new PendingWorld();
  pending.setLit(false, false);
  expect(pending.isLit).toBe(null);
  for (let removals = 0; removals < 2; removals++) {
    pending.leave();
    expect(pending.isLit).toBe(false);
    pending.forgetPlaces();
  }
  pending.forgetFlames(true);
  pending.leave();
  expect(pending.isLit).toBe(null);
  pending.setLit(false, false);
  pending.forget();
  pending.leave();
  expect(pending.isLit).toBe(null);
});
