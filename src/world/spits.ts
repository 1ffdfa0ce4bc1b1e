import { pcg, unit } from "./random.js";

/** Time is cut into spans of this many ticks, and in one of so many the wick spits. */
const SPAN = 480;
const ODDS = 6;
/** Ticks that a spit lasts: fewest, and how many more at most. */
const SHORTEST = 2;
const LONGER = 4;

/**
 * Whether water in the wick boils and throws burning wax at this tick: about every twenty-four seconds, by
 * the seed's chance, whatever else happens.
 */
export function isSpitting(seed: number, tick: number): boolean {
  const span = Math.floor(tick / SPAN);
  const chance = pcg((pcg((seed ^ 0x5b17) >>> 0) + span) >>> 0);
  if (unit(chance) * ODDS >= 1) return false;
  const lasts = SHORTEST + Math.round(unit(pcg((chance + 1) >>> 0)) * LONGER);
  const begin = Math.floor(unit(pcg((chance + 2) >>> 0)) * (SPAN - lasts));
  const at = tick - span * SPAN - begin;
  return at >= 0 && at < lasts;
}
