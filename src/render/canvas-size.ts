interface Size {
  readonly width: number;
  readonly height: number;
}

/**
 * More than a screen of 5120 x 2880 has. Larger boxes are drawn coarser: what a frame of 10,000 x 10,000
 * needs no GPU holds, and the context would be lost over it.
 */
const MOST_PIXELS = 4096 ** 2;

/**
 * Pixels of the canvas in a box, at least one each way.
 *
 * @param box device pixels
 * @param scale canvas pixels per device pixel, as asked for
 * @param longestSide that the GPU can draw, pixels
 */
export function canvasSize({ width, height }: Size, scale: number, longestSide: number): Size {
  const held = Math.min(
    scale,
    longestSide / Math.max(width, height),
    Math.sqrt(MOST_PIXELS / (width * height)),
  );
  return {
    width: Math.max(1, Math.round(width * held)),
    height: Math.max(1, Math.round(height * held)),
  };
}
