/** Contrast of the tone curve around middle grey, that of film: candlelight without it looks like fog. */
const CONTRAST = 1.5;
/**
 * The same in the dark: where photons are few, what an eye can tell apart goes with about the square root of the light.
 * Rose 1948, "The Sensitivity Performance of the Human Eye on an Absolute Scale".
 */
const DARK_CONTRAST = 0.55;
/** Share of rod vision in a fully adapted eye. */
const RODS = 0.7;
/** Cones adapt first; then rods take over. Hecht, Haig and Chase 1937, "The Influence of Light Adaptation". */
const RODS_BEGIN = 0.25;
/** Steps of adaptation that display tables follow. */
const STEPS = 96;

/** Vision of an eye that is adapted to the dark by some share. */
export interface NightVision {
  readonly contrast: number;
  /** Share of rod vision, which has no hue. */
  readonly rods: number;
}

/** @param darkness adaptation to moonlight, 0 to 1 */
export function nightVision(darkness: number): NightVision {
  const share = Math.round(darkness * STEPS) / STEPS;
  const late = Math.min(Math.max((share - RODS_BEGIN) / (1 - RODS_BEGIN), 0), 1);
  return {
    contrast: CONTRAST + (DARK_CONTRAST - CONTRAST) * share,
    rods: RODS * late * late * (3 - 2 * late),
  };
}
