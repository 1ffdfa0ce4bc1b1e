import { type Tier, tierNamed } from "../quality.js";

const HIGH = tierNamed("high");

/** Tier of refinement at rest without a GPU: surfaces, flame and indirect light of `high`. */
export const REFINED: Tier = {
  ...HIGH,
  physical: {
    ...HIGH.physical,
    opaque: "refined",
    indirect: { ...HIGH.physical.indirect, isBanded: true },
    bloomLevels: 4,
  },
};
