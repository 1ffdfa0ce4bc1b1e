import type { Features } from "../settings.js";
import type { Vec3 } from "../world/geometry.js";
import type { Particles } from "../world/particles/particles.js";
import { currentTime, type World } from "../world/world.js";

/** Point light: the flame of the paper's looks. */
export interface PointLight {
  /** Metres, in the room. */
  readonly position: Vec3;
  /** Linear Rec. 709; the paper's looks have no unit of light. */
  readonly color: Vec3;
  /** Whether it falls off with distance, by the paper's formula. */
  readonly attenuates: boolean;
}

/** The paper's warm light. */
const WARM = [2.0, 1.0, 0.5] as const;
/** Its "before": plain white, as bright to the eye. */
const WHITE = [1.2, 1.2, 1.2] as const;

/**
 * Flicker of the paper's looks, `I = I_base + ΔI sin(ωt)`.
 *
 * Far below what WCAG 2.3.1 calls a flash: ±4 % is less than half of its 10 % of full white.
 */
const FLICKER = 0.04;
/** rad/s */
const FLICKER_RATE = 2 * Math.PI * 2.3;

/** The particles that the light of a paper's look follows. */
export function sampleOf({ sample }: World): Particles {
  if (!sample) throw new Error("The paper's looks need a sample of particles.");
  return sample;
}

/** Light of the paper's flame as a share of its most. Particles give it as well: of a flame that is out they live on. */
export function shareOfLight(world: World): number {
  return Math.min(Math.max(world.flame.relativeLight, sampleOf(world).light), 1);
}

/** The light of the paper's flame, at the centre of its glowing particles. */
export function candleLight(world: World, features: Features, isStill: boolean): PointLight {
  const { setup } = world;
  const { flame } = world.interpolated;
  const burning = shareOfLight(world);
  if (world.look === "original") {
    const [x, y, z] = flame;
    return {
      position: [x, y + 0.3 * setup.flameScale, z],
      color: [WHITE[0] * burning, WHITE[1] * burning, WHITE[2] * burning],
      attenuates: false,
    };
  }
  const centre = sampleOf(world).centre([0, 0, 0]);
  const varies = features.flicker && !isStill;
  const flicker =
    burning * (varies ? 1 + FLICKER * Math.sin(FLICKER_RATE * currentTime(world)) : 1);
  return {
    position: [
      flame[0] + centre[0] * setup.flameScale,
      flame[1] + centre[1] * setup.flameScale,
      flame[2] + centre[2] * setup.flameScale,
    ],
    color: [WARM[0] * flicker, WARM[1] * flicker, WARM[2] * flicker],
    attenuates: features.attenuation,
  };
}
