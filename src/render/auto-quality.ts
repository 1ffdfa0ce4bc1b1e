import { type Tier, tierNamed } from "./quality.js";
import { SOFTWARE_PIXEL } from "./speed.js";

/** A step of quality: a tier and a resolution. */
export interface Rung {
  readonly tier: Tier["name"];
  /** Of the tier's resolution, along each axis. */
  readonly share: number;
}

const SHARES = {
  low: [0.3, 0.45, 0.6, 0.8, 1, 1.25, 1.5],
  medium: [0.6, 0.75, 0.87, 1],
  high: [0.75, 0.87, 1],
} as const;
/** From lowest to highest: within a tier the resolution rises first. */
const LADDER: readonly Rung[] = (["low", "medium", "high"] as const).flatMap((tier) =>
  SHARES[tier].map((share) => ({ tier, share })),
);
/** First rung, for any machine: a page that loads takes time from the measured load, which may seem 200 times slower. */
const START = 2;
/** `low` at its own resolution. */
const WHOLE_LOW = 4;
const BEST = LADDER.length - 1;

/** Frame budget, seconds: 60 Hz, and 24 Hz for `low`, where a coarser image saves little of a frame. */
const budgetOf = ({ tier, share }: Rung, { fineLow }: Work) =>
  1 / (share > 1 ? fineLow : tier === "low" ? 24 : 60);
/** Budget of a still frame, seconds. */
const STILL_BUDGET = 0.25;
/** Share of a budget that a predicted frame may fill. */
const MARGIN = 0.7;
/** Refresh interval of the display, seconds. */
const REFRESH = 1 / 60;
/** Frames that take longer than this share of their budget are late. */
const LATE = 1.15;
/** The same for the first seconds of `low`, so many: a CPU that draws compiles as well. */
const FIRST_LATE = 2;
const FIRST_TIME = 4;
/** Time over which frames are measured, and time without late frames before quality is raised. Seconds. */
const MEASURE_TIME = 1;
const RAISE_TIME = 3;
/** The same until a rung was too slow, so that fast machines rise soon. */
const FIRST_MEASURE_TIME = 0.25;
const FIRST_RAISE_TIME = 0.5;
/** Time without late frames before a rung of the same tier that was too slow is tried again, each of three times. Seconds. */
const RETRY_TIMES = [6, 20, 60] as const;
/** Least number of frames in a measurement, unless all took at least `VERY_LATE`, seconds. */
const LEAST_FRAMES = 5;
const VERY_LATE = 0.4;
/** Frames ignored after a change, whose cost they include: so many, or for so many seconds. */
const IGNORED_FRAMES = 3;
const IGNORED_TIME = 0.5;
/**
 * Dearest pixel of the load with anisotropic filtering under `auto`, seconds: by an H200's times, a sixtieth of it, that
 * takes 0.8 ms of a frame of a million pixels.
 */
const ANISOTROPY_PIXEL = 5e-8;

/** Cost model of a frame, used with a margin. */
export interface Work {
  /** Of a pixel of each tier, in pixels of the load, `speed/load.frag`; fitted to software renderers' times. */
  readonly pixel: Readonly<Record<Tier["name"], number>>;
  /** The same of GPUs, on which the load waits for its taps: hopeful, since frames are measured afterwards. */
  readonly gpuPixel: Readonly<Record<Tier["name"], number>>;
  /** Independent of resolution, in pixels of the tier; of `low` four times as much. */
  readonly fixed: number;
  /** Least frame rate of `low` above its own resolution, Hz. */
  readonly fineLow: number;
  /** Whether frames of a CPU stay at `low`, which alone is drawn in another way, however few pixels there are. */
  readonly staysLow?: boolean;
}

const PLAIN_PIXEL = { low: 0.3, medium: 0.7, high: 1, ultra: 1.3 };

/** Of a scene with a camera at rest. In rooms smooth motion is worth more than detail. */
const ALONE: Work = { pixel: PLAIN_PIXEL, gpuPixel: PLAIN_PIXEL, fixed: 0, fineLow: 24 };

/** For rooms in the physical look, for those in others, for our candle alone, and for a visitor's. */
export const WORK: Readonly<Record<"physical" | "plain" | "alone" | "own", Work>> = {
  physical: {
    pixel: { low: 0.1, medium: 13, high: 19, ultra: 25 },
    gpuPixel: { low: 0.1, medium: 1.2, high: 1.5, ultra: 2 },
    fixed: 100_000,
    fineLow: 40,
  },
  plain: { ...ALONE, fineLow: 40 },
  alone: ALONE,
  own: { ...ALONE, staysLow: true },
};

/**
 * Adaptive quality by measured frame times: first the resolution, then the tier.
 *
 * It steps up if the cost predicted from measured frames and the measured load fits the budget. A step to another tier
 * waits in `wanted` until that tier is prepared. A tier that was too slow is not tried again before `renew`, a resolution
 * three times, so the number of changes is limited. There is no clock: the same times give the same quality.
 */
export class AutoQuality {
  /** Time of a pixel of the load, `speed/load.frag`, seconds. Null until it is measured; until then the tier stays. */
  pixel: number | null = null;
  /** Pixels of the canvas at full resolution. */
  pixels = 1;
  work: Work;
  #index = START;
  #wanted: number | null = null;
  /** Highest rung that the driver draws; and that may be fast enough. */
  #best = BEST;
  #ceiling = BEST;
  #hasBeenSlow = false;
  #ignored = 0;
  #ignoredTime = 0;
  /** Frame times of the current measurement, and their sum, seconds. */
  #frames: number[] = [];
  #elapsed = 0;
  /** Time without late frames, seconds: since quality might have been raised, and since it was changed. */
  #steady = 0;
  #untroubled = 0;
  /** Time that frames were measured for, seconds. */
  #measured = 0;
  #retries = 0;

  readonly #measure: (() => Promise<number | null>) | undefined;
  /** How often the load may be measured again. */
  #remeasurements = 2;

  /** @param measure measures `pixel` again */
  constructor(work: Work, measure?: () => Promise<number | null>) {
    this.work = work;
    this.#measure = measure;
  }

  get rung(): Rung {
    return LADDER[this.#index]!;
  }

  /** A rung of another tier that fits the budget; `accept` takes it once that tier is prepared. */
  get wanted(): Rung | null {
    return this.#wanted === null ? null : LADDER[this.#wanted]!;
  }

  accept(): void {
    if (this.#wanted !== null) this.#goTo(this.#wanted);
  }

  get stillRung(): Rung {
    const best = LADDER.findLastIndex(
      (rung, i) =>
        i > this.#index &&
        i <= this.#best &&
        rung.share <= 1 &&
        this.#predictedTime(rung, this.pixel) <= STILL_BUDGET,
    );
    return LADDER[Math.max(best, this.#index)]!;
  }

  /** Whether anisotropic filtering is predicted to fit its budget. */
  get allowsAnisotropy(): boolean {
    return (this.pixel ?? 1) <= ANISOTROPY_PIXEL;
  }

  /** Whether pixels were measured to cost what they cost a CPU. */
  get isSoftware(): boolean {
    return (this.pixel ?? 0) >= SOFTWARE_PIXEL;
  }

  /**
   * Records a frame. True if the rung has changed.
   *
   * @param seconds from frame to frame
   * @param gpuSeconds GPU time of it, where that is known
   */
  take(seconds: number, gpuSeconds: number | null = null): boolean {
    if (!(seconds > 0)) return false;
    if (this.#ignored < IGNORED_FRAMES && this.#ignoredTime < IGNORED_TIME) {
      this.#ignored++;
      this.#ignoredTime += seconds;
      return false;
    }
    this.#frames.push(seconds);
    this.#elapsed += seconds;
    const due = this.#hasBeenSlow ? MEASURE_TIME : FIRST_MEASURE_TIME;
    const areVeryLate =
      this.#frames.length > 1 && this.#frames.every((frame) => frame >= VERY_LATE);
    const isEvidence = this.#frames.length >= LEAST_FRAMES || areVeryLate;
    if (this.#elapsed < due || !isEvidence) return false;
    const typical = middleMean(this.#frames);
    const isWarmingUp =
      this.rung.tier === "low" && gpuSeconds === null && this.#measured < FIRST_TIME;
    const isLate = typical > budgetOf(this.rung, this.work) * (isWarmingUp ? FIRST_LATE : LATE);
    // Early late frames may include the cost of the change.
    if (isLate && !areVeryLate && this.#elapsed < MEASURE_TIME) return false;
    this.#steady += this.#elapsed;
    this.#untroubled += this.#elapsed;
    this.#measured += this.#elapsed;
    this.#frames = [];
    this.#elapsed = 0;
    // A software renderer has no GPU time.
    const work = this.pixel !== null && !this.isSoftware ? gpuSeconds : null;
    if (isLate) {
      this.#steady = 0;
      this.#untroubled = 0;
      this.#wanted = null;
      // A GPU that was idle half of the time did not cause the delay.
      const isGpuBound = work === null || work > budgetOf(this.rung, this.work) / 2;
      return isGpuBound && this.#lower(typical);
    }
    const steadyTime = this.#hasBeenSlow ? RAISE_TIME : FIRST_RAISE_TIME;
    return this.#steady >= steadyTime && this.#raise(work ?? typical, work !== null);
  }

  /**
   * While another renderer's image is shown: takes the whole resolution of `low` for the next motion, unless a rung was too
   * slow before.
   */
  rise(): void {
    if (!this.#hasBeenSlow && this.#index < WHOLE_LOW) this.#goTo(WHOLE_LOW);
  }

  /** Allows rungs that were too slow again, for another size or room; in another context those that were refused, too. */
  renew(isOtherContext?: boolean): void {
    if (isOtherContext) this.#best = BEST;
    this.#ceiling = this.#best;
    this.#retries = 0;
    this.#measured = 0;
    this.#goTo(this.#index);
  }

  /** The driver refuses a tier: it is not tried again in this context. */
  refuse(name: Tier["name"]): void {
    this.#best = LADDER.findIndex(({ tier }) => tier === name) - 1;
    this.#ceiling = Math.min(this.#ceiling, this.#best);
    this.#goTo(this.#index);
  }

  #lower(typical: number): boolean {
    if (this.#index === 0) return false;
    this.#hasBeenSlow = true;
    this.#ceiling = this.#index - 1;
    // A frame may have waited for one refresh of the display.
    const budget = budgetOf(this.rung, this.work);
    const affordable = (this.#cost(this.rung) * budget) / Math.max(typical - REFRESH, budget);
    let next = this.#ceiling;
    while (next > 0 && this.#cost(LADDER[next]!) > affordable) next--;
    this.#goTo(next);
    return true;
  }

  #raise(seconds: number, isWork: boolean): boolean {
    this.#steady = 0;
    const next = LADDER[this.#index + 1];
    if (!next) return false;
    const isRetry = this.#index >= this.#ceiling;
    if (isRetry && this.#untroubled < (RETRY_TIMES[this.#retries] ?? Infinity)) return false;
    // From frames of a GPU where shading is most of them, else from the load.
    const pixel = isWork && this.rung.tier !== "low" ? seconds / this.#cost(this.rung) : this.pixel;
    const staysLow = this.isSoftware && this.work.staysLow;
    const best = LADDER.findLastIndex(
      (rung, i) =>
        i <= this.#ceiling &&
        !staysLow &&
        rung.tier !== this.rung.tier &&
        this.#predictedTime(rung, pixel) <= budgetOf(rung, this.work) * MARGIN,
    );
    if (best > this.#index && !isRetry) {
      this.#wanted = best;
      return false;
    }
    if (seconds <= REFRESH * 1.05) void this.remeasure();
    if (next.tier !== this.rung.tier) return false;
    // A frame limited by the display gives no estimate: the next rung is tried.
    const isDisplayBound = !isWork && seconds <= REFRESH * 1.05;
    const expected = (seconds * this.#cost(next)) / this.#cost(this.rung);
    if ((isRetry || !isDisplayBound) && expected > budgetOf(next, this.work)) return false;
    if (isRetry) {
      this.#retries++;
      this.#ceiling = this.#index + 1;
    }
    this.#goTo(this.#index + 1);
    return true;
  }

  /** Frames are fast, and yet no other tier seems to be: the load may have been measured while the GPU was busy. */
  async remeasure(): Promise<void> {
    if (this.#remeasurements-- <= 0) return;
    const pixel = await this.#measure?.();
    // Other work only adds time.
    if (pixel != null) this.pixel = Math.min(pixel, this.pixel ?? Infinity);
  }

  /** Frame time of a rung predicted from that of a pixel of the load, seconds. */
  #predictedTime(rung: Rung, pixel: number | null): number {
    return this.#cost(rung) * (pixel ?? Infinity);
  }

  /** Of a frame on a rung, in pixels of the load. */
  #cost({ tier, share }: Rung): number {
    const { fixed, ...work } = this.work;
    const pixel = this.isSoftware ? work.pixel : work.gpuPixel;
    const pixels = this.pixels * (tierNamed(tier).resolutionScale * share) ** 2;
    return (pixels + (tier === "low" ? 4 * fixed : fixed)) * pixel[tier];
  }

  #goTo(index: number): void {
    this.#index = index;
    this.#wanted = null;
    this.#frames = [];
    this.#elapsed = 0;
    this.#steady = 0;
    this.#untroubled = 0;
    this.#ignored = 0;
    this.#ignoredTime = 0;
  }
}

/** Mean of the middle half: frames end with the display's, so that a median would be one of few values. */
function middleMean(values: readonly number[]): number {
  const quarter = values.length >> 2;
  const middle = values.toSorted((a, b) => a - b).slice(quarter, values.length - quarter);
  return middle.reduce((sum, value) => sum + value, 0) / middle.length;
}
