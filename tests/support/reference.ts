import { readdirSync, readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import type { Camera } from "../../src/candle-flame-element.ts";
import { luma } from "../../src/light/color.ts";
import { half } from "../../tools/reference/half.mjs";
import { stageView } from "../../tools/reference/stage.mjs";
import { colorOf } from "./display-transform.ts";
import type { RoomDriver } from "./room-driver.ts";

/** Camera, candles and moon of a view. */
interface Staging {
  readonly camera: Camera;
  /** Where the visitor stood to put the candle down; held if absent. */
  readonly place?: Camera;
  /** Candles that burn beside the carried one, by name; and whether that one is out. */
  readonly wicks?: readonly string[];
  readonly unlit?: boolean;
  readonly moon?: { readonly illuminance: number };
}

/** A view as a path tracer renders it; see docs/reference/README.md. */
export interface View extends Staging {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  /** One of `tools/reference/rooms.mjs`; the cabin if absent. */
  readonly room?: string;
  readonly flame: { readonly position: readonly [number, number, number] };
  readonly lamp: Readonly<Record<"halfHeight" | "radius", number>> & { intensity: number[] };
}

/** Those of the repository, or others that were traced: see docs/reference/README.md. */
const FOLDER = process.env.REFERENCES
  ? pathToFileURL(`${process.env.REFERENCES}/`)
  : new URL("../fixtures/reference/", import.meta.url);

export const tracedViews: readonly View[] = readdirSync(FOLDER)
  .filter((file) => file.endsWith(".bin"))
  .map((file) => JSON.parse(readFileSync(new URL(file.replace(".bin", ".json"), FOLDER), "utf8")));

/** Radiance, and which pixels show neither candle nor flame: there the sign of red is positive. */
export function readReference(name: string) {
  const bytes = readFileSync(new URL(`${name}.bin`, FOLDER));
  const radiance = Float32Array.from({ length: bytes.length / 2 }, (_, i) =>
    half(bytes.readUInt16LE(i * 2) & 0x7fff),
  );
  const isCompared = Array.from(
    { length: radiance.length / 3 },
    (_, pixel) => bytes.readUInt16LE(pixel * 6) < 0x8000,
  );
  return { radiance, isCompared };
}

/** Edge of the block of our pixels, in number, whose mean stands for one of the reference's. */
const SUPERSAMPLING = Number(process.env.SUPERSAMPLING ?? 1);
/** Of the element whose views are compared. */
export const VIEW_SIZE = { width: 320 * SUPERSAMPLING, height: 180 * SUPERSAMPLING };

/** Means of blocks of pixels. */
function averaged(radiance: Float32Array, width: number, height: number) {
  const size = { width: width / SUPERSAMPLING, height: height / SUPERSAMPLING };
  const means = new Float32Array(size.width * size.height * 3);
  for (const [i, value] of radiance.entries()) {
    const [x, y] = [Math.floor(i / 3) % width, Math.floor(i / 3 / width)];
    const [column, row] = [x, y].map((at) => Math.floor(at / SUPERSAMPLING)) as [number, number];
    means[(row * size.width + column) * 3 + (i % 3)]! += value / SUPERSAMPLING ** 2;
  }
  return { radiance: means, ...size };
}

/**
 * Our radiance of a view and where the flame is.
 *
 * @param hasFlame whether it is drawn: in a coarser frame it covers pixels that show none in the reference
 */
export async function renderView(room: RoomDriver, view: Staging, hasFlame = true) {
  const { radiance, ...rest } = await room.evaluate(
    (element, { view, stage, hasFlame }) => {
      element.features.volume = hasFlame;
      // biome-ignore lint/security/noGlobalEval: a function of ours, as text; in a task of its own it would be drawn twice
      globalThis.eval(`(${stage})`)(element, view);
      const { width, height } = element.stats;
      const radiance = element.readRadiance(0, 0, width, height);
      return { radiance, width, height, position: element.flame?.position };
    },
    { view, stage: `${stageView}`, hasFlame },
  );
  return { ...rest, ...averaged(radiance, rest.width, rest.height) };
}

export function quantile(values: readonly number[], share: number): number {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.floor(share * (sorted.length - 1))] ?? 0;
}

/** Relative errors of luminance: median, 90th percentile, and mean, signed. */
export interface Errors {
  readonly median: number;
  readonly high: number;
  readonly mean: number;
}

/**
 * Errors of our radiance beside a path tracer's, by means over blocks of so many of its pixels along each edge. Ours may
 * have another resolution.
 */
export function errorsBesideReference(
  { name, width, height }: View,
  mine: Readonly<Record<"width" | "height", number>> & { readonly radiance: Float32Array },
  block: number,
): Errors {
  const { radiance, isCompared } = readReference(name);
  const errors: number[] = [];
  const sums = { ours: 0, theirs: 0 };
  for (let top = 0; top < height; top += block) {
    for (let left = 0; left < width; left += block) {
      const means = { ours: 0, theirs: 0 };
      for (let y = top; y < Math.min(top + block, height); y++) {
        for (let x = left; x < Math.min(left + block, width); x++) {
          if (!isCompared[y * width + x]) continue;
          const column = Math.floor(((x + 0.5) / width) * mine.width);
          const row = Math.floor(((y + 0.5) / height) * mine.height);
          means.ours += luma(colorOf(mine.radiance, row * mine.width + column));
          means.theirs += luma(colorOf(radiance, y * width + x));
        }
      }
      if (means.theirs === 0) continue;
      errors.push(Math.abs(means.ours / means.theirs - 1));
      sums.ours += means.ours;
      sums.theirs += means.theirs;
    }
  }
  return {
    median: quantile(errors, 0.5),
    high: quantile(errors, 0.9),
    mean: sums.ours / sums.theirs - 1,
  };
}
