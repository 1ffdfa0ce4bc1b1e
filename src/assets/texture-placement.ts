import { Flaw } from "./asset-error.js";
import type { JsonEntry } from "./json-entry.js";

/** Placement of a texture on a surface: its uv set, and the transform of that. */
export interface Placement {
  readonly uvSet: number;
  /** KHR_texture_transform: radians. */
  readonly rotation: number;
  readonly scale: readonly [number, number];
  readonly offset: readonly [number, number];
}

export const UNTURNED: Placement = { uvSet: 0, rotation: 0, scale: [1, 1], offset: [0, 0] };

export type TextureUse = Readonly<NonNullable<ReturnType<typeof readTextureUse>>>;

export function readTextureUse(entry: JsonEntry | undefined, textureCount: number) {
  const texture = entry?.index("index", textureCount);
  if (!entry || texture === undefined) return null;
  const transform = entry.extension("KHR_texture_transform");
  const [scaleU = 1, scaleV = 1] = transform?.numbers("scale", 2) ?? [];
  const [offsetU = 0, offsetV = 0] = transform?.numbers("offset", 2) ?? [];
  const placement: Placement = {
    uvSet: transform?.whole("texCoord") ?? entry.whole("texCoord") ?? 0,
    rotation: transform?.number("rotation") ?? 0,
    scale: [scaleU, scaleV],
    offset: [offsetU, offsetV],
  };
  return {
    texture,
    placement,
    /** A normal map's scale or an occlusion map's strength. */
    amount: entry.number("scale") ?? entry.number("strength") ?? 1,
  };
}

/** Texture coordinates with the placement's transform applied. */
export function placedUvs(uvs: Float32Array, { rotation, scale, offset }: Placement): Float32Array {
  const placed = new Float32Array(uvs.length);
  const cos = Math.cos(rotation);
  const sin = Math.sin(rotation);
  for (let i = 0; i < uvs.length; i += 2) {
    const u = (uvs[i] ?? 0) * scale[0];
    const v = (uvs[i + 1] ?? 0) * scale[1];
    placed[i] = cos * u + sin * v + offset[0];
    placed[i + 1] = cos * v - sin * u + offset[1];
  }
  if (!placed.every(Number.isFinite))
    throw new Flaw("has texture coordinates that are not numbers");
  return placed;
}
