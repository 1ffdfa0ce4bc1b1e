import type { Gpu } from "../gl/gpu.js";
import type { SmokePass } from "../render/volumetric/smoke-pass.js";
import type { CreatePlume } from "../world/air/plume.js";

/** Smoke over a page. Its code is fetched when a first candle goes out: those that burn need none of it. */
export interface PageSmoke {
  readonly createPlume: CreatePlume;
  /** The pass that all candles of a context share; null until its code is there. */
  readonly smokePass: (gpu: Gpu) => SmokePass | null;
}

let plume: CreatePlume | null = null;
let makePass: ((gpu: Gpu) => SmokePass) | null = null;
let isAsked = false;
const passes = new WeakMap<Gpu, SmokePass>();

/** A candle whose code cannot be fetched goes out without smoke. */
function fetchCode(): void {
  if (isAsked) return;
  isAsked = true;
  import("./page-smoke-code.js").then(({ createPlume, SmokePass }) => {
    plume = createPlume;
    makePass = (gpu) => new SmokePass(gpu, true);
  }, console.warn);
}

export const PAGE_SMOKE: PageSmoke = {
  createPlume: (...birth) => {
    fetchCode();
    return plume?.(...birth) ?? null;
  },
  smokePass: (gpu) => {
    const pass = passes.get(gpu) ?? makePass?.(gpu) ?? null;
    if (pass) passes.set(gpu, pass);
    return pass;
  },
};
