import { isSoftware, type Tier, tierNamed } from "./tier.js";

/** A step of quality: a tier, and the share of its resolution that is drawn. */
export interface Rung {
  readonly tier: Tier["name"];
  /** Of the tier's own resolution, along each axis. */
  readonly share: number;
}

/** From the least to the best: within a tier the resolution rises first. */
const LADDER: readonly Rung[] = [
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

/** Longest that a frame should take, seconds: 60 Hz, and half of that where a CPU draws. */
const BUDGET: Readonly<Record<Tier["name"], number>> = {
  low: 1 / 30,
  medium: 1 / 60,
  high: 1 / 60,
  ultra: 1 / 60,
};
/** From one picture of the display to the next, seconds. */
const DISPLAY = 1 / 60;
/** A frame is late when it takes longer than this share of its budget. */
const LATE = 1.15;
/** Time that frames are judged by, and for which all must be well before anything is raised. Seconds. */
const JUDGED_AFTER = 1;
const RAISED_AFTER = 3;
/** Fewer frames than this are no evidence. */
const LEAST_FRAMES = 5;
/** The first frames after a change also pay for the change. */
const IGNORED_FRAMES = 3;
/** Longer than this a page was hidden or busy, seconds. */
const STALL = 1;

/** Integrated and mobile GPUs. */
const INTEGRATED = /Intel|Iris|UHD|Mali|Adreno|PowerVR|VideoCore|Radeon\(TM\) (Vega|Graphics)/i;

/**
 * Follows the time that frames take: first by resolution, then by tier.
 *
 * A step found too slow is not tried again before `renew`, so the number of changes is limited, and it
 * comes to rest. It has no clock: the same frame times give the same quality.
 */
export class AutoQuality {
  readonly #isSoftware: boolean;
  #index: number;
  #ceiling = LADDER.length - 1;
  #ignored = 0;
  /** Frames since it was last judged, and the time they took. Seconds. */
  #frames: number[] = [];
  #elapsed = 0;
  /** Time for which no frame was late, seconds. */
  #steady = 0;

  /** @param renderer as the driver names it */
  constructor(renderer: string) {
    this.#isSoftware = isSoftware(renderer);
    const tier = this.#isSoftware ? "low" : INTEGRATED.test(renderer) ? "medium" : "high";
    this.#index = LADDER.findIndex((rung) => rung.tier === tier && rung.share === 1);
  }

  get rung(): Rung {
    return LADDER[this.#index]!;
  }

  /**
   * A frame has been drawn. True if the next is to be drawn on another rung.
   *
   * @param seconds from frame to frame
   * @param gpuSeconds what the GPU alone took of it, where that is known
   */
  take(seconds: number, gpuSeconds: number | null = null): boolean {
    // Without a GPU there is nothing whose idleness could be measured.
    const work = this.#isSoftware ? null : gpuSeconds;
    if (!(seconds > 0) || seconds >= STALL) return false;
    if (this.#ignored < IGNORED_FRAMES) {
      this.#ignored++;
      return false;
    }
    this.#frames.push(seconds);
    this.#elapsed += seconds;
    if (this.#elapsed < JUDGED_AFTER || this.#frames.length < LEAST_FRAMES) return false;
    const typical = median(this.#frames);
    this.#steady += this.#elapsed;
    this.#frames = [];
    this.#elapsed = 0;
    if (typical > BUDGET[this.rung.tier] * LATE) {
      this.#steady = 0;
      // A GPU that was idle half of the time is not what made the frame late.
      const isOurs = work === null || work > BUDGET[this.rung.tier] / 2;
      return isOurs && this.#lower(typical);
    }
    return this.#steady >= RAISED_AFTER && this.#raise(work ?? typical, work !== null);
  }

  /** What was found too slow may be tried again: another size, another room, another session. */
  renew(): void {
    this.#ceiling = LADDER.length - 1;
    this.#goTo(this.#index);
  }

  #lower(typical: number): boolean {
    if (this.#index === 0) return false;
    this.#ceiling = this.#index - 1;
    // A frame just too late for the display waits for the next of it: that much may be no work.
    const budget = BUDGET[this.rung.tier];
    const affordable = (cost(this.rung) * budget) / Math.max(typical - DISPLAY, budget);
    let next = this.#ceiling;
    while (next > 0 && cost(LADDER[next]!) > affordable) next--;
    this.#goTo(next);
    return true;
  }

  #raise(seconds: number, isWork: boolean): boolean {
    this.#steady = 0;
    const next = LADDER[this.#index + 1];
    if (!next || this.#index >= this.#ceiling) return false;
    // A frame that waits for the display says nothing of what it could do: then it is tried.
    const waits = !isWork && seconds <= DISPLAY * 1.05;
    const expected = (seconds * cost(next)) / cost(this.rung);
    if (!waits && expected > BUDGET[next.tier]) return false;
    this.#goTo(this.#index + 1);
    return true;
  }

  #goTo(index: number): void {
    this.#index = index;
    this.#frames = [];
    this.#elapsed = 0;
    this.#steady = 0;
    this.#ignored = 0;
  }
}

/** Work of a frame on a rung, to compare with another's. */
function cost({ tier, share }: Rung): number {
  const { resolutionScale, pixelCost } = tierNamed(tier);
  return (resolutionScale * share) ** 2 * pixelCost;
}

function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1]!;
}
