import type { CandleFlame, Options } from "../candle-flame.js";
import { createCandle, fetchInput, measureTarget } from "../create-candle.js";
import { type CanvasTarget, createCanvasTarget } from "../scenes/canvas-target.js";
import { fetchPageSmoke } from "../scenes/page-smoke.js";
import { areSame, loadScene, type Scene, type SceneRequest } from "../scenes/scene.js";
import type { Features, Inspection, Look } from "../settings.js";
import { windowOf } from "../window-of.js";
import { CandleList } from "./candle-list.js";
import { watchContext } from "./context-watch.js";
import { Controls } from "./controls.js";
import { guessDevicePixels, observeDevicePixels, type Size } from "./device-pixels.js";
import type { Lifecycle } from "./lifecycle.js";
import { assetRootOf, optionsOf } from "./options.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";

/** Input of a session: the attributes as they are at any time, and settings without attribute. */
export interface SessionInput {
  readonly attributes: ReflectedAttributes;
  readonly features: Features;
  inspect: Inspection;
}

/**
 * Rendering session: a canvas with its WebGL context, the scene fetched for it, and the candle drawn there.
 *
 * It ends with `dispose`: a canvas cannot have another context after its own was released.
 */
export class Session {
  readonly canvas: HTMLCanvasElement;
  readonly controls: Controls;
  readonly #input: SessionInput;
  readonly #owner: Lifecycle;
  readonly #signal: AbortSignal;
  readonly #target: CanvasTarget;
  #shownRequest: SceneRequest | null = null;
  #pendingRequest: SceneRequest | null = null;
  #loading: AbortController | null = null;
  #scene: Scene | null = null;
  #candle: CandleFlame | null = null;
  /** Listed when they are asked for. */
  #candles: CandleList | null = null;
  /** Creations of candles under way, of which one at most is wanted. */
  #creations = 0;
  /** Of the canvas on the page; the renderer may draw fewer. */
  #pixels: Size = { width: 1, height: 1 };

  /**
   * Throws where there is no WebGL 2.
   *
   * @param signal aborts when the session is to end
   */
  constructor(
    canvas: HTMLCanvasElement,
    input: SessionInput,
    signal: AbortSignal,
    owner: Lifecycle,
  ) {
    const { scene, quality } = input.attributes;
    this.canvas = canvas;
    this.#input = input;
    this.#owner = owner;
    this.#signal = signal;
    this.controls = new Controls(input.attributes, canvas, signal, (error) =>
      owner.emitError(error),
    );
    this.#target = createCanvasTarget(scene, canvas);
    if (quality === "auto") void measureTarget(this.#target); // while the files are on their way
    watchContext(this.#target.source, signal, {
      isVisible: () => owner.isVisible,
      onLost: () => owner.onContextLost(),
      onRestored: () => void this.#restore(),
      onGivenUp: () => owner.onContextGivenUp(),
    });
    signal.addEventListener("abort", () => this.#loading?.abort());
    void this.#fetch();
  }

  /** Null until it can draw. */
  get candle(): CandleFlame | null {
    return this.#candle;
  }

  get candles(): CandleList["entries"] {
    this.#candles ??= new CandleList(this.#candle, () => this.#owner.changed());
    return this.#candles.entries;
  }

  /** The scene on show; while another is fetched the attributes ask for that. */
  get shownRequest(): SceneRequest | null {
    return this.#shownRequest;
  }

  /** Whether nothing can be drawn at the moment. */
  get isLost(): boolean {
    return this.#target.gpu.isLost;
  }

  get isFetching(): boolean {
    return this.#pendingRequest !== null;
  }

  /** The look asked for, or the nearest that the GPU can draw. */
  get look(): Look {
    const { look } = this.#input.attributes;
    return look === "physical" && !this.#target.gpu.drawsToHalfFloats ? "paper" : look;
  }

  get options(): Options {
    const { attributes } = this.#input;
    return optionsOf(attributes, this.#shownRequest?.look ?? attributes.look);
  }

  get #request(): SceneRequest {
    const { attributes } = this.#input;
    const { scene, src, paused: isStepped, baseURI } = attributes;
    return { scene, look: this.look, src, baseURI, assetRoot: assetRootOf(attributes), isStepped };
  }

  /** To be called when an attribute that selects a scene has changed. */
  follow(): void {
    const request = this.#request;
    if (areSame(request, this.#shownRequest)) {
      this.#loading?.abort();
      this.#pendingRequest = null;
      this.#shownRequest = request;
      this.#owner.onFetchDropped();
    } else if (!areSame(request, this.#pendingRequest)) {
      this.#owner.onFetch();
      void this.#fetch();
    }
  }

  /**
   * Fetches the scene asked for, and aborts the fetch before it. The shown scene stays until the new models have
   * loaded, and if they fail to load.
   */
  async #fetch(request = this.#request): Promise<void> {
    this.#loading?.abort();
    const loading = new AbortController();
    this.#loading = loading;
    const { signal } = loading;
    let most = 0;
    // Files may still arrive after an abort; and after a model without a wick comes the built-in candle.
    const onProgress = (progress: number) => {
      if (signal.aborted || progress < most) return;
      most = progress;
      this.#owner.onProgress(progress);
    };
    this.#pendingRequest = request;
    let scene: Scene | undefined;
    try {
      // A room may get controls at any time.
      const needsControls = request.scene === "room" || this.#input.attributes.controls;
      const controls = needsControls ? fetchInput() : null;
      controls?.catch(() => {}); // it throws below
      scene = await loadScene(request, { signal, onProgress });
      await controls;
    } catch (error) {
      scene?.close();
      if (signal.aborted) return;
      loading.abort(); // what else is on its way
      this.#pendingRequest = null;
      const last = this.#shownRequest ? null : this.#owner.pending.request;
      // After a restart, what was shown because this had failed before.
      if (last?.scene === request.scene && !areSame(last, request)) void this.#fetch(last);
      this.#owner.onMissing(error as Error);
      return;
    }
    if (signal.aborted) return scene.close();
    this.#pendingRequest = null;
    const isSameSource = this.#shownRequest?.src === request.src;
    this.#shownRequest = areSame(request, this.#request) ? this.#request : request;
    this.#show(scene, isSameSource);
  }

  /** Calls an action with the candle, if there is one. Exceptions go to `onError`. */
  use<Result>(action: (candle: CandleFlame) => Result): Result | undefined {
    try {
      return this.#candle ? action(this.#candle) : undefined;
    } catch (error) {
      this.#owner.onError(error);
      return undefined;
    }
  }

  applyOptions(): void {
    this.use((candle) => {
      candle.options = this.options;
      void this.#measure(candle);
    });
  }

  /** Measures what `auto` goes by, if it was not asked for when the candle was made. */
  async #measure({ view: { auto } }: CandleFlame): Promise<void> {
    if (this.options.quality !== "auto" || auto.pixel !== null) return;
    const { gpu } = this.#target;
    const pixel = await measureTarget(this.#target);
    if (gpu !== this.#target.gpu) return; // of a context that was lost
    auto.pixel = pixel;
    this.#owner.changed();
  }

  /** Fits the frame to the canvas. Returns whether it has to be drawn again. */
  resize(): boolean {
    return this.use((candle) => this.#fit(candle)) ?? false;
  }

  #fit(candle: CandleFlame): boolean {
    const { maxPixelRatio } = this.#input.attributes;
    const cap = Math.min(1, maxPixelRatio / windowOf(this.canvas).devicePixelRatio);
    const { width, height } = this.#pixels;
    return candle.view.resize(Math.max(1, width * cap), Math.max(1, height * cap));
  }

  /**
   * Keeps the frame fitted to the canvas from now on.
   *
   * @param onResized called with whether the canvas had no box before
   */
  followSize(onResized: (appears: boolean) => void): void {
    let wasHidden = false;
    observeDevicePixels(this.canvas, this.#signal, (pixels) => {
      const appears = wasHidden;
      wasHidden = pixels.width + pixels.height < 1;
      if (wasHidden) return; // what is drawn there keeps its size
      this.#pixels = pixels;
      // A correct guess is on show already.
      if (this.resize()) onResized(appears);
    });
  }

  /** Resolves when the code is there that calls and steps depend on; null where there is none to wait for. */
  get completion(): Promise<unknown> | null {
    const { scene, paused } = this.#input.attributes;
    const { settled } = this.controls;
    return scene === "candle" && paused ? Promise.all([fetchPageSmoke(), settled]) : settled;
  }

  #retireCandles(): void {
    this.#candles?.retire();
    this.#candles = null;
  }

  #show(scene: Scene, isSameSource: boolean): void {
    const previous = this.#scene;
    const candle = this.#candle;
    this.#scene = scene;
    this.use((candle) => {
      this.#retireCandles(); // before the events of what is shown
      const { pending } = this.#owner;
      const wasFixed = candle.world.setup.stand !== null;
      const isKept = candle.show(scene, this.options, isSameSource, pending.isLit);
      if (this.#signal.aborted) return; // a listener asked for another scene
      if (isKept && !wasFixed) pending.forgetPlaces(); // they were done in the world before
      void this.#measure(candle);
      this.#owner.onScene(candle);
    });
    previous?.close();
    if (!candle) void this.#create(scene);
  }

  async #create(scene: Scene): Promise<void> {
    const target = this.#target;
    if (target.gpu.isLost) return; // the candle is created when the context is restored
    const isWanted = () => !this.#signal.aborted && this.#scene === scene && !this.#candle;
    // Frees what another scene's creation made, which is no longer wanted.
    if (this.#creations++ > 0) target.clear();
    const { features } = this.#input;
    const key = () => JSON.stringify([this.options, features]);
    let known = key();
    try {
      const created = await createCandle(target, scene, features, this.options, {
        plays: this.#owner.plays(),
        isWanted,
        rehearse: (candle) => {
          this.#setUp(candle);
          this.#fit(candle);
          const isOther = known !== key();
          known = key();
          return this.#owner.applyPending(candle) || isOther;
        },
      });
      if (created) this.#begin(created, known !== key());
    } catch (error) {
      if (isWanted()) this.#owner.onError(error);
    } finally {
      this.#creations--;
    }
  }

  /** Gives a candle what may have changed while it was created. */
  #setUp(candle: CandleFlame): void {
    candle.options = this.options;
    candle.view.inspect = this.#input.inspect;
    this.#pixels = guessDevicePixels(this.canvas);
  }

  /** @param isOther whether the page has changed what its world is made from */
  #begin(candle: CandleFlame, isOther: boolean): void {
    this.#candle = candle;
    this.#retireCandles();
    this.#setUp(candle);
    if (this.#input.attributes.paused) candle.view.isPlaying = false;
    void this.#measure(candle);
    if (isOther) candle.reset();
    candle.onFailure = (error) => this.#candle === candle && this.#owner.onError(error);
    this.use(() => this.#owner.onCandle(candle));
  }

  async #restore(): Promise<void> {
    const isWanted = () => !this.#signal.aborted && !this.#target.gpu.isLost;
    try {
      if (this.#candle) {
        await this.#candle.restore(this.#owner.plays(), isWanted);
        if (!isWanted()) return;
        void this.#measure(this.#candle);
      } else {
        this.#target.renew();
        if (this.#scene) void this.#create(this.#scene);
      }
      this.#owner.onContextRestored();
    } catch (error) {
      if (isWanted()) this.#owner.onError(error);
    }
  }

  dispose(): void {
    if (this.#candle) this.#candle.dispose();
    else this.#target.dispose();
    this.#candle = null;
    this.#retireCandles();
    this.#scene?.close();
    this.#scene = null;
  }
}
