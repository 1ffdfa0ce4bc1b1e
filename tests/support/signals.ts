import { pcg, signed } from "../../src/world/random.ts";

/** Samples in a second, and so in each of these signals. */
export const RATE = 48_000;

/** A second of a signal, scaled to a root mean square. */
export function signal(loudness: number, sample: (i: number) => number): Float32Array {
  const samples = Float32Array.from({ length: RATE }, (_, i) => sample(i));
  const rms = Math.sqrt(samples.reduce((sum, value) => sum + value * value, 0) / RATE);
  return samples.map((value) => (value * loudness) / rms);
}

/** Turbulence at a microphone: noise whose power falls with the square of frequency. */
export function wind(loudness: number): Float32Array {
  let level = 0;
  return signal(loudness, (i) => {
    level = level * 0.995 + signed(pcg(i));
    return level;
  });
}

/** A voice at 130 Hz whose vowel has its formants at these frequencies, Hz. */
export function vowel(loudness: number, formants: readonly number[]): Float32Array {
  return signal(loudness, (i) => {
    let sum = 0;
    for (let harmonic = 1; harmonic < 25; harmonic++) {
      const frequency = 130 * harmonic;
      const gain = formants.reduce((g, f) => g + 1 / (1 + ((frequency - f) / 90) ** 2), 0.02);
      sum += gain * Math.sin((2 * Math.PI * frequency * i) / RATE);
    }
    return sum;
  });
}
