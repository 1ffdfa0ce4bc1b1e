import { pcg, unit } from "../../src/world/random.ts";

/** Seeded numbers in [min, max), the same in every run. */
export function chance(seed: number): (min: number, max: number) => number {
  let hash = pcg(seed);
  return (min, max) => {
    hash = pcg(hash + 1);
    return min + (max - min) * unit(hash);
  };
}
