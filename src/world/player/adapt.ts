import type { World } from "../world.js";
import type { AdaptationView } from "./exposure-adaptation.js";
import { fieldOfViewOf } from "./field-of-view.js";

/** Middle of a flame from its foot, metres. */
const MIDDLE = 0.025;

/** Input of the eye's adaptation, as it is now; null where there is no room in real light. */
export function adaptationView(world: World): AdaptationView | null {
  const { adaptationView: view, player, flame, emitter } = world;
  if (!view) return null;
  view.fieldOfView = fieldOfViewOf(world);
  view.yaw = player.yaw;
  view.pitch = player.pitch;
  for (let axis = 0; axis < 3; axis++) view.flame[axis] = emitter[axis]!;
  view.flame[1] += MIDDLE;
  view.luminousIntensity = flame.glow;
  return view;
}

/** After a cut: the eye is adapted to what it sees. */
export function settleAdaptation(world: World): void {
  const view = adaptationView(world);
  if (view) world.adaptation.settle(view);
}

/** After a change in no time: the eye has yet to adapt. */
export function noticeChange(world: World): void {
  const view = adaptationView(world);
  if (view) world.adaptation.notice(view);
}
