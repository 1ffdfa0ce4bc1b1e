import type { Vec3 } from "../geometry.js";
import type { World } from "../world.js";
import type { AdaptationView } from "./exposure-adaptation.js";

/** Middle of a flame from its foot, metres. */
const MIDDLE = 0.025;

/** Input of the eye's adaptation, as it is now; null where there is no room in real light. */
export function adaptationView(world: World): AdaptationView | null {
  const { adaptationView: view, player } = world;
  if (!view) return null;
  // Chosen by branches: as the value of an expression that may be null, a number is boxed.
  if (world.fieldOfView === null) view.fieldOfView = world.setup.fieldOfView;
  else view.fieldOfView = world.fieldOfView;
  view.yaw = player.yaw;
  view.pitch = player.pitch;
  const root = brightestRoot(world);
  for (let axis = 0; axis < 3; axis++) view.flame[axis] = root.place[axis]!;
  view.flame[1] += MIDDLE;
  view.candle = root.candle;
  view.luminousIntensity = root.glow;
  view.moonlight = world.moon?.illuminance ?? 0;
  return view;
}

/** Adapts the eye fully, for a new world. */
export function adaptFully(world: World): void {
  const view = adaptationView(world);
  if (!view) return;
  world.adaptation.adaptToDark(view);
  world.adaptation.settle(view);
}

/** Adapts the eye to the view, after a cut. */
export function settleAdaptation(world: World): void {
  const view = adaptationView(world);
  if (view) world.adaptation.settle(view);
}

/** Lets the eye lag behind, after a sudden change. */
export function noticeChange(world: World): void {
  const view = adaptationView(world);
  if (view) world.adaptation.notice(view);
}

const brightest: { candle: number; place: Readonly<Vec3>; glow: number } = {
  candle: 0,
  place: [0, 0, 0],
  glow: 0,
};
/** How much brighter than the carried flame, which is near, another one has to be. */
const BRIGHTER = 2;

/** Root of the carried flame, or of a brighter one. */
function brightestRoot({ flame, emitter, standing }: World): typeof brightest {
  brightest.candle = 0;
  brightest.place = emitter;
  brightest.glow = flame.glow;
  let most = flame.glow * BRIGHTER;
  for (let i = 0; i < standing.length; i++) {
    const candle = standing[i]!;
    if (!(candle.flame.glow > most)) continue;
    most = candle.flame.glow;
    brightest.candle = i + 1;
    brightest.place = candle.root;
    brightest.glow = most;
  }
  return brightest;
}
