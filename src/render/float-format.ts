import type { Gpu, TextureFormat } from "../gl/gpu.js";
import { isSoftware } from "./quality.js";

const FULL = { 1: "R32F", 2: "RG32F", 4: "RGBA32F" } as const;
const HALF = { 1: "R16F", 2: "RG16F", 4: "RGBA16F" } as const;

/**
 * Format of intermediate targets for which half floats are precise enough.
 *
 * A software renderer reads full floats up to three times as fast as halves, which it converts one by one.
 */
export function floats(
  { renderer, filtersFloats, drawsToFloats }: Gpu,
  channels: 1 | 2 | 4,
): TextureFormat {
  const isFull = isSoftware(renderer) && filtersFloats && drawsToFloats;
  return (isFull ? FULL : HALF)[channels];
}
