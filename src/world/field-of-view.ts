import type { World } from "./world.js";

/** Least and most, radians. */
const RANGE = [0.3, 2.1] as const;

/** A field of view that can be drawn; null where there is no number to go by. */
export function legalFieldOfView(value: unknown): number | null {
  const radians = typeof value === "number" ? value : Number.NaN;
  return Number.isNaN(radians) ? null : Math.min(Math.max(radians, RANGE[0]), RANGE[1]);
}

/** Field of view across the picture's shorter side, radians. */
export function fieldOfViewOf({ fieldOfView, stage }: World): number {
  return fieldOfView ?? stage.fieldOfView;
}

/** How many times larger things look than in the stage's own field of view. */
export function zoomOf(world: World): number {
  return Math.tan(world.stage.fieldOfView / 2) / Math.tan(fieldOfViewOf(world) / 2);
}
