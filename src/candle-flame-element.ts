import type { AssetError } from "./assets/load-model.js";
import { CandleFlame, type Options, type Stats } from "./candle-flame.js";
import { Absence, type Camera, cameraOf, changeOf, setCamera } from "./element/absence.js";
import { watchContext } from "./element/context-watch.js";
import { DefaultSemantics } from "./element/default-semantics.js";
import { guessDevicePixels, observeDevicePixels, type Size } from "./element/device-pixels.js";
import {
  type CandleFlameEventMap,
  type ErrorDetail,
  type ErrorType,
  TypedEvents,
  typeOf,
} from "./element/events.js";
import { featureSwitches } from "./element/feature-switches.js";
import { Glow } from "./element/glow.js";
import { boxWithin, lengthOfStep, strengthOfBreath } from "./element/limits.js";
import { observeLessMotion, optionsOf } from "./element/options.js";
import { Overlay } from "./element/overlay.js";
import { SceneFetcher } from "./element/scene-fetcher.js";
import { FULL, LOST, NO_PHYSICAL_LOOK, outSentence, REFUSALS } from "./element/sentences.js";
import { Sight } from "./element/sight.js";
import { States } from "./element/states.js";
import { styleFor } from "./element/style.js";
import { ContextLostError, GraphicsError } from "./gl/gpu-object.js";
import { type Device, FirstPersonInput } from "./input/first-person-input.js";
import type { FlameReport } from "./light/flame-light.js";
import { type Guest, rooms } from "./scenes/places.js";
import { resolveUrl } from "./scenes/resolve-url.js";
import type { Scene, SceneRequest } from "./scenes/scene.js";
import { createScreen, type Screen } from "./scenes/screen.js";
import {
  allFeatures,
  FEATURES,
  type Feature,
  type Features,
  INSPECTIONS,
  type Inspection,
  type Look,
  type Quality,
  type SceneName,
  type SettingName,
} from "./settings.js";
import { momentOf } from "./world/moment.js";
import { blow, placeCandle, takeCandle } from "./world/world.js";

export type * from "./framework-types.js";
export type {
  AssetError,
  Camera,
  CandleFlameEventMap,
  ErrorDetail,
  ErrorType,
  Feature,
  Features,
  FlameReport,
  Inspection,
  Look,
  Quality,
  Stats,
};

/** Attributes that other models may come with. */
const CHOOSING: readonly SettingName[] = ["look", "src", "asset-base"];

/**
 * `<candle-flame>`: a candle in a dark room, or alone on the page.
 *
 * Its attributes are the table `SETTINGS`; its events, slots, parts, states and custom properties are told of
 * by `custom-elements.json`, which `tools/elements-manifest.ts` writes.
 */
export class CandleFlameElement extends TypedEvents {
  /** Resolves after the first frame with all assets; rejects with the error that `error` reports. */
  ready: Promise<void>;

  readonly #semantics: DefaultSemantics;
  readonly #states: States;
  readonly #overlay: Overlay;
  readonly #glow = new Glow();
  readonly #features: Features = allFeatures();
  #inspect: Inspection = "picture";
  readonly #featureSwitches: Features;
  #settleReady: { resolve: () => void; reject: (error: Error) => void };
  #isReadySettled = false;
  #connection: AbortController | null = null;
  #canvas: HTMLCanvasElement | null = null;
  #candle: CandleFlame | null = null;
  /** Until the candle takes it. It is made before anything is fetched, which may be in vain. */
  #screen: Screen | null = null;
  /** Whether this GPU can hold the light of the physical look. */
  #holdsLight = true;
  /** Candles that are being made, of which one at most is wanted. */
  #beginnings = 0;
  #scenery: SceneName | null = null;
  #scene: Scene | null = null;
  #sight: Sight | null = null;
  #fetcher: SceneFetcher | null = null;
  readonly #absence = new Absence();
  #hasFailed = false;
  /** Whether something changed that nobody could see. */
  #isStale = false;
  /** Of the canvas on the page; what the renderer draws may be fewer. */
  #pixels: Size = { width: 1, height: 1 };
  #drawRequest = 0;
  /** Whether the canvas has the picture of this very moment: until the task ends, or something changes. */
  #isFresh = false;
  /** The room among those on the page, each of which takes a WebGL context. */
  #guest: Guest | null = null;
  #shownCamera = "";

  constructor() {
    super();
    const internals = this.attachInternals();
    this.#semantics = new DefaultSemantics(this, internals);
    this.#states = new States(this, internals);
    const root = this.attachShadow({ mode: "open" });
    root.append(this.#glow.element);
    this.#overlay = new Overlay(root);
    this.#featureSwitches = featureSwitches(this.#features, (name, isOn) => {
      this.#use((candle) => candle.setFeature(name, isOn));
      this.#requestDraw();
    });
    this.#settleReady = { resolve: () => {}, reject: () => {} };
    this.ready = this.#promiseReady();
  }

  connectedCallback(): void {
    // Here, and not once for all: an element that another document takes in loses its style.
    if (this.shadowRoot) this.shadowRoot.adoptedStyleSheets = styleFor(this.ownerDocument);
    this.upgradeAttributes();
    for (const name of ["features", "camera", "lit", "inspect"] as const) this.upgrade(name);
    this.#applyInteraction();
    if (!this.#connection) this.#start();
  }

  disconnectedCallback(): void {
    // A move within the page disconnects and connects in one task: nothing should restart then.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#absence.forgetTime();
      this.#stop();
    });
  }

  attributeChangedCallback(name: SettingName, before: string | null, after: string | null): void {
    if (name === "poster" && !this.#candle) this.#overlay.showPoster(this.poster);
    if (name === "alt" || name === "controls") this.#applyInteraction();
    if (name === "sensitivity" && this.#candle?.input) {
      this.#candle.input.sensitivity = this.sensitivity;
    }
    if (name === "max-pixel-ratio") this.#resize();
    if (name === "loading" && this.loading === "eager") this.#sight?.stopWaiting();
    if (name === "scene" && this.#canvas && this.scene !== this.#scenery) this.#restart();
    // What could not be shown is asked for no more; this may do better.
    const asksAnew = before !== after && (name === "scene" || CHOOSING.includes(name));
    if (this.#hasFailed && asksAnew && this.isConnected) this.#restart();
    if (CHOOSING.includes(name)) this.#fetcher?.follow();
    if (name === "seed") this.#absence.forgetTime();
    if (name === "unlit") this.#absence.isLit = !this.unlit;
    this.#apply();
  }

  #apply(): void {
    if (!this.#candle) return;
    this.#use((candle) => {
      candle.options = this.#options();
    });
    this.#applyMotion();
    this.#reportCamera(); // another seed begins anew, another look may have other walls
    this.#requestDraw();
  }

  /** Techniques that can be switched off, one by one: `element.features.drift = false`. */
  get features(): Features {
    return this.#featureSwitches;
  }
  set features(value: Partial<Features>) {
    for (const name of FEATURES) {
      if (value?.[name] !== undefined) this.#featureSwitches[name] = value[name];
    }
  }

  /** What is shown of each frame: the picture, or what a pass has left for the next. */
  get inspect(): Inspection {
    return this.#inspect;
  }
  set inspect(value: Inspection) {
    this.#inspect = INSPECTIONS.includes(value) ? value : "picture";
    if (this.#candle) this.#candle.inspect = this.#inspect;
    this.#requestDraw();
  }

  get camera(): Required<Camera> {
    return this.#candle ? cameraOf(this.#candle) : this.#absence.cameraFor(this.look);
  }
  set camera(value: Partial<Camera>) {
    const change = changeOf(value, this.camera);
    if (!this.#candle || this.#fetcher?.isFetching) this.#absence.want(change);
    if (!this.#candle) return;
    setCamera(this.#candle, change);
    this.#reportCamera();
    this.#requestDraw();
  }

  /** Seconds simulated since `reset()`. */
  get currentTime(): number {
    return this.#candle?.currentTime ?? this.#absence.currentTime;
  }

  /** Whether the candle is in the hand; else it stands in the room. */
  get held(): boolean {
    return this.#candle?.world.candle.isHeld ?? this.#absence.isHeld;
  }

  /** The flame as of the last frame; its position is the centre of the light. Null before the first. */
  get flame(): FlameReport | null {
    return this.#candle?.flame ?? null;
  }

  /** Numbers of the last frame. */
  get stats(): Stats {
    return (
      this.#candle?.stats ?? {
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
        gpuObjects: 0,
        gpuBytes: 0,
      }
    );
  }

  play(): void {
    this.paused = false;
  }

  pause(): void {
    this.paused = true;
  }

  /**
   * Advances by exactly this many seconds, then draws; works while paused.
   *
   * @throws RangeError for more than 60 seconds
   */
  step(seconds: number): void {
    const length = lengthOfStep(seconds);
    this.#use((candle) => {
      // A busy browser tells of a wish for less motion frames after the visitor's system did.
      candle.options = this.#options();
      candle.step(length);
    });
    this.#afterFrame();
  }

  /** Time 0, as if new; with a seed, another chance. */
  reset(seed?: number): void {
    if (seed !== undefined) this.seed = seed;
    this.#absence.forgetTime();
    this.#use((candle) => candle.reset());
    this.#reportCamera();
    this.#requestDraw();
  }

  /** Takes over another's moment: its time, its camera, its candle, and whether it burns. */
  mirror(other: CandleFlameElement): void {
    const moment = other instanceof CandleFlameElement ? other.#candle : null;
    if (!moment) return;
    this.#use((candle) => candle.mirror(moment));
    this.#showLit();
    this.#reportCamera();
    this.#requestDraw();
  }

  /** Puts the candle down ahead; before there is a room, once there is one. */
  place(): void {
    if (!this.#candle) this.#absence.place();
    const world = this.#candle?.world;
    if (!world?.candle.isHeld) return;
    if (placeCandle(world)) this.#emit("place", null);
    this.#tellRefusal();
    this.#requestDraw();
  }

  /** Takes the candle up, where it is within reach. */
  take(): void {
    if (!this.#candle) this.#absence.take();
    if (this.#candle && takeCandle(this.#candle.world)) this.#emit("take", null);
    this.#requestDraw();
  }

  /** Whether the candle burns; writing lights it or puts it out. */
  get lit(): boolean {
    return this.#candle?.world.flame.isLit ?? this.#absence.isLit ?? !this.unlit;
  }
  set lit(value: boolean) {
    if (value) this.light();
    else this.extinguish();
  }

  /** A flame catches at the wick, and grows. */
  light(): void {
    this.#setLit(true);
  }

  /** The flame dies; the ember fades. */
  extinguish(): void {
    this.#setLit(false);
  }

  #setLit(isLit: boolean): void {
    if (!this.#candle) {
      this.unlit = !isLit;
      this.#absence.isLit = isLit;
      return;
    }
    this.#candle.setLit(isLit);
    this.#requestDraw();
  }

  /** A breath from the camera: the flame leans, and goes out if it is strong enough. */
  blow(strength = 1): void {
    if (this.#candle) blow(this.#candle.world, strengthOfBreath(strength));
  }

  readonly #flameChanged = (): void => {
    this.#showLit();
    this.#emit(this.lit ? "light" : "extinguish", null);
  };

  #showLit(): void {
    this.#states.toggle("lit", this.lit);
    this.#overlay.hint.tell(this.#outSentence, this.controls);
  }

  get #outSentence(): string | null {
    return this.lit ? null : outSentence(this.controls);
  }

  /** Goes in, as a click does: takes the focus and asks for the pointer. Needs `controls`. */
  enter(): void {
    this.#candle?.input?.enter();
  }

  /** The picture as of this moment. */
  toBlob(type = "image/png", quality?: number): Promise<Blob> {
    const canvas = this.#canvas;
    return new Promise((resolve, reject) => {
      // The browser owns the pixels after the task that drew them.
      this.#drawAnew();
      if (!canvas || !this.#candle) {
        reject(new Error("There is no picture yet: wait for `ready`."));
        return;
      }
      canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error(`No picture of type ${type}.`))),
        type,
        quality,
      );
    });
  }

  /** Linear RGB of canvas pixels, origin top left; a larger box is cut to the picture's size. Waits for the GPU. */
  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    this.#drawAnew();
    this.#isFresh = false; // reading may go on drawing
    const box = boxWithin(this.#canvas, [x, y, width, height]);
    const [, , columns, rows] = box;
    const radiance = columns * rows > 0 && this.#use((candle) => candle.readRadiance(...box));
    return radiance || new Float32Array(columns * rows * 3);
  }

  #emit<Type extends keyof CandleFlameEventMap>(
    type: Type,
    detail: CandleFlameEventMap[Type]["detail"],
  ): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  #promiseReady(): Promise<void> {
    const ready = new Promise<void>((resolve, reject) => {
      this.#settleReady = { resolve, reject };
    });
    this.#isReadySettled = false;
    ready.catch(() => {}); // whoever does not await it has the event
    return ready;
  }

  #start(): void {
    this.#connection = new AbortController();
    const { signal } = this.#connection;
    this.#hasFailed = false;
    this.#clearFailure();
    this.#overlay.showPoster(this.poster);
    this.#states.toggle("loading", true);
    this.#sight = new Sight(this, signal, () => this.#applySight(), this.#sight);
    if (this.loading === "lazy") this.#sight.awaitApproach(() => this.#open(signal));
    else this.#open(signal);
  }

  /** Nothing moves where nobody looks. */
  get #isSeen(): boolean {
    return this.#sight?.isSeen ?? true;
  }

  #applySight(): void {
    rooms.review();
    this.#applyMotion();
    if (this.#isSeen && this.#isStale) this.#draw();
  }

  /** A room has to wait until the page has a context left; lone candles share one. */
  #open(signal: AbortSignal): void {
    if (this.scene === "candle") {
      this.#states.toggle("alone", true);
      this.#enter(signal);
      return;
    }
    const isSeen = () => this.#isSeen;
    this.#guest = {
      get isSeen() {
        return isSeen();
      },
      enter: () => {
        this.#clearFailure();
        this.#enter(signal);
      },
      yield: () => this.#restart(),
    };
    if (!rooms.ask(this.#guest) && this.#guest) this.#showFailure(FULL, "status");
  }

  #enter(signal: AbortSignal): void {
    try {
      this.#scenery = this.scene;
      this.#screen = createScreen(this.scene, this.#createCanvas());
      const { source, gpu } = this.#screen;
      this.#holdsLight = gpu.drawsToHalfFloats;
      if (this.quality === "auto") void CandleFlame.measure(this.#screen); // while the files are on their way
      watchContext(source, signal, {
        onLost: () => this.#contextLost(),
        onRestored: () => this.#contextRestored(),
        onGivenUp: () => {
          this.#offerReload();
          this.#report(new ContextLostError(LOST));
        },
      });
      this.#fetcher = new SceneFetcher(() => this.#asked, signal, {
        onProgress: (share) => this.#showProgress(share),
        onScene: (scene) => this.#show(scene, signal),
        onFailure: (error) => this.#failToFetch(error),
        onGivenUp: () => this.#stopAwaiting(),
      });
      void this.#fetcher.fetch();
    } catch (error) {
      this.#failAtFrame(error);
    }
  }

  async #begin(scene: Scene, connection: AbortSignal): Promise<void> {
    const screen = this.#screen;
    if (!screen || screen.gpu.isLost) return; // it begins when the context is given back
    const isWanted = () => !connection.aborted && this.#scene === scene && this.#screen === screen;
    const plays = !this.paused && this.#isSeen;
    // Of another scene's beginning, which is no longer wanted.
    if (this.#beginnings++ > 0) screen.clear();
    try {
      const options = this.#options();
      const candle = await CandleFlame.create(
        screen,
        scene,
        this.#features,
        options,
        plays,
        isWanted,
      );
      if (candle) this.#adopt(candle, connection);
    } catch (error) {
      if (isWanted()) this.#failAtFrame(error);
    } finally {
      this.#beginnings--;
    }
  }

  #adopt(candle: CandleFlame, connection: AbortSignal): void {
    this.#candle = candle;
    this.#screen = null;
    candle.options = this.#options(); // which may have changed meanwhile
    candle.inspect = this.#inspect;
    candle.onFrame = () => this.#afterFrame();
    candle.onFailure = (error) => this.#failAtFrame(error);
    candle.onCandleMoved = () => this.#emit(this.held ? "take" : "place", null);
    candle.onRefused = () => this.#tellRefusal();
    candle.onFlameChanged = this.#flameChanged;
    candle.onQualityChanged = () => this.#emit("qualitychange", null);
    this.#absence.end(candle, this.#shown, () => this.#emit("place", null));
    this.#shownCamera = this.#cameraKey;
    this.#pixels = guessDevicePixels(candle.canvas);
    this.#resize();
    this.#draw();
    if (this.#candle) this.#reveal(connection);
  }

  #createCanvas(): HTMLCanvasElement {
    // A context once given back cannot be had again from the same canvas, so each life has its own.
    const canvas = document.createElement("canvas");
    canvas.part.add("canvas");
    this.shadowRoot?.prepend(canvas);
    this.#canvas = canvas;
    this.#applyInteraction();
    return canvas;
  }

  /** The look asked for, or the nearest that can be drawn here. */
  get #drawnLook(): Look {
    return this.look === "physical" && !this.#holdsLight ? "paper" : this.look;
  }

  get #asked(): SceneRequest {
    const { scene, src } = this;
    return { scene, look: this.#drawnLook, src, assetRoot: this.#assetRoot() };
  }

  /** On show, which while something else is fetched is not what the attributes say. */
  get #shown(): SceneRequest | null {
    return this.#fetcher?.shown ?? null;
  }

  #failToFetch(error: Error): void {
    if (!this.#candle) {
      this.#fail(error);
      return;
    }
    this.#stopAwaiting();
    this.#report(error);
  }

  /** What was on its way does not come, or is not wanted after all. */
  #stopAwaiting(): void {
    this.#absence.forgetCamera();
    this.#overlay.hideProgress();
  }

  #show(scene: Scene, connection: AbortSignal): void {
    const old = this.#scene;
    this.#scene = scene;
    if (!this.#candle) {
      old?.close();
      void this.#begin(scene, connection);
      return;
    }
    this.#use((candle) => {
      candle.show(scene, this.#options());
      this.#absence.end(candle, this.#shown, () => this.#emit("place", null));
    });
    old?.close();
    if (!this.#candle) return;
    this.#overlay.hideProgress();
    this.#reportCamera();
    this.#requestDraw();
    this.#emit("load", null);
  }

  #assetRoot(): string {
    const module = new URL(".", import.meta.url).href;
    if (this.assetBase === "") return module;
    const base = this.assetBase.endsWith("/") ? this.assetBase : `${this.assetBase}/`;
    return resolveUrl(base, document.baseURI) ?? module;
  }

  #reveal(signal: AbortSignal): void {
    this.#overlay.hideProgress();
    this.#overlay.hidePoster();
    this.#states.toggle("loading", false);
    this.#showLit();
    this.#observe(signal);
    this.#applyMotion();
    if (this.#drawnLook !== this.look) this.#overlay.hint.tell(NO_PHYSICAL_LOOK);
    this.#emit("load", null);
    this.#settleReady.resolve();
    this.#isReadySettled = true;
  }

  #observe(signal: AbortSignal): void {
    if (this.#canvas) {
      observeDevicePixels(this.#canvas, signal, (pixels) => {
        this.#pixels = pixels;
        // What the guess got right is on show already.
        if (!this.#resize()) return;
        if (this.#isSeen) this.#draw();
        else this.#isStale = true;
      });
    }
    observeLessMotion(signal, () => this.#apply());
  }

  /** As if the element had been taken out and put back, but time goes on from this moment. */
  #restart(): void {
    const candle = this.#candle;
    const shown = this.#shown;
    this.#release();
    // Who waits for the first frame waits for that of what is asked for now.
    if (this.#isReadySettled) this.ready = this.#promiseReady();
    if (candle && shown) this.#absence.fallAsleep(momentOf(candle.world), shown);
    this.#start();
  }

  #stop(): void {
    this.#release();
    this.#settleReady.reject(new DOMException("The element was taken out.", "AbortError"));
    this.ready = this.#promiseReady();
  }

  #release(): void {
    this.#isFresh = false;
    this.#connection?.abort();
    this.#connection = null;
    this.#fetcher = null;
    this.#forgetRequest();
    this.#candle?.dispose();
    this.#candle = null;
    this.#screen?.dispose();
    this.#screen = null;
    this.#scene?.close();
    this.#scene = null;
    this.#canvas?.remove();
    this.#canvas = null;
    this.#isStale = false;
    this.#states.clear();
    const guest = this.#guest;
    this.#guest = null;
    if (guest) rooms.leave(guest);
  }

  /** No picture: a sentence instead, with the poster behind it. Nothing is thrown at the page. */
  #fail(error: Error): void {
    this.#release();
    this.#connection = new AbortController();
    this.#hasFailed = true;
    this.#overlay.hideProgress();
    if (typeOf(error) === "context-lost") this.#offerReload();
    else this.#showFailure(error.message, "alert");
    this.#overlay.showPoster(this.poster);
    this.#settleReady.reject(error);
    this.#isReadySettled = true;
    this.#report(error);
    // The sentence is for visitors; the driver's own words are in its cause.
    if (typeOf(error) === "graphics") console.error(error);
  }

  #showFailure(
    sentence: string,
    urgency: "alert" | "status",
    reload: (() => void) | null = null,
  ): void {
    this.#overlay.fail(sentence, urgency, reload);
    this.#applyInteraction();
  }

  #clearFailure(): void {
    this.#overlay.clearFailure();
    this.#applyInteraction();
  }

  #offerReload(): void {
    this.#showFailure(LOST, "alert", () => {
      this.#restart();
      if (this.controls) this.focus({ preventScroll: true }); // which the button takes with it
    });
  }

  /** Does something with the candle, if there is one. */
  #use<Result>(action: (candle: CandleFlame) => Result): Result | undefined {
    try {
      return this.#candle ? action(this.#candle) : undefined;
    } catch (error) {
      this.#failAtFrame(error);
      return undefined;
    }
  }

  /** Whatever was thrown while something was drawn, or made to be drawn. */
  #failAtFrame(cause: unknown): void {
    if (cause instanceof ContextLostError) return; // its event follows, and the picture comes back with it
    this.#fail(frameError(cause));
  }

  #report(error: Error): void {
    this.#emit("error", { type: typeOf(error), message: error.message, cause: error });
  }

  #contextLost(): void {
    this.#candle?.pause();
    this.#overlay.showPoster(this.poster);
    this.#emit("contextlost", null);
  }

  #contextRestored(): void {
    try {
      this.#screen?.renew();
      this.#clearFailure();
      if (this.#candle) {
        this.#candle.restore();
        this.#overlay.hidePoster();
        this.#applyMotion();
      } else if (this.#scene && this.#connection) {
        void this.#begin(this.#scene, this.#connection.signal);
      }
      this.#emit("contextrestored", null);
    } catch (error) {
      this.#failAtFrame(error);
    }
  }

  #options(): Options {
    return optionsOf(this, this.#shown?.look ?? this.look);
  }

  #applyMotion(): void {
    const candle = this.#candle;
    if (!candle) return;
    const runs = !this.paused && this.#isSeen;
    const states = this.#states;
    if (runs !== states.has("playing")) {
      states.toggle("playing", runs);
      this.#emit(runs ? "play" : "pause", null);
    }
    if (runs) candle.play();
    else candle.pause();
    if (this.controls && !candle.input && this.#canvas) {
      candle.input = new FirstPersonInput(this, this.#canvas, (isIn, device) =>
        this.#goInOrOut(isIn, device),
      );
      candle.input.sensitivity = this.sensitivity;
    } else if (!this.controls && candle.input) {
      candle.input.dispose();
      candle.input = null;
      states.toggle("walking", false);
    }
  }

  #goInOrOut(isIn: boolean, device: Device): void {
    this.#states.toggle("walking", isIn);
    if (isIn) this.#overlay.hint.tellControls(device);
    else this.#overlay.hint.tell(this.#outSentence, this.controls);
    this.#emit(isIn ? "enter" : "leave", null);
  }

  #applyInteraction(): void {
    // Interactive, it is something to enter; passive, the canvas is a picture. Not the element itself:
    // of a picture nothing is read but its name, and what the hint says must be.
    const isPicture = !this.controls && !this.#overlay.isFailing;
    const role = this.#overlay.isFailing ? "group" : "application";
    this.#semantics.set({
      role: isPicture ? null : role,
      ariaLabel: isPicture ? null : this.alt,
      ariaDescription: this.controls ? "Press Enter to walk in, and Escape to leave." : null,
    });
    this.#overlay.posterAlt = isPicture ? this.alt : "";
    if (this.#canvas) {
      this.#canvas.setAttribute("role", isPicture ? "img" : "presentation");
      if (isPicture) this.#canvas.setAttribute("aria-label", this.alt);
      else this.#canvas.removeAttribute("aria-label");
    }
    if (this.controls && !this.hasAttribute("tabindex")) this.tabIndex = 0;
    if (!this.controls && this.getAttribute("tabindex") === "0") this.removeAttribute("tabindex");
  }

  /** @returns whether the picture has to be drawn again */
  #resize(): boolean {
    this.#isFresh = false;
    const cap = Math.min(1, this.maxPixelRatio / devicePixelRatio);
    const { width, height } = this.#pixels;
    const [w, h] = [Math.max(1, width * cap), Math.max(1, height * cap)];
    return this.#use((candle) => candle.resize(w, h)) ?? false;
  }

  /** At the next frame, unless something draws before that anyway. */
  #requestDraw(): void {
    this.#isFresh = false;
    const isPlaying = this.#states.has("playing");
    if (!this.#candle || isPlaying || this.#drawRequest !== 0) return;
    if (!this.#isSeen) {
      this.#isStale = true;
      return;
    }
    this.#drawRequest = requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#isStale = false;
    this.#use((candle) => candle.draw());
    this.#forgetRequest();
    this.#keepFresh();
    this.#shine();
  }

  #drawAnew(): void {
    if (!this.#isFresh) this.#draw();
  }

  #keepFresh(): void {
    this.#isFresh = true;
    queueMicrotask(() => {
      this.#isFresh = false;
    });
  }

  #forgetRequest(): void {
    cancelAnimationFrame(this.#drawRequest);
    this.#drawRequest = 0;
  }

  #afterFrame(): void {
    this.#forgetRequest();
    this.#keepFresh();
    this.#reportCamera();
    this.#shine();
  }

  #shine(): void {
    if (this.#states.has("alone")) this.#glow.follow(this.flame?.luminousIntensity ?? 0);
  }

  get #cameraKey(): string {
    const { position, yaw, pitch, fieldOfView } = this.camera;
    return `${position} ${yaw} ${pitch} ${fieldOfView}`;
  }

  #reportCamera(): void {
    const key = this.#cameraKey;
    if (!this.#candle || key === this.#shownCamera) return;
    this.#shownCamera = key;
    this.#emit("camerachange", null);
  }

  /** Why the candle could not be put down, in a sentence that fades; nothing if it could. */
  #tellRefusal(): void {
    const refusal = this.#candle?.world.refusal ?? null;
    // Who stands in the dark must still be told how to end it.
    const sentences = [refusal && REFUSALS[refusal], this.#outSentence].filter(Boolean);
    this.#overlay.hint.tell(sentences.join(" ") || null, this.controls && !this.lit);
  }

  #showProgress(totalProgress: number): void {
    this.#overlay.showProgress(totalProgress);
    this.#emit("progress", { totalProgress });
  }
}

/** The error of a frame: what the GPU's own modules threw, or anything else in a sentence. */
function frameError(cause: unknown): Error {
  if (cause instanceof Error && typeOf(cause) !== "asset") return cause;
  return new GraphicsError("The picture cannot be drawn.", { cause });
}

declare global {
  interface HTMLElementTagNameMap {
    "candle-flame": CandleFlameElement;
  }
}
