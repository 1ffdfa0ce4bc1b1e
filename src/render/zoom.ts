import { fieldOfViewOf } from "../world/player/field-of-view.js";
import type { World } from "../world/world.js";

/** Magnification against the stage's own field of view. */
export function zoomOf(world: World): number {
  return Math.tan(world.setup.fieldOfView / 2) / Math.tan(fieldOfViewOf(world) / 2);
}
