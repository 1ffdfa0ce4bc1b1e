import { WORK, type Work } from "../render/auto-quality.js";
import type { FrameSettings } from "../render/frame-settings.js";
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

/** Settings of a frame, but for what the view knows itself. */
export type ViewFrame = Omit<FrameSettings, "gamut" | "inspect">;

/** Work of a scene's frame, by which `auto` predicts its time. */
export function workOf({ isModelAlone, first }: Scene, { look }: ViewSettings): Work {
  if (isModelAlone) return first ? WORK.own : WORK.alone;
  return look === "physical" ? WORK.physical : WORK.plain;
}
