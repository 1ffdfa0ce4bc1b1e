import { pcg, unit } from "../random.js";

/** Ticks of a span of time, and spans for each one with sparks. */
const SPAN = 480;
const ODDS = 6;
/** Ticks that they last: fewest, and how many more at most. */
const SHORTEST = 2;
const LONGER = 4;

/**
 * Whether a wick that burns well throws sparks, when water in it boils: about every twenty-four seconds, at random, by
 * the seed.
 */
export function hasSparks(seed: number, tick: number): boolean {
  const span = Math.floor(tick / SPAN);
  const chance = pcg((pcg((seed ^ 0x5b17) >>> 0) + span) >>> 0);
  if (unit(chance) * ODDS >= 1) return false;
  const lasts = SHORTEST + Math.round(unit(pcg((chance + 1) >>> 0)) * LONGER);
  const begin = Math.floor(unit(pcg((chance + 2) >>> 0)) * (SPAN - lasts));
  const since = tick - span * SPAN - begin;
  return since >= 0 && since < lasts;
}
