import { flameRadius, fullHeight, TAPER_WICK } from "../world/flame/burning.js";
import type { Flame } from "../world/flame/flame.js";
import type { Vec3 } from "../world/geometry.js";
import type { World } from "../world/world.js";
import { sampleOf, shareOfLight } from "./candle-light.js";
import { adaptation, chromaticity, luma, type Rgb } from "./color.js";
import { BLUE, type FlameBody, flameBody } from "./flame-body.js";
import { createShape, shapeFlame } from "./flame-shape.js";
import { sootRadiance } from "./soot.js";

/** The flame as surfaces see it: a capsule, equally intense from all sides. */
export interface FlameLight {
  /** Centre of the light, metres. */
  readonly position: Vec3;
  /** Direction of the capsule's axis, of length 1, and half of its height, metres. */
  readonly axis: Vec3;
  readonly halfHeight: number;
  readonly radius: number;
  /** Candela, linear Rec. 709 whose luma is the luminous intensity. */
  readonly intensity: Vec3;
}

/** A flame and the place of its root, metres: the carried candle's or a standing one's. */
export interface RootedFlame {
  readonly root: Readonly<Vec3>;
  readonly flame: Flame;
}

/** The carried candle's, at the moment of the frame. */
export function carriedFlame(world: Pick<World, "interpolated" | "flame">): RootedFlame {
  return { root: world.interpolated.flame, flame: world.flame };
}

/** A good taper's flame, still: the candle that the candela was named after. */
export const TAPER: FlameBody = flameBody(fullHeight(TAPER_WICK), flameRadius(TAPER_WICK, 1), 1);
/** The eye's, to its light. */
export const ADAPTATION = adaptation(TAPER.color);

/**
 * Ember at the wick's tip: its height above the flame's root, m, and the area, m², that would give its light if all of it
 * glowed as the tip does: a wick of 1.8 mm by the profile of lib/ember.glsl.
 */
const EMBER_HEIGHT = 0.0066;
const EMBER_AREA = 1.5e-6;

const scratch = createShape();

/**
 * Light of the flame that is drawn from the same body, or of its ember.
 *
 * @param emberFactor on the latter
 */
export function flameLight(
  { root, flame }: RootedFlame,
  body: FlameBody,
  emberFactor = 1,
): FlameLight {
  const shape = shapeFlame(flame, body, scratch);
  const { centre, reach, sootIntensity, blueIntensity } = shape;
  const [x, y, z] = root;
  if (flame.glow === 0) {
    return {
      position: [x, y + EMBER_HEIGHT, z],
      axis: [0, 1, 0],
      halfHeight: 0.0005,
      radius: 0.001,
      intensity: emberIntensity(flame, emberFactor),
    };
  }
  const soot = body.sootColor;
  const halfHeight = Math.hypot(reach[0] ?? 0, reach[1] ?? 0, reach[2] ?? 0);
  const part = (axis: 0 | 1 | 2) => (reach[axis] ?? 0) / Math.max(halfHeight, 1e-9);
  const channel = (i: 0 | 1 | 2) => soot[i] * sootIntensity + BLUE[i] * blueIntensity;
  return {
    // A dying flame withdraws to the wick's tip; at its foot the candle's rim would hide it from all that is lower.
    position: [
      x + (centre[0] ?? 0),
      y + Math.max(centre[1] ?? 0, EMBER_HEIGHT),
      z + (centre[2] ?? 0),
    ],
    axis: [part(0), part(1), part(2)],
    halfHeight,
    radius: shape.radius * 0.8,
    intensity: [channel(0), channel(1), channel(2)],
  };
}

const fading = (temperature: number) => Math.exp((temperature - 1000) / 48);

/** Luminance of a page's white beside an ember, cd/m²: a sheet of paper in 40 lx, by lamplight. */
const PAGE_WHITE = 10;

/**
 * Factor on an ember over a page, whose white has far less luminance than the page that it stands for.
 *
 * @param exposure from cd/m² to the display's scale
 */
export const emberOverPage = (exposure: number): number => 1 / (PAGE_WHITE * exposure);

/** Radiance of the glowing wick, cd/m², times a factor. */
export function emberRadiance(temperature: number, factor = 1): Rgb {
  const glow = sootRadiance(Math.max(temperature, 1000));
  // Below 1000 K light falls by e for every 48 K. From 700 K on no eye sees any, however dark the room.
  const fade = temperature > 1000 ? 1 : Math.max(fading(temperature) - fading(700), 0);
  const scale = fade * factor;
  // No more blue for its green than the flame has: with more, an eye used to the flame would see pink.
  const blue = (glow[1] * TAPER.color[2]) / TAPER.color[1];
  return [glow[0] * scale, glow[1] * scale, Math.min(glow[2], blue) * scale];
}

/** Light of the ember, candela. */
export function emberIntensity({ ember }: Flame, factor = 1): Vec3 {
  const [red, green, blue] = emberRadiance(ember, EMBER_AREA * factor);
  return [red, green, blue];
}

/** State of the flame, as the property `flame` reports it: metres, candela, kelvin, radians. */
export interface FlameReport {
  readonly lit: boolean;
  /** Centre of the light. */
  readonly position: Vec3;
  readonly height: number;
  readonly width: number;
  readonly luminousIntensity: number;
  /** Share of the blue base, candela. */
  readonly blueIntensity: number;
  readonly colorTemperature: number;
  /** From the vertical. */
  readonly tilt: number;
}

/** Soot of a candle at rest glows as a black body of this temperature, kelvin: its emissivity goes as 1/λ. */
const COLOR_TEMPERATURE = 1880;

export function flameReport(rooted: RootedFlame): FlameReport {
  const { flame, root } = rooted;
  const { position, intensity } = flameLight(rooted, TAPER);
  const shape = scratch;
  return {
    lit: flame.isLit,
    position,
    height: flame.isLit ? shape.length : 0,
    width: flame.isLit ? 2 * shape.radius : 0,
    luminousIntensity: flame.glow > 0 ? shape.sootIntensity + shape.blueIntensity : luma(intensity),
    blueIntensity: flame.glow > 0 ? shape.blueIntensity : 0,
    colorTemperature: flame.glow > 0 ? correlatedTemperature(intensity) : flame.ember,
    tilt: flame.isLit ? tiltOf(root, position) : 0,
  };
}

/** Angle of the way from one place to another from the vertical, radians. */
function tiltOf([x, y, z]: Readonly<Vec3>, to: Readonly<Vec3>): number {
  return Math.atan2(Math.hypot(to[0] - x, to[2] - z), to[1] - y);
}

/** McCamy 1992, "Correlated color temperature as an explicit function of chromaticity coordinates". */
function correlatedTemperature(rgb: Rgb): number {
  const [u, v] = chromaticity(rgb);
  const x = (9 * u) / (6 * u - 16 * v + 12);
  const y = (4 * v) / (6 * u - 16 * v + 12);
  const n = (x - 0.332) / (0.1858 - y);
  return 449 * n ** 3 + 3525 * n ** 2 + 6823.3 * n + 5520.33;
}

/** The same of the paper's flame, which has no unit of light: its extent is that of its particles. */
export function paperFlameReport(world: World, position: Vec3): FlameReport {
  const { setup, interpolated, flame } = world;
  const { speed, buoyancy, life, size } = sampleOf(world).layer;
  const mean = (speed[0] + speed[1]) / 2;
  return {
    lit: flame.isLit,
    position,
    height: flame.isLit ? (mean * life + 0.5 * buoyancy * life * life) * setup.flameScale : 0,
    width: flame.isLit ? size * setup.flameScale : 0,
    luminousIntensity: shareOfLight(world),
    blueIntensity: 0,
    colorTemperature: COLOR_TEMPERATURE,
    tilt: flame.isLit ? tiltOf(interpolated.flame, position) : 0,
  };
}
