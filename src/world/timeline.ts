import { GROUPS, type ParticleSource } from "./particles/particle-layer.js";

/** Length of the simulation's step, in seconds. */
export const TICK = 1 / 120;
/** Ticks remembered. Longer than any particle lives, so that particles can be replayed from it. */
export const HISTORY = 256;

/**
 * Timeline: the emitter's history of the last ticks.
 *
 * Particles are a pure function of it: a GPU that lost its buffers, or begins late, replays the history and has the
 * same particles.
 */
export class Timeline {
  /** Ticks recorded so far. Negative ticks are the warm-up before time 0. */
  tick: number;
  readonly #way = new Float32Array(HISTORY * 3);
  readonly #wind = new Float32Array(HISTORY * 3);
  readonly #groups = new Uint8Array(HISTORY);
  readonly #sparks = new Uint8Array(HISTORY);

  constructor(tick: number) {
    this.tick = tick;
  }

  /**
   * @param displacement how far the emitter moved in this tick, in its own unit
   * @param wind air's velocity relative to the emitter, in its unit per second
   * @param groups groups of slots in which the flame bears particles, 0 to `GROUPS`
   * @param hasSparks whether its wick throws sparks
   */
  record(
    displacement: ArrayLike<number>,
    wind: ArrayLike<number>,
    groups: number,
    hasSparks = false,
  ): void {
    const slot = this.#slot(this.tick);
    for (let axis = 0; axis < 3; axis++) {
      this.#way[slot * 3 + axis] = displacement[axis] ?? 0;
      this.#wind[slot * 3 + axis] = wind[axis] ?? 0;
    }
    this.#groups[slot] = Math.min(groups, GROUPS);
    this.#sparks[slot] = hasSparks ? GROUPS : 0;
    this.tick++;
  }

  /** Groups that bear particles in a tick. */
  groups(tick: number, source: ParticleSource = "flame"): number {
    if (source === "room") return GROUPS;
    const groups = source === "spark" ? this.#sparks : this.#groups;
    return groups[this.#slot(tick)] ?? 0;
  }

  /** Component 0, 1 or 2 of the emitter's way in a tick. */
  way(tick: number, axis: number): number {
    return this.#way[this.#slot(tick) * 3 + axis] ?? 0;
  }

  wind(tick: number, axis: number): number {
    return this.#wind[this.#slot(tick) * 3 + axis] ?? 0;
  }

  #slot(tick: number): number {
    return tick & (HISTORY - 1);
  }
}
