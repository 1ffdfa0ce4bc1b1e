import { flameHeight, fuelRate, TAPER_RATE } from "../world/flame/burning.js";
import type { Vec3 } from "../world/geometry.js";

/** Half of the width and of the height that a taper and its flame take up, with room to sway. Metres. */
const HALF = { width: 0.088, height: 0.15 } as const;
/** Height of what is in the middle of the picture, metres above the candle's foot. */
const MIDDLE = 0.119;
/** Across the picture's shorter side, radians: a portrait's, from about a metre. */
const FIELD_OF_VIEW = 0.3;
/** The eye looks down a little, into the pan. Radians. */
const PITCH = -0.16;

/** A flame that puffs stretches to this many times its mean height. */
const STRETCH = 1.25;

/**
 * From where the candle at the origin fills a picture of this aspect, and none of it is cut off.
 *
 * @param wick its diameter, metres: wide ones burn high
 */
export function frameCandle(aspect: number, wick: number) {
  const taller = STRETCH * Math.max(0, flameHeight(fuelRate(wick)) - flameHeight(TAPER_RATE));
  const height = HALF.height + taller / 2;
  const half =
    aspect >= 1 ? Math.max(height, HALF.width / aspect) : Math.max(HALF.width, height * aspect);
  const distance = half / Math.tan(FIELD_OF_VIEW / 2);
  const middle = MIDDLE + taller / 2;
  const eye: Vec3 = [0, middle - distance * Math.sin(PITCH), distance * Math.cos(PITCH)];
  return { eye, pitch: PITCH, fieldOfView: FIELD_OF_VIEW } as const;
}
