import type { AutoQuality, Rung } from "../render/auto-quality.js";
import { type Tier, tierNamed } from "../render/quality.js";
import type { Inspection, Quality } from "../settings.js";

const INSPECTION_RUNG: Rung = { tier: "medium", share: 1 };

/** How frames are drawn. */
export interface AskedQuality {
  readonly tier: Tier;
  /** Of the tier's resolution. */
  readonly share: number;
}

/** Settings of a tier; `auto` filters anisotropically only where that was measured to be cheap. */
export function tierOf(name: Tier["name"], quality: Quality, auto: AutoQuality): Tier {
  const { anisotropy, ...rest } = tierNamed(name);
  return { ...rest, anisotropy: anisotropy && (quality !== "auto" || auto.allowsAnisotropy) };
}

/** Tier and resolution of the next frame. */
export function askedQuality(
  quality: Quality,
  auto: AutoQuality,
  isPlaying: boolean,
  inspect: Inspection,
): AskedQuality {
  const { tier, share } = rungOf(quality, auto, isPlaying, inspect);
  return { tier: tierOf(tier, quality, auto), share };
}

function rungOf(
  quality: Quality,
  auto: AutoQuality,
  isPlaying: boolean,
  inspect: Inspection,
): Rung {
  const isLow = quality === "low" || (quality === "auto" && auto.rung.tier === "low");
  // `low` has no separate passes to inspect.
  if (inspect !== "picture" && isLow) return INSPECTION_RUNG;
  if (quality !== "auto") return { tier: quality, share: 1 };
  return isPlaying ? auto.rung : auto.stillRung;
}
