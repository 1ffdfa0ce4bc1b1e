import type { Vec3 } from "../geometry.js";
import { Plume } from "./plume.js";
import { coarsePlumeGrid } from "./plume-grid.js";

/** Makes the plume of a flame at a foot, metres; for standing candles on a coarse grid. */
export type CreatePlume = (seed: number, foot: Readonly<Vec3>, isCoarse: boolean) => Plume;

export const createPlume: CreatePlume = (seed, foot, isCoarse) =>
  new Plume(seed, foot, isCoarse ? coarsePlumeGrid() : undefined);
