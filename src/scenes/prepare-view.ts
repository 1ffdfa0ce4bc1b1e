import { nextTask } from "../gl/next-task.js";
import { AutoQuality } from "../render/auto-quality.js";
import { tierNamed } from "../render/quality.js";
import { measureSpeed, type Speed } from "../render/speed.js";
import type { CanvasTarget } from "./canvas-target.js";
import type { Scene } from "./scene.js";
import { type ViewSettings, workOf } from "./view-subject.js";

/** Speed of a target's GPU, for `auto`; measured once, best while it has nothing else to do. */
export function measureTarget({ gpu }: CanvasTarget): Promise<Speed | null> {
  return measureSpeed(gpu, () => performance.now() / 1000);
}

/**
 * Prepares a view in small tasks, so that the page stays responsive.
 *
 * @param plays whether time will pass, so that each frame is followed by another
 * @param isWanted whether it is still wanted
 * @returns the quality to begin with; null where it is not wanted, or the context was lost
 */
export async function prepareView(
  target: CanvasTarget,
  scene: Scene,
  settings: ViewSettings,
  plays: boolean,
  isWanted: () => boolean,
): Promise<AutoQuality | null> {
  const auto = new AutoQuality(workOf(scene, settings));
  const { quality } = settings;
  if (quality === "auto") auto.speed = await measureTarget(target);
  const { tier: name } = plays ? auto.rung : auto.stillRung;
  const tier = tierNamed(quality === "auto" ? name : quality);
  while (!scene.prepareRenderer(target, tier, settings)) {
    await nextTask();
    if (!isWanted()) return null;
  }
  await nextTask();
  return isWanted() ? auto : null;
}
