import { fullHeight, TAPER_WICK } from "../world/flame/burning.js";
import type { Vec3 } from "../world/geometry.js";

/** Half the width and half the height of a taper and its flame, with room to sway. Metres. */
const HALF = { width: 0.088, height: 0.15 } as const;
/** Height of the frame's centre above the candle's foot, metres. */
const CENTRE = 0.119;
/** Across the canvas's shorter side, radians: a portrait's, from about a metre. */
export const FIELD_OF_VIEW = 0.3;
/** Pitch of the camera, radians: slightly downwards, into the pan. */
export const PITCH = -0.16;
/** Largest height of a puffing flame, in mean heights. */
export const STRETCH = 1.25;

/**
 * Camera for which the candle at the origin fills a canvas of this aspect, uncropped.
 *
 * @param wick its diameter, metres: wide wicks have tall flames
 */
export function frameCandle(aspect: number, wick: number) {
  const taller = STRETCH * Math.max(0, fullHeight(wick) - fullHeight(TAPER_WICK));
  const height = HALF.height + taller / 2;
  const half =
    aspect >= 1 ? Math.max(height, HALF.width / aspect) : Math.max(HALF.width, height * aspect);
  const distance = half / Math.tan(FIELD_OF_VIEW / 2);
  const centre = CENTRE + taller / 2;
  const eye: Vec3 = [0, centre - distance * Math.sin(PITCH), distance * Math.cos(PITCH)];
  return { eye, pitch: PITCH, fieldOfView: FIELD_OF_VIEW } as const;
}
