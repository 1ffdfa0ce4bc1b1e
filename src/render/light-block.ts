import { captureOrigin, snapToGrid } from "../light/capture-origin.js";
import type { Rgb } from "../light/color.js";
import { carriedFlame, flameLight, TAPER } from "../light/flame-light.js";
import { fullHeight } from "../world/flame/burning.js";
import type { Vec3 } from "../world/geometry.js";
import type { World } from "../world/world.js";

/** Casters of the chamberstick, as discs: heights above its foot and radii, metres. */
export const CHAMBERSTICK = {
  rim: 0.2015,
  rimRadius: 0.0101,
  pan: 0.018,
  panRadius: 0.066,
} as const;

/**
 * Members of the shaders' `Light` block: the flame as a capsule. A hidden candle casts no shadow.
 *
 * @param emberFactor on an ember's light
 */
export function lightBlock(world: World, showsCandle: boolean, emberFactor?: number) {
  const { foot, flame } = world.interpolated;
  const height = fullHeight(world.flame.wick);
  const { axis: along, ...light } = flameLight(carriedFlame(world), TAPER, emberFactor);
  return {
    ...light,
    captureOrigin: captureOrigin(flame, light.position, height),
    along,
    axis: [foot[0], foot[2]],
    rim: foot[1] + CHAMBERSTICK.rim,
    rimRadius: showsCandle ? CHAMBERSTICK.rimRadius : 0,
    pan: foot[1] + CHAMBERSTICK.pan,
    panRadius: showsCandle ? CHAMBERSTICK.panRadius : 0,
    shadowSlot: 0,
  };
}

/** Of the carried flame, candela. */
export function flameIntensity(world: World): Rgb {
  return flameLight(carriedFlame(world), TAPER).intensity;
}

/** Members of the same block, for a flame of 1 cd in each channel. */
export interface CaptureLight extends Readonly<Record<string, number | readonly number[]>> {
  readonly position: Vec3;
}

/** The flame that the opaque stage shades for: 1 cd, in steps, so that flicker and small sway change nothing. */
export function shadingLight(
  world: World,
  showsCandle: boolean,
  { distance, axis }: { readonly distance: number; readonly axis: number },
): CaptureLight {
  const light = lightBlock(world, showsCandle);
  const step = (x: number) => Math.round(x / distance) * distance;
  const [x, y, z] = light.position;
  const along = light.along.map((share) => Math.round(share / axis) * axis);
  const length = Math.hypot(...along) || 1;
  return {
    ...light,
    position: [step(x), step(y), step(z)],
    halfHeight: step(light.halfHeight),
    intensity: [1, 1, 1],
    radius: step(2 * light.radius) / 2,
    along: along.map((share) => share / length),
  };
}

/** The flame at its capture origin: 1 cd, upright, on the grid of captures. */
export function captureLight(world: World, showsCandle: boolean): CaptureLight {
  const light = lightBlock(world, showsCandle);
  return {
    ...light,
    position: light.captureOrigin,
    halfHeight: snapToGrid(light.halfHeight),
    intensity: [1, 1, 1],
    along: [0, 1, 0],
    radius: snapToGrid(light.radius),
    axis: light.axis.map(snapToGrid),
    rim: snapToGrid(light.rim),
    pan: snapToGrid(light.pan),
  };
}
