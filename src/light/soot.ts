import { LEAST_BLUE, luma, type Rgb } from "./color.js";

/**
 * Light of glowing soot, every 100 K from 1000 K to 2500 K: linear Rec. 709 with red at 1, and the
 * luminance of an opaque layer in cd/m².
 *
 * Soot particles are smaller than light is long, so that their emissivity goes as 1/λ (Rayleigh), and
 * their light is bluer than a black body's. Planck's law times 1/λ, against the tabulated CIE 1931
 * observer (the fit of Wyman, Sloan and Shirley 2013 is off by du'v' = 0.02 for embers). Blue below 0
 * is outside of the screen's colours; see `LEAST_BLUE`.
 */
const TABLE: readonly (readonly [green: number, blue: number, luminance: number])[] = [
  [0.0191, 0, 2.416],
  [0.0458, 0, 20.83],
  [0.0732, 0, 127.3],
  [0.1011, 0, 595.9],
  [0.1294, 0, 2256],
  [0.1577, 0, 7200],
  [0.1861, 0, 1.998e4],
  [0.2145, 0, 4.936e4],
  [0.2427, 0.0019, 1.106e5],
  [0.2708, 0.0117, 2.285e5],
  [0.2986, 0.0234, 4.397e5],
  [0.326, 0.0369, 7.966e5],
  [0.3532, 0.0521, 1.369e6],
  [0.3799, 0.069, 2.248e6],
  [0.4063, 0.0876, 3.546e6],
  [0.4322, 0.1078, 5.398e6],
];
const COLDEST = 1000;
const SPACING = 100;

/** Radiance of an opaque layer of soot: linear Rec. 709 whose luma is cd/m². Kelvin, 1000 to 2500. */
export function sootRadiance(temperature: number): Rgb {
  const place = Math.min(Math.max((temperature - COLDEST) / SPACING, 0), TABLE.length - 1.001);
  const index = Math.floor(place);
  const t = place - index;
  const [coldGreen, coldBlue, coldLuminance] = TABLE[index] ?? [0, 0, 0];
  const [hotGreen, hotBlue, hotLuminance] = TABLE[index + 1] ?? [0, 0, 0];
  const green = coldGreen + (hotGreen - coldGreen) * t;
  const blue = coldBlue + (hotBlue - coldBlue) * t;
  // Over 100 K luminance grows severalfold, and evenly so in its logarithm.
  const luminance = coldLuminance * (hotLuminance / coldLuminance) ** t;
  const rgb: Rgb = [1, green, Math.max(blue, LEAST_BLUE)];
  const scale = luminance / luma(rgb);
  return [rgb[0] * scale, rgb[1] * scale, rgb[2] * scale];
}
