/** Three numbers: linear Rec. 709, or CIE 1931 XYZ where a name says so. */
export type Rgb = readonly [red: number, green: number, blue: number];

/** A 3 x 3 matrix by rows. */
type Rows = readonly [Rgb, Rgb, Rgb];

/** CIE 1931 chromaticity of a candle's light: Planckian, 1875 K. */
export const CANDLE_WHITE = [0.5405, 0.4105] as const;
/** CIE 1931 chromaticity of illuminant A: the tungsten lamp that eyes and screens take for warm white. */
export const ILLUMINANT_A = [0.4476, 0.4075] as const;

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
// Lam 1985, "Metamerism and Colour Constancy" (Bradford).
const CONE_FROM_XYZ: Rows = [
  [0.8951, 0.2664, -0.1614],
  [-0.7502, 1.7135, 0.0367],
  [0.0389, -0.0685, 1.0296],
];
const XYZ_FROM_CONE: Rows = [
  [0.9869929, -0.1470543, 0.1599627],
  [0.4323053, 0.5183603, 0.0492912],
  [-0.0085287, 0.0400428, 0.9684867],
];

function apply(rows: Rows, [x, y, z]: Rgb): Rgb {
  return rows.map((row) => row[0] * x + row[1] * y + row[2] * z) as unknown as Rgb;
}

function xyzOf([x, y]: readonly [number, number]): Rgb {
  return [x / y, 1, (1 - x - y) / y];
}

/** Luminance's weights of Rec. 709. */
export function luma([red, green, blue]: Rgb): number {
  return 0.2126729 * red + 0.7151522 * green + 0.072175 * blue;
}

/**
 * Chromatic adaptation of linear Rec. 709: what `from` lit looks as if `to` had lit it.
 *
 * @param from CIE 1931 xy of the light that is there
 * @param to CIE 1931 xy of the light that the eye is to believe in
 * @returns a 3 x 3 matrix by columns, for GLSL
 */
export function adaptation(
  from: readonly [number, number],
  to: readonly [number, number],
): Float32Array {
  const source = apply(CONE_FROM_XYZ, xyzOf(from));
  const destination = apply(CONE_FROM_XYZ, xyzOf(to));
  const columns = ([0, 1, 2] as const).flatMap((axis) => {
    const unit: Rgb = [Number(axis === 0), Number(axis === 1), Number(axis === 2)];
    const cone = apply(CONE_FROM_XYZ, apply(XYZ_FROM_RGB, unit));
    const adapted: Rgb = [
      (cone[0] * destination[0]) / source[0],
      (cone[1] * destination[1]) / source[1],
      (cone[2] * destination[2]) / source[2],
    ];
    return [...apply(RGB_FROM_XYZ, apply(XYZ_FROM_CONE, adapted))];
  });
  return Float32Array.from(columns);
}

/** CIE 1976 u'v' of linear Rec. 709. */
export function chromaticity(rgb: Rgb): readonly [u: number, v: number] {
  const [x, y, z] = apply(XYZ_FROM_RGB, rgb);
  const sum = x + 15 * y + 3 * z;
  return [(4 * x) / sum, (9 * y) / sum];
}
