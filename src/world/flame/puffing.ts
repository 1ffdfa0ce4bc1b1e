import { length2 } from "../geometry.js";

/** Widest source without puffing, m: in the solver, flames are steady at 10 mm and hardly puff at 20. */
const STILL_WIDTH = 0.017;
/** Share of √(g/D) that a flame puffs at: the mean of the solver's three widths. */
const STROUHAL = 0.47;
/** Exponent of growth in a cycle, far above the threshold: from the decay at 10 mm in the solver. */
const GROWTH = 0.72;
/** Amplitude of the luminous volume far above the threshold, as a share of its mean. */
const SATURATION = 0.28;
/** Least disturbance by the air, from which puffing begins. */
const TREMBLE = 1e-3;

/** How often a flame puffs over a source this wide (m), Hz. */
export function puffingFrequency(width: number, gravity = 9.81): number {
  return STROUHAL * Math.sqrt(gravity / width);
}

/**
 * Puffing of a wide flame: a self-excited oscillator.
 *
 * Stuart and Landau's equation, dA/dt = (s + iw) A - l |A|² A, which every flow obeys just above the threshold of
 * such an instability (Landau 1944, "On the Problem of Turbulence"). Threshold, frequency and saturation are those
 * of the axisymmetric solver in tools/puffing. Below the threshold s < 0 and disturbances decay: a candle has no
 * tone of its own.
 */
export class Puffing {
  /** Share of its mean by which the luminous volume is off it: the amplitude's real part. */
  real = TREMBLE;
  imaginary = 0;

  /** Begins anew at a phase, radians. */
  begin(phase = 0): void {
    this.real = TREMBLE * Math.cos(phase);
    this.imaginary = TREMBLE * Math.sin(phase);
  }

  /** Lets seconds pass over a source of this width, m. Exact for any step. */
  advance({ width }: { readonly width: number }, seconds: number, gravity = 9.81): void {
    const frequency = puffingFrequency(width, gravity);
    const excess = 1 - STILL_WIDTH / width;
    const rate = GROWTH * frequency * Math.max(excess, -3);
    const size = length2(this.real, this.imaginary);
    const grown = Math.exp(rate * seconds);
    // Bernoulli's equation of |A|²; at the threshold growth and saturation vanish together.
    const limit = SATURATION * SATURATION * Math.max(excess, 0);
    const squared = size * size;
    const brake = limit > 0 ? 1 + (squared / limit) * (grown * grown - 1) : 1;
    const change = grown / Math.sqrt(brake);
    const turn = 2 * Math.PI * frequency * seconds;
    const cos = Math.cos(turn) * change;
    const sin = Math.sin(turn) * change;
    const { real, imaginary } = this;
    this.real = real * cos - imaginary * sin;
    this.imaginary = real * sin + imaginary * cos;
    const amplitude = size * change;
    // Disturbances of the air start the oscillation.
    if (excess > 0 && amplitude < TREMBLE) this.real += TREMBLE - amplitude;
    if (excess <= 0 && amplitude < 1e-6) this.real = this.imaginary = 0;
  }

  /** Luminous volume as a share of its mean; exactly 1 where the flame stands still. */
  get pulse(): number {
    return 1 + this.real;
  }
}
