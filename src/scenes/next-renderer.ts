import type { Gpu } from "../gl/gpu.js";
import type { Rung } from "../render/auto-quality.js";
import { canvasSize, longestSide } from "../render/canvas-size.js";
import type { Size } from "../render/frame-input.js";
import type { FrameSettings } from "../render/frame-settings.js";
import type { Tier } from "../render/quality.js";
import type { Renderer } from "../render/renderer.js";
import { tierOf } from "./asked-quality.js";
import type { RefinementParts } from "./refinement.js";
import type { ViewSubject } from "./view-subject.js";

/** What a renderer is prepared for, at the moment. */
export interface NextParts extends RefinementParts {
  readonly subject: ViewSubject;
  /** Of the canvas at full resolution. */
  readonly pixels: Size;
  /** A frame like the last one, at rest; null before that. */
  readonly frame: FrameSettings | null;
}

/** A renderer of that tier, for frames of that size. */
export interface PreparedRenderer {
  readonly renderer: Renderer;
  readonly tier: Tier["name"];
  readonly size: Size;
}

/**
 * The renderer of another tier, made and prepared in tasks between the frames of the one before, which goes on: on many
 * drivers the first frame of a tier takes half a second.
 */
export class NextRenderer {
  readonly #parts: () => NextParts;
  #made: PreparedRenderer | null = null;
  #isPrepared = false;
  /** What was made for it, as long as it is wanted. */
  #objects: Gpu["ahead"] | null = null;

  constructor(parts: () => NextParts) {
    this.#parts = parts;
  }

  /** Whether its work is done beside the frames, so that their time says nothing. */
  get isBusy(): boolean {
    const { gpu } = this.#parts().target;
    return gpu.ahead === this.#objects && !gpu.isLost;
  }

  /** Another world, or other particles. */
  follow({ world, layers }: ViewSubject): void {
    const { gpu } = this.#parts().target;
    gpu.isAhead = this.isBusy;
    if (gpu.isAhead) this.#made?.renderer.setLayers(world, layers);
    gpu.isAhead = false;
  }

  /** Begins, or goes on. True once that rung's is prepared. A tier that the driver refuses is given up, with a warning. */
  proceed(rung: Rung): boolean {
    if (this.isBusy) return this.#isPrepared;
    const { scene, target, settings, auto } = this.#parts();
    const tier = tierOf(rung.tier, "auto", auto);
    if (scene.prepareRenderer(target, tier, settings)) {
      const objects = target.gpu.ahead;
      this.#prepare(tier, rung.share).catch((error: unknown) => {
        // Not of one that was given up, or that a lost context took.
        if (!this.isBusy || objects !== this.#objects) return;
        console.warn(error);
        auto.refuse(tier.name);
        target.gpu.clearUnshared(true);
      });
    }
    return false;
  }

  async #prepare(tier: Tier, share: number): Promise<void> {
    const { scene, target, settings, subject, pixels, frame } = this.#parts();
    const { gpu } = target;
    const scale = tier.resolutionScale * share;
    const size = canvasSize(pixels, scale, longestSide(gpu, tier));
    this.#isPrepared = false;
    this.#objects = gpu.ahead;
    gpu.isAhead = true;
    const renderer = scene.createRenderer(target, tier, settings.look);
    renderer.resize(size.width, size.height);
    const made = { renderer, tier: tier.name, size };
    this.#made = made;
    this.follow(subject);
    // Asked before each step, and what a step makes is this renderer's.
    const isOn = () => {
      gpu.isAhead = this.isBusy && this.#made === made;
      return gpu.isAhead;
    };
    await gpu.whenCompiled();
    if (!isOn()) return;
    gpu.finishPrograms();
    gpu.check("picture");
    if (frame) await renderer.prepare?.(subject.world, frame, isOn);
    await gpu.whenIdle();
    if (!isOn()) return;
    gpu.check("picture");
    this.#isPrepared = true;
    gpu.isAhead = false;
  }

  /** The renderer of a tier, if it is prepared, to take over: all else that is not shared is then freed. */
  take(tier: Tier["name"]): PreparedRenderer | null {
    if (this.isBusy && this.#isPrepared && this.#made?.tier === tier) return this.#made;
    this.#parts().target.gpu.clearUnshared(true);
    return null;
  }
}
