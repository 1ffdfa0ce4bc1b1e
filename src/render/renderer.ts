import type { Model } from "../assets/model.js";
import type { Box, Texture } from "../gl/gpu.js";
import type { ParticleLayer } from "../world/particles/particle-layer.js";
import type { Steps } from "../world/steps.js";
import type { World } from "../world/world.js";
import type { Size } from "./frame-input.js";
import type { FrameSettings } from "./frame-settings.js";
import type { Captures } from "./gi/light-captures.js";
import type { RefinedFade } from "./refinement/refined-fade.js";
import type { RefinedStage } from "./refinement/refined-stage.js";
import type { ShadowCube } from "./shadow/shadow-pass.js";

export interface Models {
  readonly room: Model;
  readonly candle: Model;
}

/** Surfaces without media: radiance in cd/m², its depth, and captures of its light. */
export interface Surfaces {
  readonly radiance: Texture;
  readonly depth: Texture;
  readonly captures: Captures;
}

/** Surfaces of an image at rest, drawn in steps. */
export interface InitialImage {
  /** All that does not depend on the light. */
  readonly fill: Steps<unknown>;
  /** Whether the coarser renderer's moon is not the world's yet. Its frames go on with that. */
  readonly isMoonOutdated: boolean;
  /** After it: the surfaces in the light of that moment, with shadows by that cube. */
  shade(shadow: ShadowCube): Steps<Surfaces>;
  release(): void;
}

/** Draws the world onto the canvas, for one family of looks. Created on a `Gpu`, which frees it. */
export interface Renderer {
  /** Of an image at rest; null if each of its frames is complete. */
  readonly refining?: RefinedStage | null;
  /** Whether the last frame drew what later ones keep, so that it took longer than they will. */
  readonly isCatchingUp?: boolean;
  /** Particle slots in use in the last frame. */
  readonly particles: number;
  /** Surfaces at another size than the canvas's; absent where there are none to begin a refinement with. */
  initialImage?(world: World, settings: FrameSettings, size: Size): InitialImage;
  /** Fades from a refined image, which is drawn to the whole of a canvas at its full resolution. */
  readonly refinedFade?: RefinedFade | null;
  /** @param width of the canvas, pixels */
  resize(width: number, height: number): void;
  /** Replaces the particles by those of a new world, or of other layers. They catch up in the next frame. */
  setLayers(world: World, layers: readonly ParticleLayer[]): void;
  /**
   * Draws what a frame at rest keeps for the next ones, in small tasks and as long as it is wanted, so that little is left
   * for the first `render`. Absent where that is quick.
   */
  prepare?(world: World, settings: FrameSettings, isWanted: () => boolean): Promise<void>;
  render(world: World, settings: FrameSettings): void;
  /** Linear RGB of the last frame, rows from the top, origin top left. Waits for the GPU. */
  readRadiance(box: Box): Float32Array;
}
