import sharp from "sharp";
import { flip, type Shown } from "../support/flip.ts";
import { BLOCKS, type Sight } from "./survey.ts";

/** How a sight differs from the reference's. */
export interface Difference {
  /** Mean over pixels and channels, of 255. */
  readonly mean: number;
  /** Mean FLIP. */
  readonly flip: number;
  /** The largest relative difference of a block's radiance. */
  readonly block: number;
  /** Which block that is, and how bright. */
  readonly where: string;
}

type Limits = Readonly<Record<"mean" | "flip" | "block", number>>;

const LIMITS: Limits = { mean: 2, flip: 0.03, block: 0.05 };

/**
 * FLIP of one level of 255 everywhere is 0.03 in dark pictures. Mesa's software renderer decodes sRGB by a polynomial
 * that is off by a third of a level, which exposure enlarges: with the same textures left undecoded in both, FLIP is
 * 0.017 (`original`) and 0.029 (`physical`) instead of 0.031 and 0.036.
 */
export const DECODED_LIMITS: Limits = { ...LIMITS, flip: 0.038 };

/** The physical look from medium on reads its surfaces anisotropically: llvmpipe (Mesa 22.3) leaves wrong texels there. */
export const ANISOTROPIC_LIMITS: Limits = { mean: 3, flip: 0.068, block: 0.12 };

/** One sample of four pixels, of which each normal is one texel: which sample and texel is the driver's choice. */
export const REDUCED_LIMITS: Limits = { ...LIMITS, flip: 0.065 };

/** As from medium on, at ultra, where a block of which the wick's tip gives nearly all light has other samples of it. */
export const ULTRA_LIMITS: Limits = { ...ANISOTROPIC_LIMITS, block: 0.2 };

/** Thin edges in strong light, of a moonlit sill: which samples they cover is the driver's choice. */
export const THIN_LIMITS: Limits = { ...LIMITS, block: 0.3 };

/** What passes, by the names of cases: the first that matches. */
export const CASE_LIMITS: readonly {
  readonly cases: RegExp;
  readonly title: string;
  readonly limits: Limits;
}[] = [
  {
    cases: /^(original|physical|four candles), low$/,
    title:
      "`original`, `physical` and four candles at `low`, where llvmpipe decodes sRGB differently",
    limits: DECODED_LIMITS,
  },
  {
    cases: /^physical, low, in motion$/,
    title: "`physical` at `low` in motion, where each driver has samples and texels of its own",
    limits: REDUCED_LIMITS,
  },
  {
    cases: /^(physical|four candles), (medium|high)(, in motion)?$/,
    title:
      "`physical` and four candles at `medium` and `high`, where llvmpipe's anisotropic filter leaves wrong texels",
    limits: ANISOTROPIC_LIMITS,
  },
  {
    cases: /^physical, ultra$/,
    title: "`physical` at `ultra`, where the samples of the wick's tip differ too",
    limits: ULTRA_LIMITS,
  },
  {
    cases: /^moon alone, medium, in motion$/,
    title: "the moon alone in motion, of the window's edges",
    limits: { ...THIN_LIMITS, block: 0.4 },
  },
  {
    cases: /^moon alone/,
    title: "the moon alone, where the samples of thin bright edges differ",
    limits: THIN_LIMITS,
  },
  { cases: /^/, title: "all others", limits: LIMITS },
];

/**
 * A block is compared with its own luminance, but at least with this much of all blocks' mean, since what is far
 * darker is black in the picture, or a glint of few pixels, and with this much of its brightest neighbour's, since
 * drivers have samples of their own at which the edge of a flame lies in the one block or the other.
 */
const FLOORS = { mean: 0.08, neighbour: 0.05 } as const;

export async function compare(reference: Sight, sight: Sight): Promise<Difference> {
  const [a, b] = await Promise.all([pixelsOf(reference.png), pixelsOf(sight.png)]);
  if (a.width !== b.width || a.height !== b.height) {
    throw new Error(`the picture is ${b.width} x ${b.height}, not ${a.width} x ${a.height}`);
  }
  const sum = a.data.reduce((sum, value, i) => sum + Math.abs(value - (b.data[i] ?? 0)), 0);
  const errors = flip(shownOf(a), shownOf(b));
  return {
    mean: sum / a.data.length,
    flip: errors.reduce((sum, error) => sum + error, 0) / errors.length,
    ...blockDifference(reference.blocks, sight.blocks),
  };
}

type Blocks = Sight["blocks"];

/** The largest difference of a block, and where that is. */
function blockDifference(reference: Blocks, blocks: Blocks): { block: number; where: string } {
  const expected = reference.map(luminance);
  const found = blocks.map(luminance);
  const mean = expected.reduce((sum, value) => sum + value, 0) / expected.length;
  const errors = found.map((value, i) => {
    const other = expected[i] ?? Number.NaN;
    const neighbour = Math.max(...neighboursOf(i).map((n) => expected[n] ?? 0));
    const floor = Math.max(FLOORS.mean * mean, FLOORS.neighbour * neighbour);
    return Math.abs(value - other) / Math.max(other, floor);
  });
  const block = Math.max(...errors);
  const i = errors.indexOf(block);
  const [x, y] = [i % BLOCKS.across, Math.floor(i / BLOCKS.across)];
  const numbers = [found[i], expected[i]].map((value) => value?.toPrecision(3));
  return { block, where: `at ${x}, ${y}: ${numbers[0]} cd/m² beside ${numbers[1]}` };
}

function neighboursOf(i: number): number[] {
  const [x, y] = [i % BLOCKS.across, Math.floor(i / BLOCKS.across)];
  const near = [-1, 0, 1];
  return near
    .flatMap((dy) => near.map((dx) => [x + dx, y + dy] as const))
    .filter(([x, y]) => x >= 0 && y >= 0 && x < BLOCKS.across && y < BLOCKS.down)
    .map(([x, y]) => y * BLOCKS.across + x);
}

const luminance = ([r = Number.NaN, g = Number.NaN, b = Number.NaN]: readonly number[]): number =>
  0.2126 * r + 0.7152 * g + 0.0722 * b;

interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Three bytes a pixel. */
  readonly data: Buffer;
}

/** How bright a picture is, of 255. */
export async function meanOf(png: Buffer): Promise<number> {
  const { data } = await pixelsOf(png);
  return data.reduce((sum, value) => sum + value, 0) / data.length;
}

/** A picture on white, where it is transparent. */
async function pixelsOf(png: Buffer): Promise<Pixels> {
  const { data, info } = await sharp(png)
    .flatten({ background: "#fff" })
    .raw()
    .toBuffer({ resolveWithObject: true });
  return { width: info.width, height: info.height, data };
}

function shownOf({ width, height, data }: Pixels): Shown {
  const linear = Float32Array.from(data, (value) => {
    const x = value / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  });
  return { width, height, linear };
}
