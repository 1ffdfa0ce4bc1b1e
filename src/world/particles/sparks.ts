import { pcg, unit } from "../random.js";

/** Ticks of a span of time, and spans for each one with sparks. */
const SPAN = 480;
const ODDS = 6;
/** Ticks that they last: fewest, and how many more at most. */
const SHORTEST = 2;
const LONGER = 4;

/**
 * Schedule of sparks, thrown when water in the wick boils: about every twenty-four seconds, at random, by the seed.
 */
export class SparkSchedule {
  readonly #seed: number;
  /** The span that was last asked for, and the ticks from and to which it has sparks. */
  #span = Number.NaN;
  #begin = 0;
  #end = 0;

  constructor(seed: number) {
    this.#seed = seed;
  }

  isAt(tick: number): boolean {
    const span = Math.floor(tick / SPAN);
    if (span !== this.#span) this.#draw(span);
    return tick >= this.#begin && tick < this.#end;
  }

  #draw(span: number): void {
    this.#span = span;
    this.#begin = this.#end = span * SPAN;
    const chance = pcg((pcg((this.#seed ^ 0x5b17) >>> 0) + span) >>> 0);
    if (unit(chance) * ODDS >= 1) return;
    const lasts = SHORTEST + Math.round(unit(pcg((chance + 1) >>> 0)) * LONGER);
    this.#begin += Math.floor(unit(pcg((chance + 2) >>> 0)) * (SPAN - lasts));
    this.#end = this.#begin + lasts;
  }
}
