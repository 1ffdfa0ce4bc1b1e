import type { AssetError } from "./assets/load-model.js";
import { CandleFlame, type Stats } from "./candle-flame.js";
import { guessDevicePixels, observeDevicePixels, type Size } from "./device-pixels.js";
import { STYLE } from "./element-style.js";
import { ContextLostError } from "./gl/gpu-object.js";
import { type Device, FirstPersonInput } from "./input/first-person-input.js";
import type { FlameReport } from "./light/flame-light.js";
import { Overlay } from "./overlay.js";
import { ReflectedAttributes } from "./reflected-attributes.js";
import { type Guest, rooms } from "./scenes/places.js";
import { areSame, loadScene, type Scene, type SceneRequest } from "./scenes/scene.js";
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
import { type Moment, momentOf, timeOf } from "./world/moment.js";
import type { Refusal } from "./world/placing.js";
import { blow, moveCamera, placeCandle, takeCandle } from "./world/world.js";

export type * from "./framework-types.js";
export type { Feature, Features, FlameReport, Inspection, Look, Quality, Stats };

export interface Camera {
  /** Metres; the origin is on the floor, amid the room. */
  readonly position: readonly [number, number, number];
  /** Radians, counter-clockwise from above; 0 looks along -Z. */
  readonly yaw: number;
  /** Radians, up positive. */
  readonly pitch: number;
}

export type ErrorType = "webgl-unavailable" | "asset" | "shader" | "context-lost";

export interface ErrorDetail {
  readonly type: ErrorType;
  readonly message: string;
  readonly cause: unknown;
}

export interface CandleFlameEventMap {
  progress: CustomEvent<{ readonly totalProgress: number }>;
  load: CustomEvent<null>;
  error: CustomEvent<ErrorDetail>;
  play: CustomEvent<null>;
  pause: CustomEvent<null>;
  place: CustomEvent<null>;
  take: CustomEvent<null>;
  enter: CustomEvent<null>;
  leave: CustomEvent<null>;
  light: CustomEvent<null>;
  extinguish: CustomEvent<null>;
  camerachange: CustomEvent<null>;
  qualitychange: CustomEvent<null>;
  contextlost: CustomEvent<null>;
  contextrestored: CustomEvent<null>;
}

/** Attributes that other models may come with. */
const CHOOSING: readonly SettingName[] = ["look", "src", "asset-base"];

const NO_PHYSICAL_LOOK =
  "This graphics driver cannot hold light in real units, so the room is drawn in the paper's look.";

const REFUSALS: Readonly<Record<Refusal, string>> = {
  "nothing within reach": "There is nothing within reach to put the candle on.",
  "too steep": "That is too steep for a candle.",
  overhangs: "The candle would hang over the edge.",
  "no room": "There is no room for the candle.",
};

const OUT = "The candle is out.";

/** How long the browser has to give a lost context back before the visitor is asked, in milliseconds. */
const PATIENCE = 5000;
const LOST = "The graphics driver has taken the picture away, and has not given it back.";
const FULL =
  "This page has as many rooms open as a browser can show. This one opens as soon as there is a place.";

/**
 * A candle in a dark room.
 *
 * @attr look - which renderer: the paper's final product, or its before
 * @attr controls - first-person controls; without it the element takes no input and no focus
 * @attr quality - auto, low, medium, high, ultra
 * @attr sensitivity - how far the view turns for a movement of the mouse or a finger
 * @attr motion - auto, reduced, full; auto follows the visitor's system
 * @attr paused - no time passes; a frame is drawn only when something changes
 * @attr unlit - the candle starts, or is put, out
 * @attr wind - mean draught, m/s
 * @attr wind-direction - where it blows to, degrees: 0 is -Z, counter-clockwise from above
 * @attr gustiness - 0 steady to 1 squally
 * @attr wick - diameter of the wick, mm
 * @attr seed - same seed, same steps, same pixels on the same renderer
 * @attr exposure - compensation in EV
 * @attr particles - particles that the flame keeps alive; 0 is the look's own count
 * @csspart canvas - the picture
 * @csspart poster - the picture until the first frame
 * @csspart progress - the bar that shows loading
 * @csspart hint - what the visitor should know for a moment
 * @csspart error - the sentence shown when there can be no picture
 * @csspart reload - the button that begins anew
 * @csspart glow - the warm light on the page, with `scene="candle"`
 * @slot poster - in place of the poster's image
 * @slot progress - in place of the bar, while loading
 * @slot hint - in place of the line that lists the controls
 * @slot error - in place of the sentence
 */
export class CandleFlameElement extends ReflectedAttributes {
  /** Resolves after the first frame with all assets; rejects with the error that `error` reports. */
  ready: Promise<void>;

  readonly #internals: ElementInternals;
  readonly #overlay: Overlay;
  readonly #glow: HTMLElement;
  readonly #features: Features = allFeatures();
  #inspect: Inspection = "picture";
  readonly #featureSwitches: Features;
  #settleReady: { resolve: () => void; reject: (error: Error) => void };
  #connection: AbortController | null = null;
  #canvas: HTMLCanvasElement | null = null;
  #candle: CandleFlame | null = null;
  /** Until the candle takes it. It is made before anything is fetched, which may be in vain. */
  #screen: Screen | null = null;
  /** Whether this GPU can hold the light of the physical look. */
  #holdsLight = true;
  #scenery: SceneName | null = null;
  /** Ends the wait of a lazy element. */
  #approach: (() => void) | null = null;
  #scene: Scene | null = null;
  /** What is on show, which while something else is fetched is not what the attributes say. */
  #shown: SceneRequest | null = null;
  /** Being fetched. */
  #wanted: SceneRequest | null = null;
  #loading: AbortController | null = null;
  /** In the viewport, as far as anyone knows. */
  #isInSight = true;
  /** Whether something changed that nobody could see. */
  #isStale = false;
  /** Of the canvas on the page; what the renderer draws may be fewer. */
  #pixels: Size = { width: 1, height: 1 };
  #drawRequest = 0;
  /** Runs out when a lost context does not come back. */
  #patience = 0;
  /** The room among those on the page, each of which takes a WebGL context. */
  #guest: Guest | null = null;
  #shownCamera = "";
  /** Set before there is a world to see, or while that of another room is on its way. */
  #awaitedCamera: Partial<Camera> | null = null;
  /** From where a room that had to give way goes on, and which room it is of. */
  #asleep: { readonly moment: Moment; readonly of: SceneRequest } | null = null;

  constructor() {
    super();
    this.#internals = this.attachInternals();
    const root = this.attachShadow({ mode: "open" });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(STYLE);
    root.adoptedStyleSheets = [sheet];
    this.#glow = document.createElement("div");
    this.#glow.part.add("glow");
    root.append(this.#glow);
    this.#overlay = new Overlay(root);
    this.#featureSwitches = this.#makeFeatureSwitches();
    this.#settleReady = { resolve: () => {}, reject: () => {} };
    this.ready = this.#promiseReady();
  }

  connectedCallback(): void {
    this.upgradeAttributes();
    for (const name of ["features", "camera", "lit", "inspect"] as const) this.upgrade(name);
    this.#applyInteraction();
    if (!this.#connection) this.#start();
  }

  disconnectedCallback(): void {
    // A move within the page disconnects and connects in one task: nothing should restart then.
    queueMicrotask(() => {
      if (!this.isConnected) this.#stop();
    });
  }

  attributeChangedCallback(name: SettingName): void {
    if (name === "poster" && !this.#candle) this.#overlay.showPoster(this.poster);
    if (name === "alt" || name === "controls") this.#applyInteraction();
    if (name === "sensitivity" && this.#candle?.input) {
      this.#candle.input.sensitivity = this.sensitivity;
    }
    if (name === "max-pixel-ratio") this.#resize();
    if (name === "loading" && this.loading === "eager") this.#approach?.();
    if (name === "scene" && this.#canvas && this.scene !== this.#scenery) this.#restart();
    if (CHOOSING.includes(name)) this.#chooseModels();
    if (name === "seed") this.#asleep = null;
    if (name === "unlit") this.#dream({ isLit: !this.unlit });
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
    for (const name of Object.keys(FEATURES) as Feature[]) {
      if (value?.[name] !== undefined) this.#featureSwitches[name] = value[name];
    }
  }

  #makeFeatureSwitches(): Features {
    const switches = {} as Features;
    for (const name of Object.keys(FEATURES) as Feature[]) {
      Object.defineProperty(switches, name, {
        enumerable: true,
        get: () => this.#features[name],
        set: (value: unknown) => {
          if (this.#features[name] === Boolean(value)) return;
          this.#features[name] = Boolean(value);
          this.#use((candle) => candle.setFeature(name, Boolean(value)));
          this.#requestDraw();
        },
      });
    }
    return Object.seal(switches);
  }

  /** What is shown of each frame: the picture, or what a pass has left for the next. */
  get inspect(): Inspection {
    return this.#inspect;
  }
  set inspect(value: Inspection) {
    this.#inspect = Object.hasOwn(INSPECTIONS, value) ? value : "picture";
    if (this.#candle) this.#candle.inspect = this.#inspect;
    this.#requestDraw();
  }

  get camera(): Camera {
    const player = this.#candle?.world.player ?? this.#asleep?.moment;
    const { position = [0, 0, 0], yaw = 0, pitch = 0 } = player ?? {};
    const [x, y, z] = position;
    return { position: [x, y, z], yaw, pitch };
  }
  set camera(value: Partial<Camera>) {
    if (!this.#candle || this.#wanted) this.#awaitedCamera = { ...this.#awaitedCamera, ...value };
    if (!this.#candle) return;
    this.#moveCamera(this.#candle, value);
    this.#reportCamera();
    this.#requestDraw();
  }

  #moveCamera({ world }: CandleFlame, value: Partial<Camera> | null): void {
    const { camera } = this;
    const { position, yaw, pitch } = { ...camera, ...value };
    moveCamera(world, position ?? camera.position, Number(yaw), Number(pitch));
  }

  /** Seconds simulated since `reset()`. */
  get currentTime(): number {
    if (this.#candle) return this.#candle.currentTime;
    return this.#asleep ? timeOf(this.#asleep.moment) : 0;
  }

  /** Whether the candle is in the hand; else it stands in the room. */
  get held(): boolean {
    if (this.#candle) return this.#candle.world.candle.isHeld;
    return this.#asleep ? this.#asleep.moment.stand === null : true;
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

  /** Advances by exactly this many seconds, then draws; works while paused. */
  step(seconds: number): void {
    const isTime = Number.isFinite(seconds) && seconds > 0;
    this.#use((candle) => candle.step(isTime ? seconds : 0));
    this.#afterFrame();
  }

  /** Time 0, as if new; with a seed, another chance. */
  reset(seed?: number): void {
    if (seed !== undefined) this.seed = seed;
    this.#asleep = null;
    this.#use((candle) => candle.reset());
    this.#reportCamera();
    this.#requestDraw();
  }

  /** Takes over another's moment: its time, its camera, its candle, and whether it burns. */
  mirror(other: CandleFlameElement): void {
    const moment = other.#candle;
    if (!moment) return;
    this.#use((candle) => candle.mirror(moment));
    this.#showLit();
    this.#reportCamera();
    this.#requestDraw();
  }

  /** Puts the candle down ahead. */
  place(): void {
    const world = this.#candle?.world;
    if (!world?.candle.isHeld) return;
    if (placeCandle(world)) this.#emit("place", null);
    this.#tellRefusal();
    this.#requestDraw();
  }

  /** Takes the candle up, where it is within reach. */
  take(): void {
    if (this.#candle && takeCandle(this.#candle.world)) this.#emit("take", null);
    this.#requestDraw();
  }

  /** Whether the candle burns; writing lights it or puts it out. */
  get lit(): boolean {
    if (this.#candle) return this.#candle.world.flame.isLit;
    return this.#asleep?.moment.isLit ?? !this.unlit;
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
      this.#dream({ isLit });
      return;
    }
    this.#candle.setLit(isLit);
    this.#requestDraw();
  }

  /** Changes what a sleeping room goes on from. */
  #dream(change: Partial<Moment>): void {
    if (!this.#asleep) return;
    this.#asleep = { ...this.#asleep, moment: { ...this.#asleep.moment, ...change } };
  }

  /** A breath from the camera: the flame leans, and goes out if it is strong enough. */
  blow(strength = 1): void {
    if (this.#candle) blow(this.#candle.world, Math.max(0, Number(strength) || 0));
  }

  readonly #flameChanged = (): void => {
    this.#showLit();
    this.#emit(this.lit ? "light" : "extinguish", null);
  };

  #showLit(): void {
    if (this.lit) this.#internals.states.add("lit");
    else this.#internals.states.delete("lit");
    this.#overlay.hint.tell(this.#outSentence, this.controls);
  }

  get #outSentence(): string | null {
    if (this.lit) return null;
    if (!this.controls) return OUT;
    const hasFingersAlone = matchMedia("(hover: none)").matches;
    return hasFingersAlone ? `${OUT} Tap twice to light it.` : `${OUT} Press E to light it.`;
  }

  /** Goes in, as a click does: takes the focus and asks for the pointer. Needs `controls`. */
  enter(): void {
    this.#candle?.input?.enter();
  }

  /** The picture as of this moment. */
  toBlob(type = "image/png", quality?: number): Promise<Blob> {
    const canvas = this.#canvas;
    return new Promise((resolve, reject) => {
      // The browser owns the pixels after the task that drew them, so they are drawn again.
      this.#draw();
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

  /** Linear RGB of canvas pixels, origin top left. It waits for the GPU. */
  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    const radiance = this.#use((candle) => candle.readRadiance(x, y, width, height));
    return radiance ?? new Float32Array(width * height * 3);
  }

  override addEventListener<Type extends keyof CandleFlameEventMap>(
    type: Type,
    listener: (this: CandleFlameElement, event: CandleFlameEventMap[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: unknown,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener as EventListener, options);
  }

  override removeEventListener<Type extends keyof CandleFlameEventMap>(
    type: Type,
    listener: (this: CandleFlameElement, event: CandleFlameEventMap[Type]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: unknown,
    options?: boolean | EventListenerOptions,
  ): void {
    super.removeEventListener(type, listener as EventListener, options);
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
    ready.catch(() => {}); // whoever does not await it has the event
    return ready;
  }

  #start(): void {
    this.#connection = new AbortController();
    const { signal } = this.#connection;
    this.#clearFailure();
    this.#overlay.showPoster(this.poster);
    this.#internals.states.add("loading");
    this.#watchSight(signal);
    if (this.loading === "lazy") this.#awaitSight(signal);
    else this.#open(signal);
  }

  /** Nothing moves where nobody looks. */
  #watchSight(signal: AbortSignal): void {
    const sight = new IntersectionObserver((entries) => {
      this.#isInSight = entries.at(-1)?.isIntersecting ?? true;
      this.#applySight();
    });
    sight.observe(this);
    signal.addEventListener("abort", () => sight.disconnect());
    const { ownerDocument } = this;
    ownerDocument.addEventListener("visibilitychange", () => this.#applySight(), { signal });
  }

  get #isSeen(): boolean {
    return this.#isInSight && this.ownerDocument.visibilityState === "visible";
  }

  #applySight(): void {
    rooms.review();
    this.#applyMotion();
    if (this.#isSeen && this.#isStale) this.#draw();
  }

  /** Nothing is fetched, compiled or drawn before the visitor is a screen away. */
  #awaitSight(signal: AbortSignal): void {
    const sight = new IntersectionObserver(
      (entries) => {
        if (entries.some(({ isIntersecting }) => isIntersecting)) this.#approach?.();
      },
      { rootMargin: "100%" },
    );
    this.#approach = () => {
      this.#approach = null;
      sight.disconnect();
      if (!signal.aborted) this.#open(signal);
    };
    sight.observe(this);
    signal.addEventListener("abort", () => sight.disconnect());
  }

  /** A room has to wait until the page has a context left; lone candles share one. */
  #open(signal: AbortSignal): void {
    if (this.scene === "candle") {
      this.#internals.states.add("alone");
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
      source.addEventListener("webglcontextlost", this.#contextLost, { signal });
      source.addEventListener("webglcontextrestored", this.#contextRestored, { signal });
      void this.#fetch(signal);
    } catch (error) {
      this.#fail(error as Error);
    }
  }

  #begin(scene: Scene, connection: AbortSignal): void {
    if (!this.#screen || this.#screen.gpu.isLost) return; // it begins when the context is given back
    const candle = new CandleFlame(this.#screen, scene, this.#features, this.#options());
    this.#candle = candle;
    this.#screen = null;
    candle.inspect = this.#inspect;
    candle.onFrame = () => this.#afterFrame();
    candle.onFailure = (error) => this.#failAtShader(error);
    candle.onCandleMoved = () => this.#emit(this.held ? "take" : "place", null);
    candle.onRefused = () => this.#tellRefusal();
    candle.onFlameChanged = this.#flameChanged;
    candle.onQualityChanged = () => this.#emit("qualitychange", null);
    if (this.#asleep) candle.resume(this.#asleep.moment, areSame(this.#asleep.of, this.#shown));
    this.#asleep = null;
    this.#moveCamera(candle, this.#awaitedCamera);
    this.#awaitedCamera = null;
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

  /** Another look, room or base: at once if its models are there, else when they have come. */
  #chooseModels(): void {
    if (!this.#connection || !this.#canvas) return;
    if (areSame(this.#asked, this.#shown)) {
      this.#loading?.abort();
      this.#wanted = null;
      this.#awaitedCamera = null;
      this.#overlay.hideProgress();
      this.#shown = this.#asked;
    } else if (!areSame(this.#asked, this.#wanted)) {
      void this.#fetch(this.#connection.signal);
    }
  }

  /**
   * Fetches what look and `src` ask for; what was asked for before is no longer wanted. What is on show
   * stays until the new models have come, and if they do not come.
   */
  async #fetch(connection: AbortSignal): Promise<void> {
    this.#loading?.abort();
    this.#loading = new AbortController();
    const signal = AbortSignal.any([connection, this.#loading.signal]);
    const wanted = this.#asked;
    this.#wanted = wanted;
    try {
      const onProgress = (share: number) => this.#showProgress(share);
      const scene = await loadScene(wanted, { signal, onProgress });
      if (signal.aborted) return scene.close();
      this.#wanted = null;
      this.#shown = this.#asked;
      this.#show(scene, connection);
    } catch (error) {
      if (signal.aborted) return;
      this.#wanted = null;
      if (!this.#candle) {
        this.#fail(error as Error);
        return;
      }
      this.#awaitedCamera = null;
      this.#overlay.hideProgress();
      this.#report(error as Error);
    }
  }

  #show(scene: Scene, connection: AbortSignal): void {
    const old = this.#scene;
    this.#scene = scene;
    if (!old) {
      this.#begin(scene, connection);
      return;
    }
    this.#use((candle) => {
      candle.show(scene, this.#options());
      this.#moveCamera(candle, this.#awaitedCamera);
    });
    this.#awaitedCamera = null;
    old.close();
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
    return URL.canParse(base, document.baseURI) ? new URL(base, document.baseURI).href : module;
  }

  #reveal(signal: AbortSignal): void {
    this.#overlay.hideProgress();
    this.#overlay.hidePoster();
    this.#internals.states.delete("loading");
    this.#showLit();
    this.#observe(signal);
    this.#applyMotion();
    if (this.#drawnLook !== this.look) this.#overlay.hint.tell(NO_PHYSICAL_LOOK);
    this.#emit("load", null);
    this.#settleReady.resolve();
  }

  #observe(signal: AbortSignal): void {
    if (this.#canvas) {
      observeDevicePixels(this.#canvas, signal, (pixels) => {
        this.#pixels = pixels;
        this.#resize();
        if (this.#isSeen) this.#draw();
        else this.#isStale = true;
      });
    }
    const motion = matchMedia("(prefers-reduced-motion: reduce)");
    motion.addEventListener("change", () => this.#apply(), { signal });
  }

  /** As if the element had been taken out and put back, but time goes on from this moment. */
  #restart(): void {
    const asleep =
      this.#candle && this.#shown
        ? { moment: momentOf(this.#candle.world), of: this.#shown }
        : this.#asleep;
    this.#stop();
    this.#asleep = asleep;
    this.#start();
  }

  #stop(): void {
    this.#release();
    this.#asleep = null;
    this.#settleReady.reject(new DOMException("The element was taken out.", "AbortError"));
    this.ready = this.#promiseReady();
  }

  #release(): void {
    clearTimeout(this.#patience);
    this.#connection?.abort();
    this.#connection = null;
    this.#approach = null;
    this.#forgetRequest();
    this.#candle?.dispose();
    this.#candle = null;
    this.#screen?.dispose();
    this.#screen = null;
    this.#shown = null;
    this.#wanted = null;
    this.#scene?.close();
    this.#scene = null;
    this.#canvas?.remove();
    this.#canvas = null;
    this.#isStale = false;
    this.#internals.states.clear();
    const guest = this.#guest;
    this.#guest = null;
    if (guest) rooms.leave(guest);
  }

  /** No picture: a sentence instead, with the poster behind it. Nothing is thrown at the page. */
  #fail(error: Error): void {
    this.#release();
    this.#connection = new AbortController();
    this.#overlay.hideProgress();
    if (typeOf(error) === "context-lost") this.#offerReload();
    else this.#showFailure(error.message, "alert");
    this.#overlay.showPoster(this.poster);
    this.#settleReady.reject(error);
    this.#report(error);
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
      this.#failAtShader(error as Error);
      return undefined;
    }
  }

  /** A shader that the driver refuses may turn up late: a look or a tier compiles its own. */
  #failAtShader(error: Error): void {
    if (typeOf(error) !== "shader") throw error;
    this.#fail(error);
  }

  #report(error: Error): void {
    this.#emit("error", { type: typeOf(error), message: error.message, cause: error });
  }

  readonly #contextLost = (event: Event): void => {
    event.preventDefault(); // asks the browser to give it back
    this.#candle?.pause();
    this.#overlay.showPoster(this.poster);
    clearTimeout(this.#patience);
    this.#patience = window.setTimeout(() => {
      this.#offerReload();
      this.#report(new ContextLostError(LOST));
    }, PATIENCE);
    this.#emit("contextlost", null);
  };

  readonly #contextRestored = (): void => {
    clearTimeout(this.#patience);
    try {
      this.#screen?.renew();
      this.#clearFailure();
      if (this.#candle) {
        this.#candle.restore();
        this.#overlay.hidePoster();
        this.#applyMotion();
      } else if (this.#scene && this.#connection) {
        this.#begin(this.#scene, this.#connection.signal);
      }
      this.#emit("contextrestored", null);
    } catch (error) {
      this.#fail(error as Error);
    }
  };

  #options() {
    const { seed, quality, exposure, particles, motion } = this;
    const { look } = this.#shown ?? this;
    const wantsLess = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const isStill = motion === "reduced" || (motion === "auto" && wantsLess);
    return {
      look,
      seed,
      quality,
      exposure,
      particles,
      isStill,
      unlit: this.unlit,
      wick: this.wick / 1000,
      wind: {
        speed: this.wind,
        direction: (this.windDirection * Math.PI) / 180,
        gustiness: this.gustiness,
      },
    };
  }

  #applyMotion(): void {
    const candle = this.#candle;
    if (!candle) return;
    const isWalking = this.#internals.states.has("walking");
    const runs = !this.paused && this.#isSeen;
    const { states } = this.#internals;
    if (runs !== states.has("playing")) {
      if (runs) states.add("playing");
      else states.delete("playing");
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
      if (isWalking) states.delete("walking");
    }
  }

  #goInOrOut(isIn: boolean, device: Device): void {
    if (isIn) this.#internals.states.add("walking");
    else this.#internals.states.delete("walking");
    if (isIn) this.#overlay.hint.tellControls(device);
    else this.#overlay.hint.tell(this.#outSentence, this.controls);
    this.#emit(isIn ? "enter" : "leave", null);
  }

  #applyInteraction(): void {
    // Interactive, it is something to enter; passive, the canvas is a picture. Not the element itself:
    // of a picture nothing is read but its name, and what the hint says must be.
    const isPicture = !this.controls && !this.#overlay.isFailing;
    const role = this.#overlay.isFailing ? "group" : "application";
    this.#internals.role = isPicture ? null : role;
    this.#internals.ariaLabel = isPicture ? null : this.alt;
    this.#overlay.posterAlt = isPicture ? this.alt : "";
    if (this.#canvas) {
      this.#canvas.role = isPicture ? "img" : "presentation";
      this.#canvas.ariaLabel = isPicture ? this.alt : null;
    }
    this.#internals.ariaDescription = this.controls
      ? "Press Enter to walk in, and Escape to leave."
      : null;
    if (this.controls && !this.hasAttribute("tabindex")) this.tabIndex = 0;
    if (!this.controls && this.getAttribute("tabindex") === "0") this.removeAttribute("tabindex");
  }

  #resize(): void {
    const cap = Math.min(1, this.maxPixelRatio / devicePixelRatio);
    const { width, height } = this.#pixels;
    this.#use((candle) => candle.resize(Math.max(1, width * cap), Math.max(1, height * cap)));
  }

  /** At the next frame, unless something draws before that anyway. */
  #requestDraw(): void {
    const isPlaying = this.#internals.states.has("playing");
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
    this.#shine();
  }

  #forgetRequest(): void {
    cancelAnimationFrame(this.#drawRequest);
    this.#drawRequest = 0;
  }

  #afterFrame(): void {
    this.#forgetRequest();
    this.#reportCamera();
    this.#shine();
  }

  /** Lets the glow on the page follow the flame, in steps too small to see. */
  #shine(): void {
    if (!this.#internals.states.has("alone")) return;
    const { luminousIntensity = 0 } = this.flame ?? {};
    const intensity = (Math.round(Math.min(luminousIntensity, 1) * 64) / 64).toString();
    if (this.#glow.style.getPropertyValue("--intensity") === intensity) return;
    this.#glow.style.setProperty("--intensity", intensity);
  }

  get #cameraKey(): string {
    const { position, yaw, pitch } = this.camera;
    return `${position} ${yaw} ${pitch}`;
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

declare global {
  interface HTMLElementTagNameMap {
    "candle-flame": CandleFlameElement;
  }
}

function typeOf(error: Error): ErrorType {
  const types: Readonly<Record<string, ErrorType>> = {
    WebGLUnavailableError: "webgl-unavailable",
    ShaderError: "shader",
    ContextLostError: "context-lost",
  } satisfies Record<string, ErrorType>;
  return types[error.name] ?? ("asset" satisfies ErrorType);
}

export type { AssetError };
