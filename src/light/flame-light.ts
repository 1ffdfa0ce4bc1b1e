import type { Vec3 } from "../world/bounds.js";
import type { World } from "../world/world.js";
import { type FlameBody, flameBody } from "./flame-body.js";

/** The flame as surfaces see it: an upright capsule, equally intense from all sides. */
export interface FlameLight {
  /** Centre of the light, metres. */
  readonly position: Vec3;
  /** Metres. */
  readonly halfHeight: number;
  readonly radius: number;
  /** Candela, linear Rec. 709 whose luma is the luminous intensity. */
  readonly intensity: Vec3;
}

/** A good taper's flame: 35 mm high, 8 mm wide, the candle that the candela was named after. */
export const TAPER: FlameBody = flameBody(0.038, 0.0042, 1);

/** What the flame, drawn from the same body, is to the room. */
export function flameLight({ shown }: World, body: FlameBody): FlameLight {
  const [x, y, z] = shown.flame;
  const { color, luminousIntensity } = body;
  return {
    position: [x, y + body.centre, z],
    halfHeight: body.height * 0.36,
    radius: body.radius * 0.8,
    intensity: [
      color[0] * luminousIntensity,
      color[1] * luminousIntensity,
      color[2] * luminousIntensity,
    ],
  };
}
