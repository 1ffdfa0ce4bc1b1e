import { flameRadius, fullHeight } from "../../world/flame/burning.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import type { Wick } from "../../world/standing-candle.js";
import { FIELD_OF_VIEW, PITCH, STRETCH } from "../lone-candle-framing.js";
import type { LoneCamera } from "./lone-renderer.js";

/** Pitch of the camera for a flat model, radians; for one as high as it is wide it is `PITCH`. */
const FROM_ABOVE = -0.42;
/** Share of the canvas that the model fills, one way or the other. */
const FILLING = 0.92;
/** Room to sway, metres. */
const SWAY = 0.008;
/** Height of the view of a taper alone, metres. */
const TAPER_VIEW = 0.3;

interface CustomFraming extends LoneCamera {
  /** Of a taper alone over this view's. */
  readonly magnification: number;
}

/** Box around a model and its flames at their highest. */
export function boundsWithFlames({ min, max }: Bounds, wicks: readonly Wick[]): Bounds {
  const low: Vec3 = [...min];
  const high: Vec3 = [...max];
  for (const { position, wickDiameter } of wicks) {
    const top = STRETCH * fullHeight(wickDiameter);
    const side = flameRadius(wickDiameter, 1) + SWAY;
    for (const axis of [0, 1, 2] as const) {
      const [below, above] = axis === 1 ? [0, top] : [side, side];
      low[axis] = Math.min(low[axis], position[axis] - below);
      high[axis] = Math.max(high[axis], position[axis] + above);
    }
  }
  return { min: low, max: high };
}

/** Camera from in front and a little above, for which a box fills a canvas of this aspect, uncropped. */
export function frameBox({ min, max }: Bounds, aspect: number): CustomFraming {
  const width = Math.max(max[0] - min[0], max[2] - min[2]);
  const flatness = Math.min(Math.max(1 - (max[1] - min[1]) / width, 0), 1);
  const pitch = PITCH + (FROM_ABOVE - PITCH) * flatness;
  const sin = Math.sin(pitch);
  const cos = Math.cos(pitch);
  const middle = [0, 1, 2].map((axis) => (min[axis]! + max[axis]!) / 2);
  // Corners in view space, from the middle.
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((corner) => {
    const [x = 0, y = 0, z = 0] = [0, 1, 2].map(
      (axis) => (corner & (1 << axis) ? max : min)[axis]! - middle[axis]!,
    );
    return [x, y * cos + z * sin, z * cos - y * sin] as const;
  });
  const up = (FILLING * Math.tan(FIELD_OF_VIEW / 2)) / Math.min(aspect, 1);
  const side = up * aspect;
  let distance = 0;
  for (const [x, y, towards] of corners) {
    distance = Math.max(distance, Math.abs(x) / side + towards, Math.abs(y) / up + towards);
  }
  const [x = 0, y = 0, z = 0] = middle;
  return {
    eye: [x, y - distance * sin, z + distance * cos],
    pitch,
    fieldOfView: FIELD_OF_VIEW,
    magnification: (2 * distance * Math.tan(FIELD_OF_VIEW / 2)) / TAPER_VIEW,
  };
}
