import { CandleFlame, type Options } from "./candle-flame.js";
import { worldOf } from "./scene-world.js";
import type { CanvasTarget } from "./scenes/canvas-target.js";
import { prepareView } from "./scenes/prepare-view.js";
import type { Scene } from "./scenes/scene.js";
import type { Features } from "./settings.js";

interface Creation {
  /** Whether time will pass, so that each frame is followed by another. */
  readonly plays: boolean;
  /** Whether it is still wanted. */
  readonly isWanted: () => boolean;
  /** Makes a candle what it will be in its first frame. */
  readonly rehearse: (candle: CandleFlame) => void;
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
  const world = worldOf(scene, options);
  const auto = await prepareView(target, scene, options, plays, isOn);
  if (!auto) return null;
  const candle = new CandleFlame(target, scene, features, options, plays, { auto, world });
  rehearse(candle);
  await candle.prepareFrame(plays, isOn);
  candle.reset();
  return isOn() ? candle : null;
}
