/**
 * Noise from integer hashes: the same numbers on every machine, and periodic where a period is given,
 * so that whatever is made of it tiles.
 */

export const clamp = (x, low = 0, high = 1) => (x < low ? low : x > high ? high : x);

export const mix = (a, b, t) => a + (b - a) * t;

export function smoothstep(from, to, x) {
  const t = clamp((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

/** A bell of height one at zero, e⁻¹ at `width`. */
export const bell = (x, width) => Math.exp(-((x / width) ** 2));

/** 32 well-mixed bits of a lattice point (the finaliser of MurmurHash3, Appleby 2011). */
export function hash(x, y, seed) {
  let h =
    Math.imul(x | 0, 0x27d4eb2d) ^ Math.imul(y | 0, 0x165667b1) ^ Math.imul(seed | 0, 0x9e3779b1);
  h = Math.imul(h ^ (h >>> 15), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

/** Uniform in [0, 1). */
export const random = (x, y, seed) => hash(x, y, seed) / 4294967296;

/** A stream of uniform numbers for one thing (a knot, a stone): `const next = randomStream(7, 3)`. */
export function randomStream(thing, seed) {
  let index = 0;
  return (low = 0, high = 1) => low + (high - low) * random(thing, index++, seed);
}

const DIRECTIONS = 64;
const gradientX = new Float64Array(DIRECTIONS);
const gradientY = new Float64Array(DIRECTIONS);
for (let k = 0; k < DIRECTIONS; k++) {
  gradientX[k] = Math.cos((2 * Math.PI * k) / DIRECTIONS);
  gradientY[k] = Math.sin((2 * Math.PI * k) / DIRECTIONS);
}

const wrap = (i, period) => (period ? ((i % period) + period) % period : i);

const fade = (t) => t * t * t * (t * (t * 6 - 15) + 10);

/**
 * Gradient noise, about -1..1 (Perlin 2002, "Improving Noise"). Integer periods, in lattice cells;
 * zero means not periodic.
 */
export function noise(x, y, seed, periodX = 0, periodY = 0) {
  const column = Math.floor(x);
  const row = Math.floor(y);
  const fx = x - column;
  const fy = y - row;
  const left = wrap(column, periodX);
  const right = wrap(column + 1, periodX);
  const top = wrap(row, periodY);
  const bottom = wrap(row + 1, periodY);
  let k = hash(left, top, seed) & (DIRECTIONS - 1);
  const a = gradientX[k] * fx + gradientY[k] * fy;
  k = hash(right, top, seed) & (DIRECTIONS - 1);
  const b = gradientX[k] * (fx - 1) + gradientY[k] * fy;
  k = hash(left, bottom, seed) & (DIRECTIONS - 1);
  const c = gradientX[k] * fx + gradientY[k] * (fy - 1);
  k = hash(right, bottom, seed) & (DIRECTIONS - 1);
  const d = gradientX[k] * (fx - 1) + gradientY[k] * (fy - 1);
  const u = fade(fx);
  const v = fade(fy);
  return 1.5 * mix(mix(a, b, u), mix(c, d, u), v);
}

/** Octaves of noise, each twice as fine and `gain` as strong; about -1..1. */
export function fractalNoise(x, y, seed, octaves, periodX = 0, periodY = 0, gain = 0.5) {
  let sum = 0;
  let amplitude = 1;
  let total = 0;
  let scale = 1;
  for (let octave = 0; octave < octaves; octave++) {
    sum +=
      amplitude *
      noise(x * scale, y * scale, seed + octave * 101, periodX * scale, periodY * scale);
    total += amplitude;
    amplitude *= gain;
    scale *= 2;
  }
  return (1.4 * sum) / total;
}

const cell = { nearest: 0, second: 0, id: 0 };

/**
 * Distances to the nearest and second nearest of scattered points, and the nearest one's hash
 * (Worley 1996, "A Cellular Texture Basis Function"). The returned object is reused by the next call.
 */
export function cellular(x, y, seed, periodX = 0, periodY = 0, jitter = 0.9) {
  const column = Math.floor(x);
  const row = Math.floor(y);
  cell.nearest = 9;
  cell.second = 9;
  for (let dy = -1; dy <= 1; dy++) {
    for (let dx = -1; dx <= 1; dx++) {
      const i = wrap(column + dx, periodX);
      const j = wrap(row + dy, periodY);
      const bits = hash(i, j, seed);
      const toX = column + dx + 0.5 + jitter * ((bits & 0xffff) / 65536 - 0.5) - x;
      const toY = row + dy + 0.5 + jitter * ((bits >>> 16) / 65536 - 0.5) - y;
      const distance = Math.sqrt(toX * toX + toY * toY);
      if (distance < cell.nearest) {
        cell.second = cell.nearest;
        cell.nearest = distance;
        cell.id = hash(i, j, seed + 13);
      } else if (distance < cell.second) {
        cell.second = distance;
      }
    }
  }
  return cell;
}

/** Fractal noise that repeats with a tile: of a place, the cycles in a tile, and what is added to the seed. */
export function tiledNoise(tile, seed) {
  return (x, y, cycles, offset, octaves = 4) =>
    fractalNoise((x / tile) * cycles, (y / tile) * cycles, seed + offset, octaves, cycles, cycles);
}
