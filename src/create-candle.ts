import { missCode } from "./assets/asset-error.js";
import { CandleFlame, type Options } from "./candle-flame.js";
import { nextTask } from "./gl/next-task.js";
import { AutoQuality } from "./render/auto-quality.js";
import { tierNamed } from "./render/quality.js";
import { measureSpeed } from "./render/speed.js";
import { SceneWorlds } from "./scene-worlds.js";
import type { CanvasTarget } from "./scenes/canvas-target.js";
import type { Scene } from "./scenes/scene.js";
import { workOf } from "./scenes/view-subject.js";
import type { Features } from "./settings.js";

interface Creation {
  /** Whether time will pass, so that each frame is followed by another. */
  readonly plays: boolean;
  /** Whether it is still wanted. */
  readonly isWanted: () => boolean;
  /** Makes a candle what it will be in its first frame. Whether it is no longer as new thereby. */
  readonly rehearse: (candle: CandleFlame) => boolean;
}

type InputClass = typeof import("./input/first-person-input.js").FirstPersonInput;
let fetched: InputClass | null = null;

/** Fetches the code of a visitor's input: a lone candle does without. */
export async function fetchInput(): Promise<void> {
  const code = await import("./input/first-person-input.js").catch(missCode);
  fetched = code.FirstPersonInput;
}

/** The class of the input, once it was fetched. */
export function fetchedInput(): InputClass | null {
  return fetched;
}

/** Time of a pixel of the benchmark load on a target, seconds, for `auto`; measured once, or `again`. */
export function measureTarget({ gpu }: CanvasTarget, again?: boolean): Promise<number | null> {
  return measureSpeed(gpu, () => performance.now() / 1000, again);
}

/**
 * Creates a candle, and draws most of its first frame, in small tasks, so that the page stays responsive.
 *
 * Throws if a program or a target is refused.
 *
 * @returns the candle at time 0; null where it is not wanted any more, or the context was lost
 */
export async function createCandle(
  target: CanvasTarget,
  scene: Scene,
  features: Features,
  options: Options,
  { plays, isWanted, rehearse }: Creation,
): Promise<CandleFlame | null> {
  const { gpu } = target;
  const isOn = () => isWanted() && target.gpu === gpu && !gpu.isLost;
  const steps = new SceneWorlds(scene, options).firstInSteps();
  let step = steps.next();
  for (; !step.done; step = steps.next()) {
    await nextTask();
    if (!isOn()) return null;
  }
  const auto = new AutoQuality(workOf(scene, options), () => measureTarget(target, true));
  const { quality } = options;
  if (quality === "auto") auto.pixel = await measureTarget(target);
  if (!isOn()) return null;
  const { tier: name } = plays ? auto.rung : auto.stillRung;
  const tier = tierNamed(quality === "auto" ? name : quality);
  while (!scene.prepareRenderer(target, tier, options)) {
    await nextTask();
    if (!isOn()) return null;
  }
  await nextTask();
  if (!isOn()) return null;
  const world = step.value;
  const candle = new CandleFlame(target, scene, features, options, plays, { auto, world });
  const isChanged = rehearse(candle);
  await candle.prepareFrame(plays, isOn);
  if (isChanged) candle.reset();
  return isOn() ? candle : null;
}
