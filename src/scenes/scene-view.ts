import { noCounts } from "../gl/frame-counts.js";
import type { Box } from "../gl/gpu.js";
import { AutoQuality } from "../render/auto-quality.js";
import { canvasSize, longestSide } from "../render/canvas-size.js";
import type { Size } from "../render/frame-input.js";
import { atRest, type FrameSettings } from "../render/frame-settings.js";
import type { Renderer } from "../render/renderer.js";
import type { Inspection } from "../settings.js";
import { type AskedQuality, askedQuality } from "./asked-quality.js";
import type { CanvasTarget } from "./canvas-target.js";
import type { NextRenderer, PreparedRenderer } from "./next-renderer.js";
import type { Refinement } from "./refinement.js";
import type { Scene } from "./scene.js";
import { type ViewFrame, type ViewSettings, type ViewSubject, workOf } from "./view-subject.js";

/**
 * View of a scene on a canvas: its renderer, at the tier and the resolution that `quality` asks for.
 *
 * The renderer is replaced with its tier and with the WebGL context; the view stays.
 */
export class SceneView {
  /** What is shown of each frame. */
  inspect: Inspection = "picture";
  /** Whether frames follow each other, or will after the first. */
  isPlaying: boolean;
  /** Called when frames are of another tier or resolution than before. */
  onQualityChanged: () => void = () => {};
  /** Called when a frame was drawn to the canvas, in the same task. */
  onDrawn: () => void = () => {};
  /** Called when the driver refused what a renderer needs. */
  onRefused: (error: Error) => void = () => {};
  readonly #target: CanvasTarget;
  #scene: Scene;
  #settings: ViewSettings;
  #subject: ViewSubject;
  /** Of the quality `auto`. */
  readonly auto: AutoQuality;
  #quality: AskedQuality;
  #renderer: Renderer;
  /** Of what `auto` shows of a room at rest on machines without a GPU. */
  #refinement: Refinement | null = null;
  #next: NextRenderer | null = null;
  /** Of the renderer's frames. */
  #frameSize: Size | null = null;
  /** CSS size times device pixel ratio, before the tier's scale. */
  #pixels = { width: 1, height: 1 };
  /** Whether targets and textures were made since the driver was last asked whether it accepts them. */
  #isUnchecked = false;
  /** What prepares or checks the first frame: meanwhile the animation loop draws nothing, and a query would block. */
  #busy: object | null = null;
  readonly #counts = noCounts();
  /** Settings of the last frame. */
  #last: ViewFrame | null = null;

  /** @param target from now on this disposes of it */
  constructor(
    target: CanvasTarget,
    scene: Scene,
    settings: ViewSettings,
    subject: ViewSubject,
    plays: boolean,
    auto = new AutoQuality(workOf(scene, settings)),
  ) {
    this.#target = target;
    this.#scene = scene;
    this.#settings = settings;
    this.#subject = subject;
    this.isPlaying = plays;
    this.auto = auto;
    this.#quality = this.#asked;
    this.#createFollowing();
    this.#renderer = this.#createRenderer();
  }

  #createFollowing(): void {
    const parts = () => ({
      scene: this.#scene,
      target: this.#target,
      settings: this.#settings,
      subject: this.#subject,
      pixels: this.#pixels,
      auto: this.auto,
      frame: this.#last && this.#settingsOf(atRest(this.#last)),
    });
    this.#refinement = this.#scene.createRefinement?.(parts) ?? null;
    this.#next = this.#scene.createNext?.(parts) ?? null;
  }

  /** Another world, or other particles: the renderer's catch up in the next frame. */
  follow(subject: ViewSubject): void {
    this.#subject = subject;
    const { gpu } = this.#target;
    if (gpu.isLost) return; // the renderer to come will
    gpu.isAhead = false; // the next renderer's steps follow later
    this.#renderer.setLayers(subject.world, subject.layers);
    this.#refinement?.follow(subject);
    this.#next?.follow(subject);
  }

  /** To be followed by `rebuild` if the quality or the models are others. */
  set settings(settings: ViewSettings) {
    const isSameMoon = JSON.stringify(settings.moon) === JSON.stringify(this.#settings.moon);
    if (!isSameMoon) this.#refinement?.stop();
    this.#settings = settings;
    this.auto.work = workOf(this.#scene, settings);
  }

  /** Another scene on the same canvas. */
  show(scene: Scene, settings: ViewSettings, subject: ViewSubject): void {
    this.#scene = scene;
    this.#createFollowing();
    this.settings = settings;
    this.auto.renew();
    this.#subject = subject;
    this.rebuild();
  }

  rebuild(): void {
    if (this.#target.gpu.isLost) return; // it is rebuilt once the context is restored
    this.#target.clear();
    this.#replaceRenderer();
  }

  /** @param next prepared for the tier to come; else it is made, and prepared while frames follow each other */
  #replaceRenderer(next?: PreparedRenderer | null): void {
    const before = this.#quality;
    this.#quality = this.#asked;
    const { tier, share } = this.#quality;
    this.#target.clearUnshared();
    this.#refinement?.forget();
    this.#renderer.refinedFade?.end();
    this.#frameSize = next?.size ?? null;
    this.#renderer = next?.renderer ?? this.#createRenderer();
    this.#fitRenderer();
    if (before.tier.name !== tier.name || before.share !== share) this.onQualityChanged();
    if (next || !this.isPlaying || !this.#last) return;
    this.prepareFrame(atRest(this.#last), () => true).catch(this.onRefused);
  }

  /** The first frame is to be prepared, if time will pass. */
  restore(plays: boolean): void {
    this.isPlaying = plays;
    this.#last = null;
    this.#target.renew();
    this.auto.renew(true);
    this.rebuild();
  }

  /**
   * Device pixels that the element covers. The canvas keeps its frame until the next one is drawn.
   *
   * @returns whether that one may have another size
   */
  resize(width: number, height: number): boolean {
    if (width === this.#pixels.width && height === this.#pixels.height) return false;
    this.#busy = null;
    this.#pixels = { width, height };
    this.auto.pixels = width * height;
    this.auto.renew();
    this.#refinement?.stop();
    this.#renderer.refinedFade?.end();
    const { gpu } = this.#target;
    gpu.clearUnshared(true);
    if (!gpu.isLost) this.#fitRenderer();
    return true;
  }

  /** Whether the animation loop has nothing to draw with yet. */
  get isBusy(): boolean {
    return this.#busy !== null;
  }

  /**
   * Compiles a new renderer's programs, and draws what its next frame keeps for further ones, in small tasks, as long as
   * it is wanted, of this size, and not drawn or replaced. Throws if something is refused.
   */
  async prepareFrame(view: ViewFrame, isWanted: () => boolean): Promise<void> {
    const renderer = this.#renderer;
    const { gpu } = this.#target;
    const task = {};
    this.#busy = task;
    const isOn = () => isWanted() && this.#busy === task && !gpu.isLost;
    try {
      await gpu.whenCompiled();
      if (!isOn()) return;
      gpu.finishPrograms();
      gpu.check("picture");
      await renderer.prepare?.(this.#subject.world, this.#settingsOf(view), isOn);
    } finally {
      if (this.#busy === task) this.#busy = null;
    }
  }

  #settingsOf(view: ViewFrame): FrameSettings {
    return { ...view, gamut: this.#target.gamut, inspect: this.inspect };
  }

  /** Draws a frame and shows it; unless it is required, none while a renderer is prepared. None without a context. */
  render(view: ViewFrame, isRequired?: boolean): void {
    const target = this.#target;
    this.#last = view;
    const { gpu } = target;
    if (gpu.isLost) return;
    gpu.isAhead = false;
    const before = this.#refinement?.shown;
    const refining = this.#refines(view) ? this.#refinement : null;
    if (!refining) this.#refinement?.stop(view.isMoving ? this.#renderer : null);
    if (!this.#chooseQuality(view) && !isRequired) return;
    this.#busy = null; // a suspended preparation would go on in what is drawn now
    const settings = this.#settingsOf(view);
    gpu.beginFrame(this.#counts);
    const size = this.#sizeAt(refining?.tier.resolutionScale ?? 1);
    const steps =
      refining && !isRequired ? refining.advance(this.#subject, settings, this.#renderer, size) : 0;
    if (steps !== null) {
      this.#fitCanvas();
      target.prepare();
      if (before !== this.#refinement?.shown) this.onQualityChanged();
      this.#shown.render(this.#subject.world, { ...settings, steps });
      target.present();
      this.onDrawn();
    }
    gpu.endFrame();
    if (this.#isUnchecked) this.#check().catch(this.onRefused);
  }

  /** Takes the time of a frame of the animation loop, by which `auto` goes. Seconds. */
  measure(seconds: number): void {
    if (this.#settings.quality !== "auto" || this.isBusy) return;
    this.#refinement?.take(seconds);
    this.#renderer.refinedFade?.take(seconds);
    const { refinedFade, isCatchingUp } = this.#renderer;
    if (this.#refinement?.isBusy || refinedFade?.isOn || isCatchingUp) return;
    if (!this.#next?.isBusy) this.auto.take(seconds, this.#counts.seconds);
    const { wanted } = this.auto;
    if (wanted && (this.#next?.proceed(wanted) ?? true)) this.auto.accept();
  }

  /** Linear RGB of the last frame before exposure and tone mapping; rows from the top. Waits for the GPU. */
  readRadiance(box: Box): Float32Array {
    return this.#shown.readRadiance(box);
  }

  get stats() {
    const { objectCount, bytes } = this.#target.gpu;
    const { seconds, ...counts } = this.#counts;
    return {
      gpuMs: seconds === null ? null : 1000 * seconds,
      ...counts,
      particles: this.#shown.particles,
      // As chosen: after a change of the quality the canvas keeps its size until the next frame.
      ...this.#sizeAt(this.#resolutionScale),
      resolutionScale: this.#resolutionScale,
      quality: (this.#refinement?.shown ? this.#refinement : this.#quality).tier.name,
      preparing: this.isBusy || this.#asked.tier.name !== this.#quality.tier.name,
      gpuObjects: objectCount,
      gpuBytes: bytes,
    };
  }

  dispose(): void {
    this.#busy = null; // what is prepared or asked ends with it
    this.#target.dispose();
  }

  get #asked() {
    return askedQuality(this.#settings.quality, this.auto, this.isPlaying, this.inspect);
  }

  /** Changes to the tier and the resolution of the next frame. Whether it is drawn now: preparing a tier takes time. */
  #chooseQuality({ canDefer }: ViewFrame): boolean {
    const { tier, share } = this.#asked;
    if (tier.name !== this.#quality.tier.name) {
      this.#replaceRenderer(this.#next?.take(tier.name));
      return !(canDefer && this.isBusy);
    }
    if (share === this.#quality.share) return true;
    this.#quality = { ...this.#quality, share };
    this.#renderer.refinedFade?.end();
    this.#fitRenderer();
    if (!this.#refinement?.shown) this.onQualityChanged();
    return true;
  }

  /** The canvas keeps its frame until the next one is drawn, which may be of another size. */
  #createRenderer(): Renderer {
    const { tier } = this.#quality;
    this.#renderer = this.#scene.createRenderer(this.#target, tier, this.#settings.look);
    this.#fitRenderer();
    this.#busy = null;
    this.follow(this.#subject);
    return this.#renderer;
  }

  /** Gives the renderer's frames their size. The canvas has another one while a refined image is shown. */
  #fitRenderer(): void {
    const { width, height } = this.#sizeAt(this.#ownScale);
    if (this.#frameSize?.width === width && this.#frameSize.height === height) return;
    this.#renderer.resize(width, height);
    this.#frameSize = { width, height };
    this.#isUnchecked = true;
  }

  get #shown(): Renderer {
    return this.#refinement?.shown ?? this.#renderer;
  }

  /** Whether the image is refined while it rests: under `auto`, where pixels are those of a CPU. */
  #refines({ isMoving, canDefer }: ViewFrame): boolean {
    const { quality, look } = this.#settings;
    if (quality !== "auto" || look !== "physical" || !this.#refinement) return false;
    if (isMoving || !canDefer || !this.isPlaying || this.inspect !== "picture") return false;
    if (!this.#refinement.lightsOf(this.#subject.world)) return false;
    return this.auto.isSoftware && this.#quality.tier.name === "low";
  }

  /** Of the renderer that is not the refinement's. */
  get #ownScale(): number {
    return this.#quality.tier.resolutionScale * this.#quality.share;
  }

  get #resolutionScale(): number {
    const isRefined = this.#refinement?.shown || this.#renderer.refinedFade?.isOn;
    return (isRefined && this.#refinement?.tier.resolutionScale) || this.#ownScale;
  }

  #sizeAt(scale: number): Size {
    return canvasSize(this.#pixels, scale, longestSide(this.#target.gpu, this.#quality.tier));
  }

  #fitCanvas(): void {
    const { canvas } = this.#target;
    const { width, height } = this.#sizeAt(this.#resolutionScale);
    if (width === canvas.width && height === canvas.height) return;
    canvas.width = width;
    canvas.height = height;
  }

  /** Asks the driver whether it accepts what was made, once the GPU has drawn, so that nothing waits. Throws if not. */
  async #check(): Promise<void> {
    const task = {};
    this.#busy = task;
    const { gpu } = this.#target;
    await gpu.whenIdle();
    if (this.#busy !== task) return; // another frame asks again
    this.#busy = null;
    this.#isUnchecked = false;
    gpu.check("picture");
  }
}
