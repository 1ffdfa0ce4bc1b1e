import { type Tier, tierNamed } from "./quality.js";
import type { Speed } from "./speed.js";

/** A step of quality: a tier, and the share of its resolution that is drawn. */
export interface Rung {
  readonly tier: Tier["name"];
  /** Of the tier's own resolution, along each axis. */
  readonly share: number;
}

/** From the least to the best: within a tier the resolution rises first. */
const LADDER: readonly Rung[] = [
  { tier: "low", share: 0.3 },
  { tier: "low", share: 0.45 },
  { tier: "low", share: 0.6 },
  { tier: "low", share: 0.8 },
  { tier: "low", share: 1 },
  { tier: "medium", share: 0.6 },
  { tier: "medium", share: 0.75 },
  { tier: "medium", share: 0.87 },
  { tier: "medium", share: 1 },
  { tier: "high", share: 0.75 },
  { tier: "high", share: 0.87 },
  { tier: "high", share: 1 },
];
/** Where it starts: a picture that every machine can draw. */
const START = LADDER.findIndex(({ share }) => share === 0.6);
const BEST = LADDER.length - 1;

/** Longest that a frame should take, seconds: 60 Hz, and half of that where every pixel is dear. */
const BUDGET: Readonly<Record<Tier["name"], number>> = {
  low: 1 / 30,
  medium: 1 / 60,
  high: 1 / 60,
  ultra: 1 / 60,
};
/** Longest that a picture may take that nothing follows, seconds. */
const PATIENCE = 0.25;
/** Share of a budget that a prediction may fill. */
const MARGIN = 0.7;
/** From one picture of the display to the next, seconds. */
const DISPLAY = 1 / 60;
/** A frame is late when it takes longer than this share of its budget. */
const LATE = 1.15;
/** Time that frames are judged by, and for which all must be well before anything is raised. Seconds. */
const JUDGED_AFTER = 1;
const RAISED_AFTER = 3;
/** The same before anything was found too slow: a fast machine should not look like a slow one for long. */
const FIRST_JUDGED_AFTER = 0.25;
const FIRST_RAISED_AFTER = 0.5;
/** Fewer frames than this are no evidence, unless they took as long as `DIRE`, seconds. */
const LEAST_FRAMES = 5;
const DIRE = 0.4;
/** The first frames after a change also pay for the change: so many, or as long as this, seconds. */
const IGNORED_FRAMES = 3;
const IGNORED = 0.5;
/** A pixel of the load that takes longer than this is drawn by no GPU, seconds: they differ a hundredfold. */
const SLOW_PIXEL = 3e-7;
/** Most that anisotropic filtering may take in a frame of a million pixels under `auto`, seconds. */
const CHEAP = 0.0015;
/** Taps of anisotropic filtering for a pixel: albedo, normal, roughness. The load has as many as `TAPS`. */
const ANISOTROPIC_SHARE = 3 / 32;

/** Work of a look's frame. Fitted to software renderers' times, and used with a margin. */
export interface Work {
  /** For a pixel of each tier, in pixels of the load, `speed/load.frag`. */
  readonly pixel: Readonly<Record<Tier["name"], number>>;
  /** What no resolution saves, in pixels of the tier. */
  readonly fixed: number;
}

/** Of rooms in the physical look, and of all else. */
export const WORK: Readonly<Record<"physical" | "plain", Work>> = {
  physical: { pixel: { low: 0.1, medium: 13, high: 19, ultra: 25 }, fixed: 100_000 },
  plain: { pixel: { low: 0.3, medium: 0.7, high: 1, ultra: 1.3 }, fixed: 0 },
};

/**
 * Follows the time that frames take: first by resolution, then by tier.
 *
 * It starts where every machine can follow. A step up is taken if its cost, predicted from what frames and
 * the load were measured to take, fits; where another tier has to be prepared first, the step waits in
 * `wanted` until it is. A step found too slow is not tried again before `renew`, so the number of changes is
 * limited, and it comes to rest. It has no clock: the same times give the same quality.
 */
export class AutoQuality {
  /** Null until it is measured; until then no tier is raised. */
  speed: Speed | null = null;
  /** Pixels of the picture at full resolution. */
  pixels = 1;
  work: Work;
  #index = START;
  #wanted: number | null = null;
  #ceiling = BEST;
  #hasBeenSlow = false;
  #ignored = 0;
  #ignoredTime = 0;
  /** Frames since it was last judged, and the time they took. Seconds. */
  #frames: number[] = [];
  #elapsed = 0;
  /** Time for which no frame was late, seconds. */
  #steady = 0;

  constructor(work: Work) {
    this.work = work;
  }

  get rung(): Rung {
    return LADDER[this.#index]!;
  }

  /** A rung of another tier that fits, to be taken by `accept` once it is prepared. */
  get wanted(): Rung | null {
    return this.#wanted === null ? null : LADDER[this.#wanted]!;
  }

  accept(): void {
    if (this.#wanted !== null) this.#goTo(this.#wanted);
  }

  /** The best for a picture that nothing follows: it may take a moment. */
  get stillRung(): Rung {
    const best = LADDER.findLastIndex(
      (rung, i) => i > this.#index && this.#predicted(rung) <= PATIENCE,
    );
    return LADDER[Math.max(best, this.#index)]!;
  }

  /** Whether textures may be filtered anisotropically: where that was measured to be cheap. */
  get allowsAnisotropy(): boolean {
    if (!this.speed) return false;
    return this.speed.anisotropicPixel * ANISOTROPIC_SHARE * 1e6 <= CHEAP;
  }

  /**
   * A frame has been drawn. True if the next is to be drawn on another rung.
   *
   * @param seconds from frame to frame
   * @param gpuSeconds what the GPU alone took of it, where that is known
   */
  take(seconds: number, gpuSeconds: number | null = null): boolean {
    if (!(seconds > 0)) return false;
    if (this.#ignored < IGNORED_FRAMES && this.#ignoredTime < IGNORED) {
      this.#ignored++;
      this.#ignoredTime += seconds;
      return false;
    }
    this.#frames.push(seconds);
    this.#elapsed += seconds;
    const due = this.#hasBeenSlow ? JUDGED_AFTER : FIRST_JUDGED_AFTER;
    const isDire = this.#frames.length > 1 && this.#frames.every((frame) => frame >= DIRE);
    const isEvidence = this.#frames.length >= LEAST_FRAMES || isDire;
    if (this.#elapsed < due || !isEvidence) return false;
    const typical = median(this.#frames);
    const isLate = typical > BUDGET[this.rung.tier] * LATE;
    // What is late at first may be paying for its first frames.
    if (isLate && !isDire && this.#elapsed < JUDGED_AFTER) return false;
    this.#steady += this.#elapsed;
    this.#frames = [];
    this.#elapsed = 0;
    // Without a GPU there is nothing whose idleness could be measured.
    const work = this.speed && this.speed.pixel < SLOW_PIXEL ? gpuSeconds : null;
    if (isLate) {
      this.#steady = 0;
      this.#wanted = null;
      // A GPU that was idle half of the time is not what made the frame late.
      const isOurs = work === null || work > BUDGET[this.rung.tier] / 2;
      return isOurs && this.#lower(typical);
    }
    const patience = this.#hasBeenSlow ? RAISED_AFTER : FIRST_RAISED_AFTER;
    return this.#steady >= patience && this.#raise(work ?? typical, work !== null);
  }

  /** What was found too slow may be tried again: another size, another room, another session. */
  renew(): void {
    this.#ceiling = BEST;
    this.#goTo(this.#index);
  }

  #lower(typical: number): boolean {
    if (this.#index === 0) return false;
    this.#hasBeenSlow = true;
    this.#ceiling = this.#index - 1;
    // A frame just too late for the display waits for the next of it: that much may be no work.
    const budget = BUDGET[this.rung.tier];
    const affordable = (this.#cost(this.rung) * budget) / Math.max(typical - DISPLAY, budget);
    let next = this.#ceiling;
    while (next > 0 && this.#cost(LADDER[next]!) > affordable) next--;
    this.#goTo(next);
    return true;
  }

  #raise(seconds: number, isWork: boolean): boolean {
    this.#steady = 0;
    const next = LADDER[this.#index + 1];
    if (!next || this.#index >= this.#ceiling) return false;
    const best = LADDER.findLastIndex(
      (rung, i) =>
        i <= this.#ceiling &&
        rung.tier !== this.rung.tier &&
        this.#predicted(rung) <= BUDGET[rung.tier] * MARGIN,
    );
    if (best > this.#index) {
      this.#wanted = best;
      return false;
    }
    if (next.tier !== this.rung.tier) return false;
    // A frame that waits for the display says nothing of what it could do: then it is tried.
    const waits = !isWork && seconds <= DISPLAY * 1.05;
    const expected = (seconds * this.#cost(next)) / this.#cost(this.rung);
    if (!waits && expected > BUDGET[next.tier]) return false;
    this.#goTo(this.#index + 1);
    return true;
  }

  /** Time that a frame of a rung takes by what the load took, seconds. */
  #predicted(rung: Rung): number {
    return this.speed ? this.#cost(rung) * this.speed.pixel : Infinity;
  }

  /** Work of a frame on a rung, in pixels of the load. */
  #cost({ tier, share }: Rung): number {
    const { pixel, fixed } = this.work;
    const pixels = this.pixels * (tierNamed(tier).resolutionScale * share) ** 2;
    return (pixels + fixed) * pixel[tier];
  }

  #goTo(index: number): void {
    this.#index = index;
    this.#wanted = null;
    this.#frames = [];
    this.#elapsed = 0;
    this.#steady = 0;
    this.#ignored = 0;
    this.#ignoredTime = 0;
  }
}

function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1]!;
}
