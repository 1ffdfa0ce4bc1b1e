import type { Texture } from "../gl/texture.js";
import type { UniformBlock } from "../gl/uniform-block.js";
import type { Rgb } from "../light/color.js";
import type { IrradianceVolume } from "./gi/indirect-pass.js";
import type { CaptureLight } from "./light-block.js";

/** A light beside the carried flame. Its shadow and irradiance are captured once, for 1 cd or 1 lx of it. */
export interface CachedLight {
  readonly kind: "moon" | "candle";
  readonly name: string;
  /** Members of a candle's block. */
  readonly light: CaptureLight | null;
  /** `Light` or `Moon`, of 1 cd or 1 lx. */
  readonly block: UniformBlock;
  readonly shadow: Texture;
  readonly irradiance: IrradianceVolume;
  /** In this frame: candela, or lux. */
  readonly intensity: Rgb;
  /** Luminance where there is no surface, cd/m² for 1 cd or 1 lx. */
  readonly background: number;
  /** Of all that the block, the shadow and the irradiance depend on. */
  readonly key: string;
}

/** The standing candles among the cached lights. */
export function candlesOf(cached: readonly CachedLight[]): readonly CachedLight[] {
  return cached.filter(({ kind }) => kind === "candle");
}

/** The moon among the cached lights. */
export function moonOf(cached: readonly CachedLight[]): CachedLight | null {
  return cached.find(({ kind }) => kind === "moon") ?? null;
}
