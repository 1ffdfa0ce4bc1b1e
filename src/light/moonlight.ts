import type { Rgb } from "./color.js";
import { adaptation, luma } from "./color.js";
import { TAPER } from "./flame-light.js";

/**
 * Moonlight as an eye sees it that is used to a candle: adapted colour, luma 1.
 *
 * Of 4100 K, three channels adapted to a candle of 1900 K would make it a neon blue: blue of candlelight is amplified
 * some forty times. Eyes adapt to a bounded degree. The display's vibrance makes 0.64 : 0.97 : 1.66 of it.
 */
const BESIDE_CANDLE: Rgb = [0.73, 0.965, 1.33];

/** What an adapted colour was before the adaptation to candlelight. */
function unadapted(color: Rgb): Rgb {
  const gain = adaptation(TAPER.color);
  return [color[0] / gain[0], color[1] / gain[1], color[2] / gain[2]];
}

/** Moonlight of some lux, before the adaptation to candlelight. */
export function adaptedMoonlight(illuminance: number): Rgb {
  const scale = illuminance / luma(BESIDE_CANDLE);
  const [red, green, blue] = unadapted(BESIDE_CANDLE);
  return [red * scale, green * scale, blue * scale];
}
