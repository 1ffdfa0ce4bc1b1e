import type { Gpu } from "../gl/gpu.js";
import type { TextureFormat } from "../gl/texture.js";
import { isSoftware } from "./quality.js";

const FULL = { 1: "R32F", 2: "RG32F", 4: "RGBA32F" } as const;
const HALF = { 1: "R16F", 2: "RG16F", 4: "RGBA16F" } as const;

/**
 * The format of what one pass leaves for the next, where half floats are precise enough.
 *
 * A CPU has to make floats of halves one by one: it reads full ones up to three times as fast.
 */
export function floats(
  { renderer, filtersFloats, drawsToFloats }: Gpu,
  channels: 1 | 2 | 4,
): TextureFormat {
  const isFull = isSoftware(renderer) && filtersFloats && drawsToFloats;
  return (isFull ? FULL : HALF)[channels];
}
