import type { Tier } from "./render/quality.js";

/** Statistics of the last frame, as the property `stats` has them. */
export interface Stats {
  readonly fps: number;
  readonly frameMs: number;
  readonly cpuMs: number;
  readonly gpuMs: number | null;
  readonly drawCalls: number;
  readonly triangles: number;
  readonly particles: number;
  readonly width: number;
  readonly height: number;
  readonly resolutionScale: number;
  readonly quality: Tier["name"];
  /** Whether frames wait for a renderer that is being prepared; what reads the image then compiles it at once. */
  readonly preparing: boolean;
  readonly gpuObjects: number;
  readonly gpuBytes: number;
}

/** Before the first frame. */
export const NO_STATS: Stats = {
  fps: 0,
  frameMs: 0,
  cpuMs: 0,
  gpuMs: null,
  drawCalls: 0,
  triangles: 0,
  particles: 0,
  width: 0,
  height: 0,
  resolutionScale: 1,
  quality: "low",
  preparing: false,
  gpuObjects: 0,
  gpuBytes: 0,
};
