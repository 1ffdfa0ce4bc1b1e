import type { Vec3 } from "../world/geometry.js";

/** Spacing of the capture grid, metres. */
const STEP = 0.004;
/** The light sways this far from the foot of its flame before the capture origin follows, metres. */
const REACH = 0.04;

/** Snaps a coordinate to the capture grid, metres. */
export function snapToGrid(place: number): number {
  return Math.round(place / STEP) * STEP;
}

/**
 * Capture origin of shadow maps and surfels: near the middle of the light, and still while the flame flickers.
 *
 * It lies on a grid, so that it depends on where the flame is now and not on when it last moved. The rest of
 * the way, millimetres, is corrected where the captures are used.
 *
 * @param foot of the flame, metres
 * @param light its middle, metres
 */
export function captureOrigin(foot: Readonly<Vec3>, light: Readonly<Vec3>): Vec3 {
  const sideways = (axis: 0 | 2) => {
    const sway = Math.round((light[axis] - foot[axis]) / REACH) * REACH;
    return snapToGrid(foot[axis] + sway);
  };
  const above = (Math.floor((light[1] - foot[1]) / REACH) + 0.5) * REACH;
  return [sideways(0), snapToGrid(foot[1] + above), sideways(2)];
}
