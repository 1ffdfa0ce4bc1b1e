import { adaptation, luma, type Rgb } from "./color.js";
import { TAPER } from "./flame-light.js";

/**
 * Moonlight as an eye sees it that is used to a candle: adapted colour, luma 1.
 *
 * Of 4100 K, three channels adapted to a candle of 1900 K would make it a neon blue: blue of candlelight is amplified
 * some forty times. Eyes adapt to a bounded degree. The display's vibrance makes 0.64 : 0.97 : 1.66 of it.
 */
const BESIDE_CANDLE: Rgb = [0.73, 0.965, 1.33];

/** Weights of luma for radiance that was computed for white moonlight: those of Rec. 709 times its colour, 1 together. */
export function moonLuma(): Rgb {
  const color = adaptedMoonlight(1);
  const [red, green, blue] = color;
  const scale = 1 / luma(color);
  return [luma([red, 0, 0]) * scale, luma([0, green, 0]) * scale, luma([0, 0, blue]) * scale];
}

/** Radiance of a smoke's thread in a moonlit room for 1 lx outside, cd/m²: fitted, so that it shows against a black room. */
const SMOKE = 0.02;

/** Radiance, cd/m², that smoke and dust scatter in a room which moonlight enters, lx. */
export function scatteredMoonlight([red, green, blue]: Readonly<Rgb>): Rgb {
  return [SMOKE * red, SMOKE * green, SMOKE * blue];
}

/** Moonlight of some lux, before the adaptation to candlelight. */
export function adaptedMoonlight(illuminance: number): Rgb {
  const scale = illuminance / luma(BESIDE_CANDLE);
  const gain = adaptation(TAPER.color);
  const [red, green, blue] = BESIDE_CANDLE;
  return [(red / gain[0]) * scale, (green / gain[1]) * scale, (blue / gain[2]) * scale];
}
