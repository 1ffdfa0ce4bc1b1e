import type { AutoQuality } from "../render/auto-quality.js";
import type { Size } from "../render/frame-input.js";
import type { FrameSettings } from "../render/frame-settings.js";
import { REFINED } from "../render/refinement/refined-tier.js";
import { RefinementBudget } from "../render/refinement/refinement-budget.js";
import type { InitialImage, Renderer, Surfaces } from "../render/renderer.js";
import type { ShadowCube } from "../render/shadow/shadow-pass.js";
import type { Steps } from "../world/steps.js";
import type { World } from "../world/world.js";
import type { CanvasTarget } from "./canvas-target.js";
import type { Scene } from "./scene.js";
import type { ViewSettings, ViewSubject } from "./view-subject.js";

/** Time that camera and candle have stood before the image is refined, seconds. */
const REST = 0.5;

/** Longest frame that had time left, seconds. */
const SHORT = 0.06;

/** Longest frame that may have waited for the display, seconds, and so many on end are none of a processor's. */
const DISPLAY = 0.0175;
const FAST_FRAMES = 12;

/** Least share of its light with which a flame burns well. */
const BURNING = 0.05;

/** What a refinement is of, at the moment. */
export interface RefinementParts {
  readonly scene: Pick<Scene, "prepareRenderer" | "createRenderer">;
  readonly target: CanvasTarget;
  readonly settings: ViewSettings;
  readonly auto: AutoQuality;
}

/**
 * Refinement of an image at rest: a second renderer, of `high`'s surfaces at the canvas's full resolution, which
 * takes over from a coarser one and replaces its image tile by tile.
 *
 * It is made while the camera first rests, a little in each frame, and kept.
 */
export class Refinement {
  readonly tier = REFINED;
  readonly #parts: () => RefinementParts;
  #budget = new RefinementBudget();
  #renderer: Renderer | null = null;
  #isCompiled = false;
  #size: Size | null = null;
  /** Time of the last frame, and time that camera and candle have stood, seconds. */
  #frame = 0;
  #rest = 0;
  /** Frames on end that waited for the display. */
  #fast = 0;
  /** Whether the last frame was one at rest. */
  #isWanted = false;
  /** What it is to begin with, in progress: the surfaces, and their light. */
  #initial: InitialImage | null = null;
  #isFilled = false;
  #shading: Steps<Surfaces> | null = null;
  #isPrepared = false;
  #hasBegun = false;
  #isShown = false;
  /** Whether it has failed: it is tried again with another tier's renderer, or another context. */
  #isGivenUp = false;
  /** What the image is of, beside places: its lights, and settings. */
  #key = "";

  constructor(parts: () => RefinementParts) {
    this.#parts = parts;
  }

  /** The renderer of what is shown; null if that is the coarser one. */
  get shown(): Renderer | null {
    return this.#isShown ? this.#renderer : null;
  }

  /** Whether frames do its work beside their own, or are its own: their time says nothing of the coarser one's. */
  get isBusy(): boolean {
    return this.#isWanted && (this.#isReady || !this.#isCompiled);
  }

  get #isReady(): boolean {
    return this.#isCompiled && this.#rest >= REST;
  }

  /**
   * Key of the lights that an image is refined in: which candles burn, as whose moonlight counts; or the moon, once the
   * eye is used to it. Null while a candle catches or goes out.
   */
  lightsOf({ flame, standing, moon, adaptation }: World): string | null {
    const glows = [flame.glow, ...standing.map((candle) => candle.flame.glow)];
    if (glows.some((glow) => glow > 0 && glow <= BURNING)) return null;
    if (moon === null || glows.some((glow) => glow > 0)) return `${glows.map((glow) => glow > 0)}`;
    return adaptation?.darkness === 1 ? "moon" : null;
  }

  /** Takes the time from one frame to the next, seconds. */
  take(seconds: number): void {
    if (!(seconds > 0)) return;
    this.#frame = seconds;
    this.#rest += seconds;
    if (this.#isShown) this.#parts().auto.rise();
    this.#fast = seconds < DISPLAY ? this.#fast + 1 : 0;
    if (this.#fast === FAST_FRAMES) void this.#parts().auto.remeasure();
    // Frames that refine nothing say nothing of its cost.
    if (this.#isReady || this.#initial) this.#budget.take(seconds);
  }

  /**
   * Camera or candle move, or frames do not follow each other.
   *
   * @param next renders the next frame, and begins with what was shown
   */
  stop(next: Renderer | null = null): void {
    const image = this.shown?.refining?.display.image();
    if (image) next?.refinedFade?.begin(image);
    this.#rest = 0;
    this.#isWanted = false;
    this.#budget = new RefinementBudget();
    if (this.#initial && !this.#hasBegun && !this.#parts().target.gpu.isLost) {
      this.#initial.release();
    }
    this.#initial = null;
    this.#isFilled = false;
    this.#shading = null;
    this.#isPrepared = false;
    this.#hasBegun = false;
    this.#isShown = false;
  }

  /** The renderer was freed, with all else of its tier. */
  forget(): void {
    this.#initial = null;
    this.stop();
    this.#renderer = null;
    this.#isCompiled = false;
    this.#size = null;
    this.#isGivenUp = false;
  }

  /** The coarser renderer goes on alone. */
  #giveUp(error: unknown): void {
    console.warn(error);
    this.stop();
    this.forget();
    this.#isGivenUp = true;
  }

  /** Another world, or other particles. */
  follow({ world, layers }: ViewSubject): void {
    this.#renderer?.setLayers(world, layers);
  }

  /**
   * A frame at rest. What the driver refuses is given up, with a warning.
   *
   * @param size of the canvas at its full resolution
   * @returns steps of the refinement that the frame does; null if it draws nothing else
   */
  advance(...frame: [ViewSubject, FrameSettings, coarse: Renderer, size: Size]): number | null {
    if (this.#isGivenUp) return 0;
    try {
      return this.#advance(...frame);
    } catch (error) {
      if (this.#parts().target.gpu.isLost) throw error;
      this.#giveUp(error);
      return 0;
    }
  }

  #advance(subject: ViewSubject, view: FrameSettings, coarse: Renderer, size: Size): number | null {
    const { world } = subject;
    const { features, exposure } = view;
    const key = JSON.stringify([this.lightsOf(world), features, exposure, world.flame.wick]);
    if (key !== this.#key) this.stop();
    this.#key = key;
    this.#isWanted = true;
    if (!this.#renderer) {
      const { scene, target, settings } = this.#parts();
      const prepare = () => scene.prepareRenderer(target, REFINED, settings);
      // Two parts in a frame, a few milliseconds each; one where drivers compile while the page waits.
      if (prepare() || (this.#frame <= SHORT && prepare())) this.#create(subject);
    }
    if (this.#rest < REST) return 0;
    const steps = this.#budget.next();
    // While programs are compiled, too.
    this.#initial ??= coarse.initialImage?.(world, view, size) ?? null;
    if (!this.#initial) return 0;
    const { fill } = this.#initial;
    for (let step = 0; step < steps && !this.#isFilled; step++) {
      this.#isFilled = fill.next().done === true;
    }
    const refining = this.#renderer?.refining;
    if (!this.#isFilled || steps === 0 || !this.#renderer || !refining) return 0;
    if (this.#isShown) {
      if (!this.#isPrepared) {
        this.#isPrepared = refining.prepare(world, { ...view, steps });
        if (this.#isPrepared) this.#budget = new RefinementBudget(); // a tile is dearer
        return refining.isCompiling ? null : 0;
      }
      return refining.remaining > 0 ? steps : 0;
    }
    if (!this.#hasBegun) {
      this.#shading ??= this.#shade(this.#initial, refining.shadow(world, view));
      const { done, value } = this.#shading.next();
      if (!done) return 0;
      if (this.#size?.width !== size.width || this.#size.height !== size.height) {
        this.#renderer.resize(size.width, size.height);
        this.#size = size;
      }
      refining.begin(world, view, value);
      this.#hasBegun = true;
      this.#initial.release();
      return 0;
    }
    this.#isShown = refining.drawFirst(world, { ...view, steps: 0 });
    if (this.#isShown) this.#budget = new RefinementBudget(); // its own frames are dearer
    return 0;
  }

  /** Its shadows are captured while programs are compiled. Beside a flame it keeps the coarser one's moon. */
  *#shade(initial: InitialImage, shadow: Steps<ShadowCube>): Steps<Surfaces> {
    const cube = yield* shadow;
    while (!this.#isReady || initial.isMoonOutdated) yield;
    return yield* initial.shade(cube);
  }

  #create(subject: ViewSubject): void {
    const { scene, target, settings } = this.#parts();
    const { gpu } = target;
    const renderer = scene.createRenderer(target, REFINED, settings.look);
    this.#renderer = renderer;
    this.follow(subject);
    const isOn = () => this.#renderer === renderer && !gpu.isLost;
    const finish = () => {
      if (!isOn()) return;
      gpu.finishPrograms(); // now: later each would wait for what is being drawn
      this.#isCompiled = true;
    };
    gpu
      .whenCompiled(3)
      .then(finish)
      .catch((error: unknown) => isOn() && this.#giveUp(error));
  }
}
