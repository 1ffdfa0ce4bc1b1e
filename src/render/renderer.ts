import type { Model } from "../assets/model.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import type { World } from "../world/world.js";
import type { FrameSettings } from "./frame-settings.js";

/** What a look's picture is made of. */
export interface Models {
  readonly room: Model;
  readonly candle: Model;
}

/** A family of looks: turns the world into pixels on the canvas. Born on a `Gpu`, which frees it. */
export interface Renderer {
  /** Particle slots at work in the last frame. */
  readonly particles: number;
  /** The picture's size in pixels; the canvas has it already. */
  resize(width: number, height: number): void;
  /** Other particles: those of a new world, or more of them. They catch up in the next frame. */
  setParticles(world: World, layers: readonly ParticleLayer[]): void;
  render(world: World, settings: FrameSettings): void;
  /** Linear RGB of the picture just drawn, rows from the top, origin top left. Waits for the GPU. */
  readRadiance(x: number, y: number, width: number, height: number): Float32Array;
}
