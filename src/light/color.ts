/** Three numbers: linear Rec. 709, or CIE 1931 XYZ where a name says so. */
export type Rgb = readonly [red: number, green: number, blue: number];

/** A 3 x 3 matrix by rows. */
export type Rows = readonly [Rgb, Rgb, Rgb];

/**
 * CIE 1931 chromaticity that candlelight has for an adapted eye: that of a lamp of 3500 K. With illuminant A,
 * cloth, wood and stone look too much alike.
 */
const ADAPTED_WHITE = [0.4053, 0.3909] as const;

// IEC 61966-2-1, D65.
const XYZ_FROM_RGB: Rows = [
  [0.4124564, 0.3575761, 0.1804375],
  [0.2126729, 0.7151522, 0.072175],
  [0.0193339, 0.119192, 0.9503041],
];
const RGB_FROM_XYZ: Rows = [
  [3.2404542, -1.5371385, -0.4985314],
  [-0.969266, 1.8760108, 0.041556],
  [0.0556434, -0.2040259, 1.0572252],
];
/** Linear Display P3 (SMPTE EG 432-1, D65) of linear Rec. 709. */
export const P3_FROM_RGB: Rows = [
  [0.8224621, 0.177538, 0],
  [0.0331941, 0.9668058, 0],
  [0.0170827, 0.0723974, 0.9105199],
];
function apply(rows: Rows, [x, y, z]: Rgb): Rgb {
  return rows.map((row) => row[0] * x + row[1] * y + row[2] * z) as unknown as Rgb;
}

/** Luminance's weights of Rec. 709. */
export function luma([red, green, blue]: Rgb): number {
  return 0.2126729 * red + 0.7151522 * green + 0.072175 * blue;
}

/**
 * Least blue of a light, as a share of its red.
 *
 * Candlelight lies on the edge of Rec. 709, where blue is 0 and blue things could not differ from grey
 * ones. This little keeps them apart, and moves the light by less than du'v' = 0.003.
 */
export const LEAST_BLUE = 0.004;
/** Ratio of green to red below which soot has less blue still. */
const COOL = 0.2;

/** Blue of soot's light, in the unit of its red and green: almost none, or the tip would look salmon. */
export function sootBlue(red: number, green: number): number {
  return red > 0 ? LEAST_BLUE * red * Math.min(green / (COOL * red), 1) ** 6 : 0;
}

/**
 * Chromatic adaptation of linear Rec. 709, channel by channel (von Kries 1902): factors that turn candlelight
 * into a studio lamp's light. On candlelight they leave luma as it is.
 *
 * @param candle colour of the light, with luma 1
 *
 * Adapting in cone space (Bradford) would make up blue from red and green, and turns all wood salmon.
 */
export function adaptation(candle: Rgb): Rgb {
  const lamp = adaptedWhite();
  return [lamp[0] / candle[0], lamp[1] / candle[1], lamp[2] / candle[2]];
}

/** The adapted white of candlelight, with luma 1. */
export function adaptedWhite(): Rgb {
  const [x, y] = ADAPTED_WHITE;
  return apply(RGB_FROM_XYZ, [x / y, 1, (1 - x - y) / y]);
}

/** How much further than in nature a faint hue is shown from white; see shaders/lib/chromatic-adaptation.glsl. */
export const VIBRANCE = 1.6;

/** CIE 1976 u'v' of linear Rec. 709. */
export function chromaticity(rgb: Rgb): readonly [u: number, v: number] {
  const [x, y, z] = apply(XYZ_FROM_RGB, rgb);
  const sum = x + 15 * y + 3 * z;
  return [(4 * x) / sum, (9 * y) / sum];
}
