import { logs } from "./materials/logs.mjs";

/** Every texture set, in the order of how much of the room it covers. */
export const materials = [logs];
