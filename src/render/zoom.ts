import { fieldOfViewOf } from "../world/field-of-view.js";
import type { World } from "../world/world.js";

/** Magnification against the stage's own field of view. */
export function zoomOf(world: World): number {
  return Math.tan(world.stage.fieldOfView / 2) / Math.tan(fieldOfViewOf(world) / 2);
}
