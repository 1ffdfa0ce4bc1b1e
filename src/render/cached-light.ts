import type { Texture, UniformBlock } from "../gl/gpu.js";
import { luma, type Rgb } from "../light/color.js";
import type { Vec3 } from "../world/geometry.js";
import type { World } from "../world/world.js";
import type { IrradianceVolume } from "./gi/irradiance-volume.js";
import { type CaptureLight, flameIntensity } from "./light-block.js";
import type { VirtualLightTextures } from "./moon/virtual-lights.js";

/** Luminous intensity below which a flame's light is nothing beside the moon's, candela: of an ember at 726 K. */
const DARK = 1e-8;

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
  /** Of the moon, where it is all that shines. */
  readonly virtual: VirtualLightTextures | null;
  /** In this frame: candela, or lux. */
  readonly intensity: Rgb;
  /** Luminance where there is no surface, cd/m² for 1 cd or 1 lx. */
  readonly background: number;
  /** Of all that the block, the shadow and the irradiance depend on. */
  readonly key: string;
}

export function candlesOf(cached: readonly CachedLight[]): readonly CachedLight[] {
  return cached.filter(({ kind }) => kind === "candle");
}

/** Whether the carried flame is out, and its wick dark. */
export function isDark(world: World): boolean {
  return luma(flameIntensity(world)) < DARK;
}

export function hasStandingFlames({ standing }: World): boolean {
  return standing.some(({ flame }) => flame.glow > 0);
}

export function isUnlit(world: World): boolean {
  return isDark(world) && !hasStandingFlames(world);
}

export function isMoonAlone(world: World, cached: readonly CachedLight[]): boolean {
  return moonOf(cached) !== null && candlesOf(cached).length === 0 && isDark(world);
}

/** `CachedLight.key` of a moon whose light goes in a direction. */
export function moonKey(direction: Vec3): string {
  return JSON.stringify(direction);
}

/** Whether the moon among the lights is still that of another direction: a new one is prepared over many frames. */
export function isMoonOutdated({ moon }: World, cached: readonly CachedLight[]): boolean {
  const captured = moonOf(cached);
  return moon !== null && captured !== null && captured.key !== moonKey(moon.direction);
}

export function moonOf(cached: readonly CachedLight[]): CachedLight | null {
  return cached.find(({ kind }) => kind === "moon") ?? null;
}
