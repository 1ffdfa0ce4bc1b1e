/** Target frame time while the image is refined, seconds. */
const AIM = 1 / 20;
/** Multiple of it above which a frame is late. */
const LATE = 1.1;
/** Steps of work in a frame: at first, at least and at most. */
const FIRST = 1;
const LEAST = 1 / 8;
const MOST = 16;
/** Growth of the budget after a frame in time: a factor, and steps; and the largest factor after a late one. */
const MORE = { share: 1.15, steps: 0.1 } as const;
const LESS = 0.85;

/**
 * How much of a refinement each frame does, by the time that the frames before took.
 *
 * There is no clock: the same times give the same work.
 */
export class RefinementBudget {
  #steps = FIRST;
  /** Of a step, from the frames before. */
  #rest = 0;

  /** Takes the time from one frame to the next, seconds. */
  take(seconds: number): void {
    if (!(seconds > 0)) return;
    const isLate = seconds > AIM * LATE;
    const steps = isLate
      ? this.#steps * Math.min(LESS, AIM / seconds)
      : this.#steps * MORE.share + MORE.steps;
    this.#steps = Math.min(Math.max(steps, LEAST), MOST);
  }

  /** Whole steps of the next frame. */
  next(): number {
    this.#rest += this.#steps;
    const steps = Math.floor(this.#rest);
    this.#rest -= steps;
    return steps;
  }
}
