import type { Model } from "../assets/model.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import type { World } from "../world/world.js";
import type { FrameSettings } from "./frame-settings.js";

/** Models of a scene. */
export interface Models {
  readonly room: Model;
  readonly candle: Model;
}

/** Draws the world onto the canvas, for one family of looks. Created on a `Gpu`, which frees it. */
export interface Renderer {
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
