import type { CandleFlame } from "./candle-flame.js";
import { cameraOf, changeOf, setCamera } from "./element/camera.js";
import type { Camera, Candle } from "./element/element-types.js";
import { emit } from "./element/events.js";
import { featureSwitches } from "./element/feature-switches.js";
import { boxWithin, lengthOfStep, strengthOfBreath } from "./element/legal-values.js";
import { Lifecycle } from "./element/lifecycle.js";
import { RENDERER_ATTRIBUTES, SCENE_ATTRIBUTES } from "./element/options.js";
import type { PendingWorld } from "./element/pending-world.js";
import { ReflectedAttributes } from "./element/reflected-attributes.js";
import type { Session, SessionInput } from "./element/session.js";
import { styleFor } from "./element/style.js";
import type { FlameReport } from "./light/flame-light.js";
import {
  allFeatures,
  FEATURES,
  type Features,
  INSPECTIONS,
  type Inspection,
  parseIndices,
  type SettingName,
} from "./settings.js";
import { NO_STATS, type Stats } from "./stats.js";
import { blow, placeCandle, takeCandle } from "./world/commands.js";

export type { AssetError } from "./assets/asset-error.js";
export type { Camera, Candle } from "./element/element-types.js";
export type {
  CandleDetail,
  CandleFlameEventMap,
  ErrorDetail,
  ErrorType,
} from "./element/events.js";
export type * from "./framework-types.js";
export type { Feature, Look, Quality } from "./settings.js";
export type { Features, FlameReport, Inspection, Stats };

const NO_CANDLES: readonly Candle[] = Object.freeze([]);

/**
 * A candle in a dark room, or alone on the page.
 *
 * @tagname candle-flame
 * @fires {CustomEvent} progress - Loading goes on; detail.totalProgress is 0 to 1.
 * @fires {CustomEvent} load - The first frame is drawn, or the first of another look or room.
 * @fires {CustomEvent} error - detail.type, detail.message and detail.cause say what failed.
 * @fires {CustomEvent} play - Time passes from now on.
 * @fires {CustomEvent} pause - Time stops: `paused` is set, the canvas is invisible, or the element is taken out.
 * @fires {CustomEvent} light - A candle was lit; detail.index and detail.name say which.
 * @fires {CustomEvent} extinguish - A candle went out; the same.
 * @fires {CustomEvent} place - The candle was put down.
 * @fires {CustomEvent} take - The candle was taken up.
 * @fires {CustomEvent} enter - The visitor entered the room.
 * @fires {CustomEvent} leave - The visitor left.
 * @fires {CustomEvent} qualitychange - Another quality draws, by `quality` or by `auto`.
 * @fires {CustomEvent} camerachange - The visitor moved, looked around or was moved.
 * @fires {CustomEvent} contextlost - The WebGL context was lost.
 * @fires {CustomEvent} contextrestored - The WebGL context is back, and drawing goes on.
 * @slot poster - In place of the poster's image.
 * @slot progress - In place of the bar, while loading.
 * @slot hint - In place of the line that lists the controls.
 * @slot error - In place of the sentence that says what failed.
 * @csspart canvas - The canvas.
 * @csspart poster - The image until the first frame, and where there are no frames.
 * @csspart progress - The bar that shows how far loading is.
 * @csspart hint - A line for the visitor, shown for a moment.
 * @csspart error - The sentence in the canvas's place where there are no frames.
 * @csspart reload - The button that starts again after a file that did not come, or a context that does not come back.
 * @csspart glow - The light that falls on the page, with `scene="candle"`.
 * @cssState loading - There is no frame yet.
 * @cssState lit - The candle burns.
 * @cssState walking - The visitor is in the room.
 * @cssState playing - Time passes.
 * @cssState alone - The candle stands alone on the page.
 * @cssprop [--candle-flame-progress-color=#f0a54a] - Colour of the progress bar.
 * @cssprop [--candle-flame-progress-height=3px] - Height of the progress bar.
 * @cssprop [--candle-flame-glow=0] - Strength of the glow, 0 to 1.
 */
export class CandleFlameElement extends ReflectedAttributes {
  // Attributes are the table `SETTINGS`; what happens from insertion to the first frame is `Lifecycle`'s.
  readonly #input: SessionInput = { attributes: this, features: allFeatures(), inspect: "picture" };
  readonly #featureSwitches: Features;
  readonly #lifecycle: Lifecycle;

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    this.#lifecycle = new Lifecycle(this.attachInternals(), root, this.#input);
    this.#featureSwitches = featureSwitches(this.#input.features, (name) => {
      this.#use((candle) => candle.followFeature(name));
      this.#requestDraw();
    });
  }

  connectedCallback(): void {
    // Here, and not once for all: an element that another document takes in loses its style.
    if (this.shadowRoot) this.shadowRoot.adoptedStyleSheets = styleFor(this.ownerDocument);
    this.upgradeProperties(["features", "camera", "lit", "inspect"]);
    this.#lifecycle.connect();
  }

  disconnectedCallback(): void {
    // A move within the page disconnects and connects in one task: nothing should restart then.
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#pending.leave();
      this.#lifecycle.disconnect();
    });
  }

  attributeChangedCallback(name: SettingName, before: string | null, after: string | null): void {
    const lifecycle = this.#lifecycle;
    if (SCENE_ATTRIBUTES.includes(name)) lifecycle.sceneChanged();
    if (before === after) return;
    if (name === "poster") lifecycle.posterChanged();
    if (name === "alt" || name === "controls") lifecycle.updateAccessibility();
    if (name === "max-pixel-ratio") lifecycle.session?.resize();
    if (name === "loading" && this.loading === "eager") lifecycle.stopWaiting();
    if (RENDERER_ATTRIBUTES.includes(name)) lifecycle.retry();
    if (name === "seed") this.#pending.forgetTime();
    if (name === "lit-wicks" || name === "unlit") this.#pending.forgetFlames(this.#burnsAtFirst);
    lifecycle.apply();
  }

  /** Resolves after the first frame with all assets; rejects with the error that `error` reports. */
  get ready(): Promise<void> {
    return this.#lifecycle.ready;
  }

  /** Techniques that can be switched off, one by one: `element.features.drift = false`. */
  get features(): Features {
    return this.#featureSwitches;
  }
  set features(value: Partial<Features>) {
    for (const name of FEATURES)
      if (value?.[name] !== undefined) this.#featureSwitches[name] = value[name];
  }

  /** What is displayed: the frame, or the output of one pass. */
  get inspect(): Inspection {
    return this.#input.inspect;
  }
  set inspect(value: Inspection) {
    this.#input.inspect = INSPECTIONS.includes(value) ? value : "picture";
    if (this.#candle) this.#candle.view.inspect = this.#input.inspect;
    this.#requestDraw();
  }

  /** The visitor's camera: position, direction and field of view, in metres and radians. */
  get camera(): Required<Camera> {
    return this.#candle ? cameraOf(this.#candle) : this.#pending.cameraFor(this.look);
  }
  set camera(value: Partial<Camera>) {
    const change = changeOf(value, this.camera);
    if (this.#isPending) this.#pending.moveCamera(change);
    if (!this.#candle) return;
    setCamera(this.#candle, change);
    this.#lifecycle.changed();
  }

  /** Seconds simulated since `reset()`. */
  get currentTime(): number {
    return this.#candle?.currentTime ?? this.#pending.currentTime;
  }

  /** Whether the candle is in the hand; else it stands in the room. */
  get held(): boolean {
    const stands = this.scene === "candle" || this.look === "original";
    return this.#candle?.world.candle.isHeld ?? (!stands && this.#pending.isHeld);
  }

  /** The candles of the scene, the carried one first; another list after another scene. Empty before the first frame. */
  get candles(): readonly Candle[] {
    return this.#lifecycle.session?.candles ?? NO_CANDLES;
  }

  /** The flame as of the last frame; its position is the centre of the light. Null before the first. */
  get flame(): FlameReport | null {
    return this.#candle?.flame ?? null;
  }

  /** Statistics of the last frame. */
  get stats(): Stats {
    return this.#candle?.stats ?? NO_STATS;
  }

  /** Lets time pass. */
  play(): void {
    this.paused = false;
  }

  /** Stops time. */
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
    this.#use((candle, session) => {
      // A busy browser reports a change of the preference for reduced motion frames late.
      candle.options = session.options;
      candle.step(length);
    });
    if (this.#candle) this.#lifecycle.reporter.frame(this.#candle);
  }

  /** Restarts at time 0; with a seed, with other random numbers. */
  reset(seed?: number): void {
    const before = this.seed;
    if (seed !== undefined) this.seed = seed;
    this.#pending.forget();
    if (this.seed === before) this.#use((candle) => candle.reset()); // else it is new already
    this.#lifecycle.changed();
  }

  /** Takes over another element's time, camera and candle. */
  mirror(other: CandleFlameElement): void {
    const source = other instanceof CandleFlameElement ? other.#candle : null;
    if (!source) return;
    this.#use((candle) => {
      candle.mirror(source);
      this.#lifecycle.reporter.flame(candle);
    });
    this.#lifecycle.changed();
  }

  /** Puts the candle down ahead; before there is a room, or while another is fetched, once there is one. */
  place(): void {
    if (this.#isPending) this.#pending.place();
    const candle = this.#candle;
    if (!candle?.world.candle.isHeld) return;
    if (placeCandle(candle.world)) candle.reports.tell(() => emit(this, "place", null));
    this.#lifecycle.reporter.refusal(candle);
    this.#requestDraw();
  }

  /** Takes the candle up, where it is within reach. */
  take(): void {
    const isTaken = this.#isPending && this.#pending.take();
    const candle = this.#candle;
    const emitTake = () => emit(this, "take", null);
    if (isTaken) emitTake();
    else if (candle && takeCandle(candle.world)) candle.reports.tell(emitTake);
    else if (candle && !candle.world.candle.isHeld) this.#lifecycle.reporter.refusal(candle);
    this.#requestDraw();
  }

  /** Whether the candle burns; writing lights it or puts it out. */
  get lit(): boolean {
    return this.#candle?.world.flame.isLit ?? this.#pending.isLit ?? this.#burnsAtFirst;
  }
  set lit(value: boolean) {
    if (value) this.light();
    else if (value != null) this.extinguish(); // templates hand over what is unset
  }

  /** Lights the candle: the flame grows. */
  light(): void {
    this.#setLit(true);
  }

  /** Puts the candle out: the ember fades. */
  extinguish(): void {
    this.#setLit(false);
  }

  #setLit(isLit: boolean): void {
    const isReplaced = this.#isPending && this.scene === "candle";
    this.#pending.setLit(isLit, !this.#candle || isReplaced);
    this.#candle?.setLit(isLit);
    this.#requestDraw();
  }

  /** A breath from the camera: the flame leans, and goes out if it is strong enough. */
  blow(strength = 1): void {
    if (this.#candle) blow(this.#candle.world, strengthOfBreath(strength));
  }

  /** Enters the room: takes the focus, and locks the pointer unless a gamepad's A is down. Needs `controls`. */
  enter(): void {
    this.#lifecycle.session?.controls.enter();
  }

  /** The current frame as an image file. */
  toBlob(type = "image/png", quality?: number): Promise<Blob> {
    return new Promise((resolve, reject) => {
      this.#lifecycle.draws.refresh();
      const { session } = this.#lifecycle;
      if (!session?.candle || session.isLost) {
        reject(new Error("There is no picture yet: wait for `ready`."));
        return;
      }
      const done = (blob: Blob | null) =>
        blob ? resolve(blob) : reject(new Error(`No picture of type ${type}.`));
      session.canvas.toBlob(done, type, quality);
    });
  }

  /** Linear RGB of canvas pixels, origin top left; a larger box is cut to the canvas. Waits for the GPU. */
  readRadiance(x: number, y: number, width: number, height: number): Float32Array {
    this.#lifecycle.draws.refresh();
    this.#lifecycle.draws.invalidate(); // reading may go on drawing
    const box = boxWithin(this.#lifecycle.session?.canvas ?? null, [x, y, width, height]);
    const [, , columns, rows] = box;
    const radiance = columns * rows > 0 && this.#use((candle) => candle.view.readRadiance(box));
    return radiance || new Float32Array(columns * rows * 3);
  }

  /** Whether the attributes light the first candle. */
  get #burnsAtFirst(): boolean {
    return !this.unlit && parseIndices(this.litWicks)?.includes(0) !== false;
  }

  /** Whether a world is to come that will be as the page asks now. */
  get #isPending(): boolean {
    const { session } = this.#lifecycle;
    return !session?.candle || session.isFetching;
  }

  get #candle(): CandleFlame | null {
    return this.#lifecycle.session?.candle ?? null;
  }

  #use<Result>(action: (candle: CandleFlame, session: Session) => Result): Result | undefined {
    const { session } = this.#lifecycle;
    return session?.use((candle) => action(candle, session));
  }

  get #pending(): PendingWorld {
    return this.#lifecycle.pending;
  }

  #requestDraw(): void {
    if (this.#candle) this.#lifecycle.draws.request();
  }
}

declare global {
  interface HTMLElementTagNameMap {
    "candle-flame": CandleFlameElement;
  }
}
