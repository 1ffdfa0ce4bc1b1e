import type { Model } from "../assets/model.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import type { World } from "../world/world.js";
import type { FrameSettings } from "./frame-settings.js";

/** Models of a scene. */
export interface Models {
  readonly room: Model;
  readonly candle: Model;
}

/** What a renderer can do beside drawing frames, if it refines a picture at rest. */
export interface Refining {
  /** Tiles that are still those of the coarser picture. */
  readonly remaining: number;
  /** Goes on with captures of the light, `steps` of the settings at a time. True once they are done. */
  prepare(world: World, settings: FrameSettings): boolean;
  /** Begins with the last picture of a coarser renderer on the same `Gpu`, of the same view. */
  begin(world: World, settings: FrameSettings, coarse: Renderer): void;
}

/** Draws the world onto the canvas, for one family of looks. Created on a `Gpu`, which frees it. */
export interface Renderer {
  /** Null if each of its frames is complete. */
  readonly refining?: Refining | null;
  /** Particle slots in use in the last frame. */
  readonly particles: number;
  /** @param width of the canvas, pixels */
  resize(width: number, height: number): void;
  /** Replaces the particles by those of a new world, or of other layers. They catch up in the next frame. */
  setLayers(world: World, layers: readonly ParticleLayer[]): void;
  render(world: World, settings: FrameSettings): void;
  /** Linear RGB of the last frame, rows from the top, origin top left. Waits for the GPU. */
  readRadiance(x: number, y: number, width: number, height: number): Float32Array;
}
