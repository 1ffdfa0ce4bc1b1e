import { Fire } from "./fire.mjs";

/** Rate at which a flame is watched, 1/s. */
const RATE = 240;

/**
 * Burns a flame and says how it puffs: its strongest frequency (Hz) and the rms of its luminous volume
 * (share of the mean) after `settling` seconds, and how the rms of the second half of that time compares
 * with that of the first.
 */
export function measure({ settling, seconds, ...options }) {
  const fire = new Fire(options);
  const volumes = [];
  for (let i = 0; i < Math.round((settling + seconds) * RATE); i++) {
    fire.advance(1 / RATE);
    volumes.push(fire.volume);
  }
  const watched = volumes.slice(Math.round(settling * RATE));
  const middle = watched.length >> 1;
  return {
    frequency: round(strongest(watched)),
    rms: round(rms(watched)),
    growth: round(rms(watched.slice(middle)) / rms(watched.slice(0, middle))),
  };
}

const round = (value) => Number(value.toPrecision(4));
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

function rms(values) {
  const middle = mean(values);
  return Math.sqrt(mean(values.map((value) => (value - middle) ** 2))) / middle;
}

/** Frequency of the highest peak of a spectrum through Hann's window, Hz. */
export function strongest(values, rate = RATE) {
  const middle = mean(values);
  let [best, most] = [0, 0];
  for (let frequency = 2; frequency < 40; frequency += 0.05) {
    let [real, imaginary] = [0, 0];
    for (const [n, value] of values.entries()) {
      const window = 0.5 - 0.5 * Math.cos((2 * Math.PI * n) / values.length);
      const angle = (2 * Math.PI * frequency * n) / rate;
      real += window * (value - middle) * Math.cos(angle);
      imaginary += window * (value - middle) * Math.sin(angle);
    }
    const power = real * real + imaginary * imaginary;
    if (power > most) [best, most] = [frequency, power];
  }
  return best;
}
