import type { Gpu } from "../gl/gpu.js";
import type { SmokePass } from "../render/volumetric/smoke-pass.js";
import type { CreatePlume } from "../world/air/plume.js";

// Smoke over a page. Its code is fetched when a first candle goes out: those that burn need none of it.

/** Milliseconds from a failure to fetch it to the next attempt, which a smoking wick may be asking for in each step. */
const PAUSE = 3000;

let code: typeof import("./page-smoke-code.js") | null = null;
let fetching: Promise<void> | null = null;
const passes = new WeakMap<Gpu, SmokePass>();

/** Fetches the code; without it a candle goes out without smoke. */
export function fetchPageSmoke(): Promise<void> {
  const missed = (error: unknown) => {
    console.warn(error);
    setTimeout(() => {
      fetching = null;
    }, PAUSE);
  };
  fetching ??= import("./page-smoke-code.js").then((fetched) => {
    code = fetched;
  }, missed);
  return fetching;
}

export const createPageSmoke: CreatePlume = (...birth) => {
  void fetchPageSmoke();
  return code?.createPlume(...birth) ?? null;
};

/** The pass that all candles of a context share; null until its code is there. */
export function pageSmokePass(gpu: Gpu): SmokePass | null {
  const pass = passes.get(gpu) ?? (code && new code.SmokePass(gpu, true));
  if (pass) passes.set(gpu, pass);
  return pass;
}
