import { luma, type Rgb, sootBlue } from "./color.js";
import { sootRadiance } from "./soot.js";

/** Texels of the body: radius by height. */
export const BODY_SIZE = { width: 64, height: 128 } as const;
/** The table reaches this far beyond the luminous edge, in radii: the blue cup hugs the outside. */
export const BODY_REACH = 1.25;

/** Hottest soot, kelvin: two-colour pyrometry of candles finds 1670 to 1800. */
const HOTTEST = 1750;
/** Colour of the base's CH* and C2* bands, linear Rec. 709 with luma 1. */
export const BLUE: Rgb = [0.2, 1.05, 2.9];
/** Luminance of the blue cup seen edge-on against that of the brightest soot. */
const BLUE_SHARE = 0.00002;

/**
 * A candle flame at rest, as a figure of revolution.
 *
 * A laminar sheet, not a turbulent fire: a shell of soot that is thin and hollow below and closes to
 * the axis above, a dark zone round the wick, and a blue cup that hugs the outside of the base.
 */
export type FlameBody = Readonly<ReturnType<typeof flameBody>>;

const smooth = (low: number, high: number, x: number): number => {
  const t = Math.min(Math.max((x - low) / (high - low), 0), 1);
  return t * t * (3 - 2 * t);
};

/** Outline: radius over height, both as shares. A teardrop, widest at a third of its height. */
export function outline(height: number): number {
  const below = Math.sin(Math.min(height / 0.34, 1) * (Math.PI / 2)) ** 0.55;
  const above = height < 0.34 ? 1 : (1 - ((height - 0.34) / 0.66) ** 1.75) ** 1.05;
  return 0.12 + 0.88 * below * Math.max(above, 0) - 0.12 * smooth(0.3, 1, height);
}

/** Soot, temperature in kelvin and blue light at a height and a radius, both as shares. */
function at(height: number, radius: number) {
  // The shell: where fuel meets air. Low it is thin and at the rim; the hollow closes by 0.55.
  const hollow = 1 - smooth(0.12, 0.58, height);
  const middle = 0.8 * hollow;
  const thickness = 0.17 + 0.75 * (1 - hollow);
  const shell = Math.exp(-(((radius - middle) / thickness) ** 2));
  const edge = 1 - smooth(0.62, 1.0, radius);
  const rise = smooth(0.08, 0.4, height) * (1 - 0.6 * smooth(0.75, 1.0, height));
  const soot = shell * edge * rise;
  const temperature =
    HOTTEST - 170 * (1 - smooth(0.3, 0.9, radius)) * hollow - 190 * smooth(0.75, 1, height);
  const cup =
    Math.exp(-(((radius - 0.88) / 0.12) ** 2)) *
    (1 - smooth(0.95, 1.2, radius)) *
    smooth(0, 0.03, height) *
    (1 - smooth(0.1, 0.3, height));
  return { soot, temperature, cup };
}

/**
 * Bakes the body of a flame.
 *
 * @param height metres from base to tip
 * @param radius largest radius of the luminous zone, metres
 * @param luminousIntensity candela, equal in all horizontal directions, as the flame is nearly transparent
 */
export function flameBody(height: number, radius: number, luminousIntensity: number) {
  const { width, height: rows } = BODY_SIZE;
  const texels = new Float32Array(width * rows * 4);
  const sootRows = new Float64Array(rows);
  const blueRows = new Float64Array(rows);
  let [red, green, faintBlue, moment] = [0, 0, 0, 0];
  const hottest = luma(sootRadiance(HOTTEST));
  for (let row = 0; row < rows; row++) {
    const t = (row + 0.5) / rows;
    const outer = radius * outline(t);
    for (let column = 0; column < width; column++) {
      const relativeRadius = ((column + 0.5) / width) * BODY_REACH;
      const { soot, temperature, cup } = at(t, relativeRadius);
      const glow = sootRadiance(temperature);
      const i = (row * width + column) * 4;
      const ring =
        2 * Math.PI * (relativeRadius * outer) * ((outer * BODY_REACH) / width) * (height / rows);
      texels[i] = soot * glow[0];
      texels[i + 1] = soot * glow[1];
      texels[i + 2] = soot;
      texels[i + 3] = cup * BLUE_SHARE * hottest;
      const faint = sootBlue(glow[0], glow[1]);
      red += soot * glow[0] * ring;
      green += soot * glow[1] * ring;
      sootRows[row] = (sootRows[row] ?? 0) + soot * luma([glow[0], glow[1], faint]) * ring;
      faintBlue += soot * faint * ring;
      blueRows[row] = (blueRows[row] ?? 0) + cup * BLUE_SHARE * hottest * ring;
    }
    moment += ((sootRows[row] ?? 0) + (blueRows[row] ?? 0)) * t * height;
  }
  const blue = sum(blueRows);
  const soot = sum(sootRows);
  const total = soot + blue;
  // Emission integrated over the volume is intensity: scaled, it is the one asked for. By Kirchhoff's law absorption
  // is emission over that of a black body: it scales in proportion.
  const scale = luminousIntensity / total;
  for (let i = 0; i < texels.length; i++) texels[i] = (texels[i] ?? 0) * scale;
  for (let row = 0; row < rows; row++) {
    sootRows[row] = (sootRows[row] ?? 0) * scale;
    blueRows[row] = (blueRows[row] ?? 0) * scale;
  }
  const sootRgb: Rgb = [red / soot, green / soot, faintBlue / soot];
  const mixed = (channel: 0 | 1 | 2) => (sootRgb[channel] * soot + BLUE[channel] * blue) / total;
  const color: Rgb = [mixed(0), mixed(1), mixed(2)];
  return {
    /**
     * Over height (rows, base to tip) and radius (columns, axis to `BODY_REACH` radii): soot's emission per metre, red
     * and green (cd/m² per m, linear Rec. 709; its blue is `sootBlue`); its absorption, 1/m; luminance of the blue
     * bands, cd/m² per m.
     */
    texels,
    /** As `flameBody` was given them. */
    height,
    radius,
    luminousIntensity,
    /** Linear Rec. 709 with luma 1: of the whole, and of soot alone. */
    color,
    sootColor: sootRgb,
    /** Height of the centre of the light above the base, metres. */
    centre: moment / total,
    /** Luminous intensity of each row, cd: of its soot, and of its blue bands. They add up to the whole. */
    sootRows,
    blueRows,
  };
}

function sum(values: Float64Array): number {
  return values.reduce((total, value) => total + value, 0);
}
