import type { AutoQuality, Rung } from "../render/auto-quality.js";
import { type Tier, tierNamed } from "../render/quality.js";
import type { Inspection, Quality } from "../settings.js";

/** Where `low` would draw. */
const INSPECTION_RUNG: Rung = { tier: "medium", share: 1 };
/** The same while frames of a CPU follow each other, each of which would take a second. */
const QUICK_INSPECTION_RUNG: Rung = { tier: "medium", share: 0.35 };

/** How frames are drawn. */
export type AskedQuality = Readonly<ReturnType<typeof askedQuality>>;

/** Settings of a tier; `auto` filters anisotropically only where that was measured to be cheap. */
export function tierOf(name: Tier["name"], quality: Quality, auto: AutoQuality): Tier {
  const { anisotropy, ...rest } = tierNamed(name);
  return { ...rest, anisotropy: anisotropy && (quality !== "auto" || auto.allowsAnisotropy) };
}

/** Tier of the next frame, and share of the tier's resolution. */
export function askedQuality(
  quality: Quality,
  auto: AutoQuality,
  isPlaying: boolean,
  inspect: Inspection,
) {
  const automatic = isPlaying ? auto.rung : auto.stillRung;
  const chosen: Rung = quality === "auto" ? automatic : { tier: quality, share: 1 };
  // `low` has no separate passes to inspect.
  const isLow = (quality === "auto" ? auto.rung.tier : quality) === "low";
  const isQuick = quality === "auto" && isPlaying && auto.isSoftware;
  const inspecting = isQuick ? QUICK_INSPECTION_RUNG : INSPECTION_RUNG;
  const { tier, share } = isLow && inspect !== "picture" ? inspecting : chosen;
  return { tier: tierOf(tier, quality, auto), share };
}
