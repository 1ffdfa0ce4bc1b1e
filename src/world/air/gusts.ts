import type { Vec3 } from "../geometry.js";
import { pcg, seedOf, signed, unit } from "../random.js";

/** Waves that a gust is made of. */
const WAVES = 14;
/** Frequencies of the slowest and the fastest, Hz: a room's air seldom changes faster. */
const SLOWEST = 0.12;
const FASTEST = 15;
/** A wave of frequency f is this long times 1/f, m/s: eddies of a metre turn within seconds. */
const TURNOVER = 0.45;

/**
 * Gusts: turbulence as a sum of plane waves: seeded, smooth in space and time, and free of divergence,
 * since each wave swings across its own direction.
 *
 * Kraichnan 1970, "Diffusion by a Random Velocity Field". Amplitudes fall so that power goes as
 * f^-5/3 (Kolmogorov 1941), over frequencies spaced evenly in their logarithm.
 */
export class Gusts {
  /** Of each wave: direction times wave number (1/m), frequency (rad/s), phase. */
  readonly #waves = new Float64Array(WAVES * 5);
  /** Amplitude of each wave, for a root mean square of 1 m/s along each axis. */
  readonly #swings = new Float64Array(WAVES * 3);
  /** Root mean square, m/s, and time, seconds, of the gusts that `add` adds. */
  strength = 0;
  time = 0;

  constructor(seed: number) {
    let power = 0;
    for (let i = 0; i < WAVES; i++) {
      const frequency = SLOWEST * (FASTEST / SLOWEST) ** (i / (WAVES - 1));
      const key = seedOf(seed, i + 1);
      const [x, y, z] = direction(key);
      // Any vector crossed with the direction lies across it.
      const [a, b, c] = direction(pcg(key + 1));
      const swing = [y * c - z * b, z * a - x * c, x * b - y * a];
      const length = Math.max(Math.hypot(...swing), 1e-6);
      const amplitude = frequency ** (-1 / 3);
      const number = (2 * Math.PI * frequency) / TURNOVER;
      const phase = 2 * Math.PI * unit(pcg(key + 2));
      this.#waves.set([x * number, y * number, z * number, 2 * Math.PI * frequency, phase], i * 5);
      this.#swings.set(
        swing.map((value) => (value / length) * amplitude),
        i * 3,
      );
      power += amplitude ** 2 / 2;
    }
    const scale = Math.sqrt(3 / power);
    for (let i = 0; i < this.#swings.length; i++) this.#swings[i]! *= scale;
  }

  /** Adds the gusts at a place to `velocity`, m/s. */
  add(place: Readonly<Vec3>, velocity: Vec3): void {
    const { strength, time } = this;
    const x = place[0];
    const y = place[1];
    const z = place[2];
    const waves = this.#waves;
    const swings = this.#swings;
    for (let i = 0; i < WAVES; i++) {
      const w = i * 5;
      const along = waves[w]! * x + waves[w + 1]! * y + waves[w + 2]! * z + waves[w + 4]!;
      const wave = strength * Math.cos(along - waves[w + 3]! * time);
      velocity[0] += wave * swings[i * 3]!;
      velocity[1] += wave * swings[i * 3 + 1]!;
      velocity[2] += wave * swings[i * 3 + 2]!;
    }
  }
}

/** Evenly spread over the sphere. */
function direction(key: number): Vec3 {
  const y = signed(key);
  const angle = Math.PI * signed(pcg(key));
  const level = Math.sqrt(1 - y * y);
  return [level * Math.cos(angle), y, level * Math.sin(angle)];
}
