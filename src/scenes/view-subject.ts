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
 * What all light of the image is proportional to: the carried flame, as whose moonlight counts while it burns; or the
 * moon, once the eye is used to it. Null if to neither.
 */
export function onlyLight({ flame, standing, moon, adaptation }: World): "flame" | "moon" | null {
  if (standing.some((candle) => candle.flame.glow > 0)) return null;
  if (moon === null || flame.glow > BURNING) return "flame";
  return flame.glow === 0 && adaptation.darkness === 1 ? "moon" : null;
}
