import { WORK, type Work } from "../render/auto-quality.js";
import type { Look, Quality } from "../settings.js";
import type { MoonWish } from "../world/moon.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import type { World } from "../world/world.js";
import type { Scene } from "./scene.js";

export interface ViewSettings {
  readonly look: Look;
  readonly quality: Quality;
  readonly moon: MoonWish;
}

/** The world that a view draws, and its particles. */
export interface ViewSubject {
  readonly world: World;
  readonly layers: readonly ParticleLayer[];
}

/** Work of a scene's frame, by which `auto` predicts its time. */
export function workOf({ isModelAlone }: Scene, { look }: ViewSettings): Work {
  return look === "physical" && !isModelAlone ? WORK.physical : WORK.plain;
}

/** Least share of its light with which a flame burns well. */
const BURNING = 0.05;

/**
 * Whether all light of the image is proportional to the carried flame's. Moonlight is treated so while the flame
 * burns.
 */
export function hasOneFlame({ flame, standing, moon }: World): boolean {
  if (standing.some((candle) => candle.flame.glow > 0)) return false;
  return moon === null || flame.glow > BURNING;
}
