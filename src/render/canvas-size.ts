import type { Gpu } from "../gl/gpu.js";
import type { Size } from "./frame-input.js";
import type { Tier } from "./quality.js";

/**
 * Limit of the canvas, more than a screen of 5120 x 2880 has. Larger boxes are drawn at a lower resolution: no GPU has
 * the memory for a frame of 10,000 x 10,000, and the context would be lost.
 */
const MOST_PIXELS = 4096 ** 2;

/** Longest side of a tier's frames: samples of the deferred stage's G-buffer lie side by side, two along each axis. */
export function longestSide(gpu: Pick<Gpu, "longestSide">, { physical }: Tier): number {
  return physical.opaque === "deferred" ? gpu.longestSide / 2 : gpu.longestSide;
}

/**
 * Size of the canvas in a box, at least one pixel each way.
 *
 * @param box device pixels
 * @param scale canvas pixels per device pixel, before limits
 * @param longestSide limit of the GPU, pixels
 */
export function canvasSize({ width, height }: Size, scale: number, longestSide: number): Size {
  const limited = Math.min(
    scale,
    longestSide / Math.max(width, height),
    Math.sqrt(MOST_PIXELS / (width * height)),
  );
  return {
    width: Math.max(1, Math.round(width * limited)),
    height: Math.max(1, Math.round(height * limited)),
  };
}
