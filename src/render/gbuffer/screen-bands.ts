import { mat4 } from "gl-matrix";
import type { Box } from "../../gl/gpu.js";

/** Pixels of a picture. */
interface Size {
  readonly width: number;
  readonly height: number;
}

/** One of so many stripes of a picture, from its bottom up; together they are all of it. */
export function bandOf({ width, height }: Size, stripe: number, stripes: number): Box {
  const edge = (at: number) => Math.round((at * height) / stripes);
  return [0, edge(stripe), width, edge(stripe + 1) - edge(stripe)];
}

/** Clip space of a stripe alone, from that of the picture. */
export function clipOfBand([, y, , rows]: Box, { height }: Size, clip: mat4): mat4 {
  const narrow = mat4.clone(clip);
  const middle = (2 * y + rows) / height - 1;
  for (let column = 0; column < 4; column++) {
    const [up, w] = [clip[column * 4 + 1]!, clip[column * 4 + 3]!];
    narrow[column * 4 + 1] = ((up - middle * w) * height) / rows;
  }
  return narrow;
}
