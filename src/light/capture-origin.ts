import type { Vec3 } from "../world/geometry.js";

/** Spacing of the capture grid, metres. */
const STEP = 0.004;
/** A small flame's light sways this far from its foot before the capture origin follows, metres. */
const REACH = 0.04;

/** Snaps a coordinate to the capture grid, metres. */
export function snapToGrid(place: number): number {
  return Math.round(place / STEP) * STEP;
}

/**
 * Capture origin of shadow maps and surfels: near the middle of the light, and still while the flame flickers.
 *
 * It lies on a grid, so that it depends on where the flame is now and not on when it last moved. The rest of
 * the way, half the reach at most, is corrected where the captures are used.
 *
 * @param foot of the flame, metres
 * @param light its middle, metres
 * @param height of the flame in still air, metres: a tall one puffs, and sways as far
 */
export function captureOrigin(foot: Readonly<Vec3>, light: Readonly<Vec3>, height: number): Vec3 {
  const reach = Math.max(REACH, height);
  const sideways = (axis: 0 | 2) => {
    const sway = Math.round((light[axis] - foot[axis]) / reach) * reach;
    return snapToGrid(foot[axis] + sway);
  };
  const above = (Math.floor((light[1] - foot[1]) / reach) + 0.5) * reach;
  return [sideways(0), snapToGrid(foot[1] + above), sideways(2)];
}
