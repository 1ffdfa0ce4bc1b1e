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

/** The flame as its page may ask about it. SI: metres, candela, kelvin, radians. */
export interface FlameReport {
  readonly lit: boolean;
  /** Centre of the light. */
  readonly position: Vec3;
  readonly height: number;
  readonly width: number;
  readonly luminousIntensity: number;
  readonly colorTemperature: number;
  /** From the vertical. */
  readonly tilt: number;
}

/** Soot glows as a black body of this temperature, kelvin: its emissivity goes as 1/λ. */
const COLOR_TEMPERATURE = 1880;

export function flameReport(world: World): FlameReport {
  const { position } = flameLight(world, TAPER);
  return {
    lit: true,
    position,
    height: TAPER.height,
    width: 2 * TAPER.radius,
    luminousIntensity: TAPER.luminousIntensity,
    colorTemperature: COLOR_TEMPERATURE,
    tilt: 0,
  };
}

/** The same of the paper's flame, which has no unit of light: its extent is that of its particles. */
export function paperFlameReport(world: World, position: Vec3): FlameReport {
  const { stage, shown, sample } = world;
  const [dx, dy, dz] = [0, 1, 2].map((axis) => (position[axis] ?? 0) - (shown.flame[axis] ?? 0));
  const { speed, buoyancy, life, size } = sample.layer;
  const mean = (speed[0] + speed[1]) / 2;
  return {
    lit: true,
    position,
    height: (mean * life + 0.5 * buoyancy * life * life) * stage.flameScale,
    width: size * stage.flameScale,
    luminousIntensity: 1,
    colorTemperature: COLOR_TEMPERATURE,
    tilt: Math.atan2(Math.hypot(dx ?? 0, dz ?? 0), dy ?? 1),
  };
}
