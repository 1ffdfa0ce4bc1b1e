import type { mat4 } from "gl-matrix";
import type { Box } from "../gl/gpu.js";
import { clipPosition } from "./camera.js";
import type { Ball } from "./volumetric/smoke-pass.js";

/** Pixels of a picture. */
interface Size {
  readonly width: number;
  readonly height: number;
}

/** How a box is drawn around what is seen, pixels. */
interface Fit {
  /** Left free around it. */
  readonly margin: number;
  /** The box is of whole cells that are so wide, one more on each side. */
  readonly cell: number;
}

/** The pixels that cover balls (x, y, z, radius: metres) in a picture seen through `clip`. */
export function screenBounds(
  balls: Iterable<Ball>,
  clip: mat4,
  { width, height }: Size,
  { margin, cell }: Fit,
): Box {
  let [left, bottom, right, top] = [width, height, 0, 0];
  for (const [x, y, z, reach] of balls) {
    for (let corner = 0; corner < 8; corner++) {
      const aside = (axis: number) => ((corner >> axis) & 1 ? reach : -reach);
      const [across, up, w] = clipPosition(clip, x + aside(0), y + aside(1), z + aside(2));
      // Beside the eye it may be anywhere.
      if (w < 0.01) return [0, 0, width, height];
      left = Math.min(left, (0.5 + (0.5 * across) / w) * width);
      right = Math.max(right, (0.5 + (0.5 * across) / w) * width);
      bottom = Math.min(bottom, (0.5 + (0.5 * up) / w) * height);
      top = Math.max(top, (0.5 + (0.5 * up) / w) * height);
    }
  }
  const begin = (at: number, length: number) =>
    Math.min(Math.max((Math.floor((at - margin) / cell) - 1) * cell, 0), length - 1);
  const end = (at: number, from: number, length: number) =>
    Math.min(Math.max((Math.ceil((at + margin) / cell) + 1) * cell, from + 1), length);
  const [x, y] = [begin(left, width), begin(bottom, height)];
  return [x, y, end(right, x, width) - x, end(top, y, height) - y];
}

/** A box with so many pixels more on each side, or less, but for the edges of the picture. */
export function expandBox([x, y, wide, high]: Box, by: number, { width, height }: Size): Box {
  const [left, bottom] = [x === 0 ? 0 : Math.max(x - by, 0), y === 0 ? 0 : Math.max(y - by, 0)];
  const right = x + wide === width ? width : Math.min(x + wide + by, width);
  const top = y + high === height ? height : Math.min(y + high + by, height);
  return [left, bottom, right - left, top - bottom];
}

/** The pixels of another picture of the same that a box touches. */
export function scaleBox([x, y, wide, high]: Box, from: Size, to: Size): Box {
  const [across, up] = [to.width / from.width, to.height / from.height];
  const [left, bottom] = [Math.floor(x * across), Math.floor(y * up)];
  const [right, top] = [Math.ceil((x + wide) * across), Math.ceil((y + high) * up)];
  return [left, bottom, Math.min(right, to.width) - left, Math.min(top, to.height) - bottom];
}
