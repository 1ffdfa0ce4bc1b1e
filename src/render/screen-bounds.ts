import { mat4 } from "gl-matrix";
import type { Box } from "../gl/gpu.js";
import type { Vec3 } from "../world/geometry.js";
import { clipPosition } from "./camera.js";
import type { FrameInput, Size } from "./frame-input.js";

/** A bounding sphere: x, y, z, radius, metres. */
export type Sphere = readonly [number, number, number, number];

/** Points nearer than this along the view axis may project anywhere, metres. */
const NEAREST = 0.01;

/** Height that a pixel has at a point's distance along the view axis, metres. */
export function pixelSize([x, y, z]: Readonly<Vec3>, clip: mat4, { height }: Size): number {
  const [, , w] = clipPosition(clip, x, y, z);
  return (2 * Math.max(w, NEAREST)) / (Math.hypot(clip[1], clip[5], clip[9]) * height);
}

/** Edges of the projected cubes around spheres, pixels; null where they are unbounded. */
export function projectedExtent(spheres: Iterable<Sphere>, clip: mat4, { width, height }: Size) {
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y, z, radius] of spheres) {
    for (let corner = 0; corner < 8; corner++) {
      const offset = (axis: number) => ((corner >> axis) & 1 ? radius : -radius);
      const [across, up, w] = clipPosition(clip, x + offset(0), y + offset(1), z + offset(2));
      if (w < NEAREST) return null;
      left = Math.min(left, (0.5 + (0.5 * across) / w) * width);
      right = Math.max(right, (0.5 + (0.5 * across) / w) * width);
      bottom = Math.min(bottom, (0.5 + (0.5 * up) / w) * height);
      top = Math.max(top, (0.5 + (0.5 * up) / w) * height);
    }
  }
  return { left, bottom, right, top };
}

/**
 * Bounding box of spheres on the frame: whole cells, and one more on each side. Null where none of them is on the frame.
 *
 * @param margin around the spheres, pixels
 * @param cell edge of a cell, pixels
 */
export function screenBounds(
  spheres: Iterable<Sphere>,
  clip: mat4,
  { width, height }: Size,
  { margin, cell }: { readonly margin: number; readonly cell: number },
): Box | null {
  const isAhead = ([x, y, z, radius]: Sphere) =>
    clipPosition(clip, x, y, z)[2] + Math.sqrt(3) * radius > NEAREST;
  const ahead = [...spheres].filter(isAhead);
  if (ahead.length === 0) return null;
  const extent = projectedExtent(ahead, clip, { width, height });
  if (!extent) return [0, 0, width, height];
  const { left, right, bottom, top } = extent;
  if (Math.max(left - width, bottom - height, -right, -top) > margin) return null;
  const begin = (at: number, length: number) =>
    Math.min(Math.max((Math.floor((at - margin) / cell) - 1) * cell, 0), length - 1);
  const end = (at: number, from: number, length: number) =>
    Math.min(Math.max((Math.ceil((at + margin) / cell) + 1) * cell, from + 1), length);
  const [x, y] = [begin(extent.left, width), begin(extent.bottom, height)];
  return [x, y, end(extent.right, x, width) - x, end(extent.top, y, height) - y];
}

/**
 * Distance from the flame, or from the candle below it, within which surfaces are drawn again with each step of the
 * light, metres.
 */
const NEAR = 0.12;

/** Bounds on the frame of what is near the flame, pixels; null where that is off the frame. */
export function boundsNearFlame({ world, clipFromWorld }: FrameInput, size: Size): Box | null {
  const [x, y, z] = world.interpolated.flame;
  return screenBounds([[x, y - 0.5 * NEAR, z, NEAR]], clipFromWorld, size, { margin: 0, cell: 8 });
}

/** Bounding box of boxes; nothing where there is none. */
export function boundsOf(boxes: readonly Box[]): Box {
  if (boxes.length === 0) return [0, 0, 0, 0];
  const left = Math.min(...boxes.map(([x]) => x));
  const bottom = Math.min(...boxes.map(([, y]) => y));
  const right = Math.max(...boxes.map(([x, , width]) => x + width));
  const top = Math.max(...boxes.map(([, y, , height]) => y + height));
  return [left, bottom, right - left, top - bottom];
}

/** Boxes that cover the same pixels, where those that overlap are one. */
export function mergeOverlapping(boxes: readonly Box[]): Box[] {
  const merged: Box[] = [];
  for (let box of boxes) {
    for (let i = 0; i < merged.length; i++) {
      if (!overlaps(merged[i]!, box)) continue;
      box = boundsOf([box, ...merged.splice(i, 1)]);
      i = -1; // it may now overlap earlier ones
    }
    merged.push(box);
  }
  return merged;
}

function overlaps([x, y, width, height]: Box, [u, v, wide, high]: Box): boolean {
  return x < u + wide && u < x + width && y < v + high && v < y + height;
}

/** A box expanded by a number of pixels on each side that is no edge of the frame; negative to shrink. */
export function expandBox([x, y, wide, high]: Box, by: number, { width, height }: Size): Box {
  const [left, bottom] = [x === 0 ? 0 : Math.max(x - by, 0), y === 0 ? 0 : Math.max(y - by, 0)];
  const right = x + wide === width ? width : Math.min(x + wide + by, width);
  const top = y + high === height ? height : Math.min(y + high + by, height);
  return [left, bottom, right - left, top - bottom];
}

/** Boxes expanded on each side; those that then overlap are one. */
export function expandBoxes(boxes: readonly Box[], by: number, size: Size): Box[] {
  return mergeOverlapping(boxes.map((box) => expandBox(box, by, size)));
}

/** The pixels that a box touches at another resolution. */
export function scaleBox([x, y, wide, high]: Box, from: Size, to: Size): Box {
  const [across, up] = [to.width / from.width, to.height / from.height];
  const [left, bottom] = [Math.floor(x * across), Math.floor(y * up)];
  const [right, top] = [Math.ceil((x + wide) * across), Math.ceil((y + high) * up)];
  return [left, bottom, Math.min(right, to.width) - left, Math.min(top, to.height) - bottom];
}

/** Clip space of a box on a frame, from that of the frame. */
export function clipOfBox([x, y, wide, high]: Box, { width, height }: Size, clip: mat4): mat4 {
  const narrow = mat4.clone(clip);
  const axes = [
    { middle: (2 * x + wide) / width - 1, factor: width / wide },
    { middle: (2 * y + high) / height - 1, factor: height / high },
  ];
  for (let column = 0; column < 4; column++) {
    const w = clip[column * 4 + 3]!;
    for (const [axis, { middle, factor }] of axes.entries()) {
      narrow[column * 4 + axis] = (clip[column * 4 + axis]! - middle * w) * factor;
    }
  }
  return narrow;
}

/** A horizontal band of an image: one of `count`, from the bottom up. */
export function bandOf(size: Size, band: number, count: number): Box {
  return tiles(size, { rows: count, columns: 1 })[band]!;
}

export function tiles(
  { width, height }: Size,
  { rows, columns }: Readonly<Record<"rows" | "columns", number>>,
): Box[] {
  const edge = (length: number, count: number, i: number) => Math.round((length * i) / count);
  return Array.from({ length: rows * columns }, (_, i) => {
    const [row, column] = [Math.floor(i / columns), i % columns];
    const [x, y] = [edge(width, columns, column), edge(height, rows, row)];
    return [x, y, edge(width, columns, column + 1) - x, edge(height, rows, row + 1) - y];
  });
}

/** The frame without boxes that are apart from each other, as boxes. */
export function boxesBeside(boxes: readonly Box[], { width, height }: Size): Box[] {
  const edges = [0, height, ...boxes.flatMap(([, y, , high]) => [y, y + high])];
  const rows = [...new Set(edges)].sort((a, b) => a - b);
  const rest: Box[] = [];
  for (const [i, y] of rows.slice(0, -1).entries()) {
    const high = rows[i + 1]! - y;
    const inRow = boxes.filter((box) => box[1] <= y && y < box[1] + box[3]);
    let x = 0;
    for (const [left, , wide] of inRow.toSorted(([a], [b]) => a - b)) {
      if (left > x) rest.push([x, y, left - x, high]);
      x = Math.max(x, left + wide);
    }
    if (x < width) rest.push([x, y, width - x, high]);
  }
  return rest;
}

export function wholeOf({ width, height }: Size): Box {
  return [0, 0, width, height];
}
