import type { Quality } from "../settings.js";

/** What a quality level buys. */
export interface Tier {
  readonly name: Exclude<Quality, "auto">;
  /** Share of the canvas's full resolution, along each axis. */
  readonly resolutionScale: number;
  /** Samples per pixel; 0 draws straight to the canvas. */
  readonly samples: number;
  readonly anisotropy: boolean;
}

const TIERS: Readonly<Record<Tier["name"], Tier>> = {
  low: { name: "low", resolutionScale: 2 / 3, samples: 4, anisotropy: false },
  medium: { name: "medium", resolutionScale: 1, samples: 2, anisotropy: true },
  high: { name: "high", resolutionScale: 1, samples: 4, anisotropy: true },
  ultra: { name: "ultra", resolutionScale: 1.5, samples: 4, anisotropy: true },
};

/** Renderers that run on the CPU. */
const SOFTWARE = /SwiftShader|llvmpipe|Basic Render|Software/i;

export function isSoftware(renderer: string): boolean {
  return SOFTWARE.test(renderer);
}

export function tierNamed(name: Tier["name"]): Tier {
  return TIERS[name];
}
