import type { Box } from "../../gl/gpu.js";
import type { Size } from "../frame-input.js";

/** A horizontal band of an image: one of `count`, from the bottom up. */
export function bandOf({ width, height }: Size, band: number, count: number): Box {
  const edge = (at: number) => Math.round((at * height) / count);
  return [0, edge(band), width, edge(band + 1) - edge(band)];
}
