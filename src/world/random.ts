/**
 * Seeded random numbers, bit-identical to those of `shaders/lib/random.glsl`.
 *
 * Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3): PCG-RXS-M-XS, 32 bit.
 */
export function pcg(value: number): number {
  const state = (Math.imul(value, 747796405) + 2891336453) >>> 0;
  const word = Math.imul((state >>> ((state >>> 28) + 4)) ^ state, 277803737) >>> 0;
  return ((word >>> 22) ^ word) >>> 0;
}

/** Seed of one of several things that share a seed. */
export function seedOf(seed: number, index: number): number {
  return pcg((seed + Math.imul(index, 0x9e3779b9)) >>> 0);
}

/** A hash as a number in [0, 1). 24 bits, so that it is exact as a float. */
export function unit(hash: number): number {
  return (hash >>> 8) / 0x1000000;
}

/** A hash as a number in [-1, 1). */
export function signed(hash: number): number {
  return unit(hash) * 2 - 1;
}

/** The upper half of a hash as a number in [-1, 1): 16 bits. */
export function signedHigh(hash: number): number {
  return (hash >> 16) / 0x8000;
}

/** The lower half of a hash, likewise. */
export function signedLow(hash: number): number {
  return ((hash << 16) >> 16) / 0x8000;
}
