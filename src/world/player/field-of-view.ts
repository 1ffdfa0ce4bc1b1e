import type { World } from "../world.js";

/** Radians. */
const LEAST = 0.3;
const MOST = 2.1;

/** The nearest legal field of view, radians; null where the value is no number. */
export function legalFieldOfView(value: unknown): number | null {
  if (typeof value !== "number" || Number.isNaN(value)) return null;
  return Math.min(Math.max(value, LEAST), MOST);
}

/** Field of view across the frame's shorter side, radians. */
export function fieldOfViewOf({ fieldOfView, setup }: World): number {
  return fieldOfView ?? setup.fieldOfView;
}
