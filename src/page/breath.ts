/** Loudness and pitch of a moment's sound. */
export type Sound = Readonly<ReturnType<typeof soundOf>>;

/**
 * Blowing at a microphone is wind: turbulence whose power falls with the square of frequency, half of it
 * below this, Hz. Of spoken and hummed vowels less than an eighth lies there.
 */
const LOW = 200;
const LOW_SHARE = 0.3;
/** Loudness of a breath of strength 0, and of strength 1. */
const QUIET = 0.05;
const LOUD = 0.3;
/** A breath lasts longer than a knock at the microphone, and is reported again this often. Seconds. */
const ONSET = 0.1;
const REPEAT = 0.3;

/** @param samples of -1 to 1, `rate` a second */
export function soundOf(samples: ArrayLike<number>, rate: number) {
  const { length } = samples;
  let mean = 0;
  for (let i = 0; i < length; i++) mean += (samples[i] ?? 0) / length;
  // Two poles each: what a microphone adds at rest is cut off, and the low part is kept.
  const smoothing = 1 - Math.exp((-2 * Math.PI * LOW) / rate);
  let firstPole = 0;
  let secondPole = 0;
  let power = 0;
  let lowPower = 0;
  for (let i = 0; i < length; i++) {
    const sample = (samples[i] ?? 0) - mean;
    firstPole += (sample - firstPole) * smoothing;
    secondPole += (firstPole - secondPole) * smoothing;
    power += sample * sample;
    lowPower += secondPole * secondPole;
  }
  return {
    /** Root mean square of the signal, whose full scale is 1. */
    loudness: Math.sqrt(power / Math.max(length, 1)),
    /** Share of its power that lies below `LOW`. */
    lowShare: power > 0 ? lowPower / power : 0,
  };
}

/** Distinguishes blowing from speech, music and knocks, moment by moment. */
export class BreathDetector {
  #lasted = 0;
  #next = ONSET;

  /** @returns strength of the breath, 0 to 1, at its onset and while it goes on; 0 in between */
  hear({ loudness, lowShare }: Sound, seconds: number): number {
    if (loudness < QUIET || lowShare < LOW_SHARE) {
      this.#lasted = 0;
      this.#next = ONSET;
      return 0;
    }
    this.#lasted += seconds;
    if (this.#lasted <= this.#next) return 0;
    this.#next = this.#lasted + REPEAT;
    return Math.min(1, Math.max(0.1, (loudness - QUIET) / (LOUD - QUIET)));
  }
}
