import type { Texture } from "../../gl/gpu.js";
import type { Reprojection } from "./reprojection.js";

/** Defines of the shaders that include `lib/composite.glsl`, by the kind of G-buffer that they read. */
const KIND_DEFINES = {
  /** As fine as the canvas, supersampled. */
  full: { REDUCED: 0, REPROJECTED: 0 },
  /** Of fewer pixels, while the camera moves. */
  reduced: { REDUCED: 1, REPROJECTED: 0 },
  /** The reduced one of the previous frame, reprojected. */
  reprojected: { REDUCED: 1, REPROJECTED: 1 },
} as const;
export type GBufferKind = keyof typeof KIND_DEFINES;

export function forEachGBufferKind<T>(
  make: (defines: (typeof KIND_DEFINES)[GBufferKind]) => T,
): Readonly<Record<GBufferKind, T>> {
  return {
    full: make(KIND_DEFINES.full),
    reduced: make(KIND_DEFINES.reduced),
    reprojected: make(KIND_DEFINES.reprojected),
  };
}

/** Albedo, normal, roughness, material and depth of the visible surfaces. */
export interface GBuffer {
  readonly kind: GBufferKind;
  /** Gamma-2 albedo times normal-map shading. Alpha: the upsample guide, or whether the surface is held. */
  readonly albedo: Texture;
  /** Depth at the canvas's size. A reduced G-buffer leaves it to the composite to be written. */
  readonly frameDepth: Texture;
  /** For each sample: normal, roughness and material; depth. */
  readonly surface: Texture;
  readonly depth: Texture;
  /** Sample that represents each lighting texel; null for a reduced G-buffer. */
  readonly representative: Texture | null;
  /** Identifies the contents. */
  readonly key: string;
  /** From the current frame to the one before that was drawn for; null if there is none. */
  readonly history: Reprojection | null;
  /** Of a reduced one: from the centers of its texels to their samples, uv. */
  readonly sampleOffset: readonly [number, number];
}

/** A G-buffer at rest: samples along each edge of a pixel, and pixels that are filled in one step. */
export interface FullGBuffer {
  readonly samples: number;
  readonly pixelsPerStep: number;
}
