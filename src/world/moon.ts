import type { Vec3 } from "./geometry.js";

export interface Moon {
  /** Of a surface outside that faces it, lux. */
  readonly illuminance: number;
  /** In which its light goes, of length 1. */
  readonly direction: Vec3;
}

/** The page's settings of the moon; null leaves the room's. */
export interface MoonWish {
  readonly illuminance: number | null;
  readonly direction: Vec3 | null;
}

/** Of a clear night near full moon, lux. */
const FULL_MOON = 0.15;
/** Lowest place in the sky, degrees: light along the ground would enter no room. */
const LOWEST = 1;

/** Direction of the light of a moon that stands at an azimuth (0 along -Z, counter-clockwise) and an elevation, degrees. */
export function lightFrom(azimuth: number, elevation: number): Vec3 {
  const turn = (azimuth * Math.PI) / 180;
  const rise = (elevation * Math.PI) / 180;
  const level = Math.cos(rise);
  return [level * Math.sin(turn), -Math.sin(rise), level * Math.cos(turn)];
}

/** Of the built-in room: in the east, a little to the south, so that the cross of its window lies on floor and table. */
export const CABIN_MOON = lightFrom(-98, 27);

/** Direction of the light by azimuth and elevation in degrees, as text; null if it cannot be read. */
export function parseMoonPlace(text: string): Vec3 | null {
  const words = text.match(/[^\s,]+/g) ?? [];
  const [azimuth = Number.NaN, elevation = Number.NaN, ...rest] = words.map(Number);
  if (!Number.isFinite(azimuth) || !Number.isFinite(elevation) || rest.length > 0) return null;
  return lightFrom(azimuth % 360, Math.min(Math.max(elevation, LOWEST), 90));
}

/** @param own direction of the room's own moonlight; null where it has none */
export function moonOf({ illuminance, direction }: MoonWish, own: Vec3 | null): Moon | null {
  const wanted = illuminance ?? (own ? FULL_MOON : 0);
  if (!(wanted > 0)) return null;
  return { illuminance: wanted, direction: direction ?? own ?? CABIN_MOON };
}
