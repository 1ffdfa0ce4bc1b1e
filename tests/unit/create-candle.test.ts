import { expect, test, vi } from "vitest";
import type { Options } from "../../src/candle-flame.ts";
import { createCandle } from "../../src/create-candle.ts";
import type { CanvasTarget } from "../../src/scenes/canvas-target.ts";
import type { Scene } from "../../src/scenes/scene.ts";
import { allFeatures } from "../../src/settings.ts";

test("a candle that is not wanted any more makes nothing on the GPU", async () => {
  const prepareRenderer = vi.fn(() => true);
  const scene = { wicks: [], isModelAlone: true, prepareRenderer } as unknown as Scene;
  const target = { gpu: { isLost: false } } as CanvasTarget;
  const wind = { speed: 0, direction: 0, gustiness: 0 };
  const moon = { illuminance: null, direction: null };
  const options = { look: "physical", seed: 1, quality: "low", wind, moon } as Options;
  const rehearse = () => false;
  const creation = { plays: true, isWanted: () => false, rehearse };
  expect(await createCandle(target, scene, allFeatures(), options, creation)).toBeNull();
  expect(prepareRenderer).not.toHaveBeenCalled();
});
