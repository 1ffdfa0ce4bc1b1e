import type { Box } from "../../gl/gpu.js";
import type { Size } from "../frame-input.js";

/** Edge of a tile of the refined image, pixels. */
export const TILE = 64;

/**
 * Tiles of a frame, nearest first.
 *
 * @param from a point of the frame, shares of its width and height
 */
export function tilesAround(
  { width, height }: Size,
  from: readonly [number, number],
  edge = TILE,
): Box[] {
  const tiles: Box[] = [];
  for (let y = 0; y < height; y += edge) {
    for (let x = 0; x < width; x += edge) {
      tiles.push([x, y, Math.min(edge, width - x), Math.min(edge, height - y)]);
    }
  }
  const distance = ([x, y, wide, high]: Box) =>
    Math.hypot(x + wide / 2 - from[0] * width, y + high / 2 - from[1] * height);
  return tiles.sort((a, b) => distance(a) - distance(b));
}
