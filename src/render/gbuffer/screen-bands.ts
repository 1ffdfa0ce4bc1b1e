import { mat4 } from "gl-matrix";
import type { Box } from "../../gl/gpu.js";
import type { Size } from "../frame-input.js";

/** A horizontal band of an image: one of `count`, from the bottom up. */
export function bandOf({ width, height }: Size, band: number, count: number): Box {
  const edge = (at: number) => Math.round((at * height) / count);
  return [0, edge(band), width, edge(band + 1) - edge(band)];
}

/** Clip space of a band, from that of the image. */
export function clipOfBand([, y, , rows]: Box, { height }: Size, clip: mat4): mat4 {
  const narrow = mat4.clone(clip);
  const middle = (2 * y + rows) / height - 1;
  for (let column = 0; column < 4; column++) {
    const [up, w] = [clip[column * 4 + 1]!, clip[column * 4 + 3]!];
    narrow[column * 4 + 1] = ((up - middle * w) * height) / rows;
  }
  return narrow;
}
