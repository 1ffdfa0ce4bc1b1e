import type { Quality } from "../settings.js";
import type { IndirectDetail } from "./gi/probe-rays.js";

export interface Tier {
  readonly name: Exclude<Quality, "auto">;
  /** Share of the canvas's full resolution, along each axis. */
  readonly resolutionScale: number;
  /** Samples per pixel of forward shading. */
  readonly samples: number;
  readonly anisotropy: boolean;
  readonly physical: PhysicalTier;
}

/** Soft shadows. */
export interface ShadowQuality {
  /** Texels along an edge of the shadow cube. */
  readonly size: number;
  /** Taps of the blocker search, and of the filter. */
  readonly search: number;
  readonly taps: number;
  /** Texels by which a caster has to be nearer than the lit surface. */
  readonly bias: number;
}

export interface PhysicalTier {
  /** How surfaces are shaded: forward, by a G-buffer and lighting at a lower rate, or forward tile by tile. */
  readonly opaque: "forward" | "deferred" | "refined";
  readonly shadow: ShadowQuality;
  readonly indirect: IndirectDetail;
  /** Texels along an edge of the moon's map. */
  readonly moonMap: number;
  /** Standing candles that light the room. */
  readonly mostCandles: number;
  /** Largest error of shadow casters, metres. */
  readonly casterError: number;
  readonly bloomLevels: number;
  /** Steps of the ray march through the flame. */
  readonly flameSteps: number;
}

/** Indirect light of `low`, but for mirrors in motion, and of `medium`. */
const COARSE_INDIRECT: IndirectDetail = {
  surfels: 18,
  surfelGroup: 3,
  probes: [6, 4, 6],
  inset: 0.3,
  rays: 12,
  bounces: 12,
  mirrorsInMotion: true,
  isBanded: false,
};

/** Indirect light of `high` and `ultra`, which differ by their shadows and their resolution. */
const FINE_INDIRECT: IndirectDetail = {
  ...COARSE_INDIRECT,
  surfels: 24,
  surfelGroup: 4,
  probes: [14, 6, 14],
  inset: 0.2,
  rays: 16,
  bounces: 10,
};

/** What tiers of forward shading have in common, by the numbers of `high`. */
const FORWARD = {
  opaque: "forward",
  moonMap: 1024,
  mostCandles: 8,
  casterError: 0,
  bloomLevels: 6,
} as const;

const TIERS: Readonly<Record<Tier["name"], Tier>> = {
  low: {
    name: "low",
    resolutionScale: 2 / 3,
    samples: 4,
    anisotropy: false,
    physical: {
      opaque: "deferred",
      shadow: { size: 128, search: 4, taps: 8, bias: 1 },
      indirect: { ...COARSE_INDIRECT, mirrorsInMotion: false },
      moonMap: 1024,
      mostCandles: 4,
      casterError: 0.03,
      bloomLevels: 3,
      flameSteps: 12,
    },
  },
  medium: {
    name: "medium",
    resolutionScale: 1,
    samples: 2,
    anisotropy: true,
    physical: {
      ...FORWARD,
      shadow: { size: 512, search: 12, taps: 24, bias: 2.5 },
      indirect: COARSE_INDIRECT,
      casterError: 0.01,
      bloomLevels: 5,
      flameSteps: 24,
    },
  },
  high: {
    name: "high",
    resolutionScale: 1,
    samples: 4,
    anisotropy: true,
    physical: {
      ...FORWARD,
      shadow: { size: 512, search: 16, taps: 32, bias: 2.5 },
      indirect: FINE_INDIRECT,
      flameSteps: 40,
    },
  },
  ultra: {
    name: "ultra",
    resolutionScale: 1.5,
    samples: 4,
    anisotropy: true,
    physical: {
      ...FORWARD,
      shadow: { size: 1024, search: 24, taps: 48, bias: 2.5 },
      indirect: FINE_INDIRECT,
      moonMap: 2048,
      flameSteps: 64,
    },
  },
};

/** Errors of simplified casters while the camera moves, metres; by `low`'s shadows and surfels. */
export const MOTION_ERROR = { shadow: 0.05, surfels: 0.12 } as const;

/** Renderers that run on the CPU. */
const SOFTWARE = /SwiftShader|llvmpipe|Basic Render|Software/i;

export function isSoftware(renderer: string): boolean {
  return SOFTWARE.test(renderer);
}

export function tierNamed(name: Tier["name"]): Tier {
  return TIERS[name];
}
