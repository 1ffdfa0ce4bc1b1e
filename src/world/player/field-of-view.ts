import type { World } from "../world.js";

/** Radians. */
const LEAST = 0.3;
const MOST = 2.1;

/** A field of view that can be drawn; null where there is no number to go by. */
export function legalFieldOfView(value: unknown): number | null {
  if (typeof value !== "number" || Number.isNaN(value)) return null;
  return Math.min(Math.max(value, LEAST), MOST);
}

/** Field of view across the picture's shorter side, radians. */
export function fieldOfViewOf({ fieldOfView, setup }: World): number {
  return fieldOfView ?? setup.fieldOfView;
}
