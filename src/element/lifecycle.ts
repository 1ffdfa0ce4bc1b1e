import type { CandleFlame } from "../candle-flame.js";
import { ContextLostError } from "../gl/gpu-object.js";
import { nextTask } from "../gl/next-task.js";
import { type ContextClient, contextPool } from "../scenes/context-pool.js";
import { Accessibility } from "./accessibility.js";
import { CandleReporter } from "./candle-reporter.js";
import { CustomStates } from "./custom-states.js";
import { DrawScheduler } from "./draw-scheduler.js";
import { emit, frameError, typeOf } from "./events.js";
import { LifecycleStates } from "./lifecycle-states.js";
import { FULL, LOST, NO_PHYSICAL_LOOK } from "./messages.js";
import { lessMotion } from "./options.js";
import { Overlay } from "./overlay.js";
import { PendingWorld } from "./pending-world.js";
import { ReadyPromise } from "./ready-promise.js";
import type { ReflectedAttributes } from "./reflected-attributes.js";
import { Session, type SessionInput } from "./session.js";
import { Visibility } from "./visibility.js";

/**
 * Lifecycle of the element: acts on each transition of `LifecycleStates`.
 *
 * connected -> near the viewport -> a WebGL context -> models -> first frame; with a lost context, a failure,
 * and a restart from each. What a session holds is freed by `#release`.
 */
export class Lifecycle {
  readonly pending = new PendingWorld();
  readonly draws: DrawScheduler;
  readonly reporter: CandleReporter;
  readonly #machine = new LifecycleStates();
  readonly #element: ReflectedAttributes;
  readonly #input: SessionInput;
  readonly #overlay: Overlay;
  readonly #states: CustomStates;
  readonly #accessibility: Accessibility;
  readonly #ready = new ReadyPromise();
  #abort = new AbortController();
  #visibility: Visibility | null = null;
  #session: Session | null = null;
  readonly #client: ContextClient = {
    isVisible: () => this.isVisible,
    acquire: () => this.#load(),
    release: () => this.restart(),
  };
  readonly #emitPlace = () => emit(this.#element, "place", null);

  constructor(internals: ElementInternals, root: ShadowRoot, input: SessionInput) {
    const element = input.attributes;
    this.#element = element;
    this.#input = input;
    this.#overlay = new Overlay(root);
    this.#states = new CustomStates(element, internals);
    this.#accessibility = new Accessibility(element, internals, this.#overlay);
    this.#overlay.onFailureChange = () => this.updateAccessibility();
    this.reporter = new CandleReporter(element, this.#states, this.#overlay);
    this.draws = new DrawScheduler(element, {
      isVisible: () => this.isVisible,
      isPlaying: () => this.#states.has("playing"),
      draw: (isRequired) => {
        this.#session?.use((candle) => {
          candle.draw(isRequired);
          this.reporter.glow(candle);
        });
      },
    });
  }

  /** Null before there is a WebGL context, and after a failure. */
  get session(): Session | null {
    return this.#session;
  }

  get ready(): Promise<void> {
    return this.#ready.promise;
  }

  get isVisible(): boolean {
    return this.#visibility?.isVisible ?? true;
  }

  connect(): void {
    this.updateAccessibility();
    if (this.#machine.send("connect")) this.#begin();
    else if (this.#visibility?.isElsewhere) this.restart();
  }

  disconnect(): void {
    if (!this.#machine.send("disconnect")) return;
    this.#release();
    this.#ready.settle(new DOMException("The element was removed.", "AbortError"));
    this.#ready.renew();
  }

  /** Like a removal and a new insertion, but the simulated time continues. */
  restart(): void {
    if (!this.#machine.send("restart")) return;
    const { candle, shownRequest } = this.#session ?? {};
    this.#release();
    this.#ready.renew();
    if (candle && shownRequest) this.pending.save(candle.world, shownRequest);
    this.#begin();
  }

  /** An attribute was set that decides which models are fetched. */
  sceneChanged(): void {
    if (this.#states.has("alone") !== (this.#element.scene === "candle")) this.restart();
    this.#session?.follow();
  }

  /** After a failure, another value of an attribute may do better. */
  retry(): void {
    if (this.#machine.current === "failed" && this.#element.isConnected) this.restart();
  }

  posterChanged(): void {
    const { current } = this.#machine;
    if (current !== "running" && current !== "detached") this.#overlay.showPoster(this.#element);
  }

  /** Goes on without waiting for the viewport. */
  stopWaiting(): void {
    this.#visibility?.stopWaiting();
  }

  /** Hands the attributes to the candle. */
  apply(): void {
    this.#session?.applyOptions();
    this.#applyMotion();
    this.changed();
  }

  /** To be called when the candle has changed since the last frame. */
  changed(): void {
    const { candle } = this.#session ?? {};
    if (!candle) return;
    this.reporter.camera(candle);
    this.draws.request();
  }

  updateAccessibility(): void {
    this.#accessibility.update(this.#session?.canvas ?? null);
  }

  #begin(): void {
    const element = this.#element;
    this.#abort = new AbortController();
    const { signal } = this.#abort;
    this.#overlay.clearFailure();
    this.#overlay.showPoster(element);
    this.#states.toggle("loading", true);
    this.#states.toggle("alone", this.#element.scene === "candle");
    const visibilityChanged = () => {
      contextPool.review();
      this.#applyMotion();
      this.draws.review();
    };
    this.#visibility = new Visibility(element, signal, visibilityChanged, this.#visibility);
    if (element.loading === "lazy") this.#visibility.awaitApproach(() => this.#queue());
    else this.#queue();
  }

  /** A room waits for a context; lone candles share one. */
  #queue(): void {
    this.#machine.send("approach");
    if (this.#element.scene === "candle") this.#load();
    else if (!contextPool.request(this.#client)) this.#overlay.fail(FULL, "status");
  }

  #load(): void {
    this.#machine.send("admit");
    this.#overlay.clearFailure();
    const { signal } = this.#abort;
    // A canvas cannot have another context after its own was released, so each session has its own canvas.
    const canvas = document.createElement("canvas");
    canvas.part.add("canvas");
    this.#element.shadowRoot?.prepend(canvas);
    signal.addEventListener("abort", () => canvas.remove());
    this.#accessibility.update(canvas);
    try {
      this.#session = new Session(canvas, this.#input, signal, this);
    } catch (error) {
      // Later: a page that inserts it listens afterwards.
      void nextTask().then(() => signal.aborted || this.#fail(frameError(error)));
    }
  }

  /** @param totalProgress of the models' files, 0 to 1 */
  onProgress(totalProgress: number): void {
    this.#overlay.showProgress(totalProgress);
    emit(this.#element, "progress", { totalProgress });
  }

  readonly onFetch = () => this.#ready.renew(); // another scene is on its way

  onScene(candle: CandleFlame): void {
    this.applyPending(candle, this.#emitPlace);
    this.#overlay.hideProgress();
    this.changed();
    emit(this.#element, "load", null);
    this.draws.afterNext(() => void this.#settle());
  }

  onMissing(error: Error): void {
    if (this.#session?.shownRequest || this.#session?.isFetching) {
      this.onFetchDropped();
      this.emitError(error);
    } else this.#fail(error);
  }

  /** The fetch was aborted: the attributes ask for the scene that is shown. */
  onFetchDropped(): void {
    if (this.#session?.candle) {
      this.pending.forgetPlaces();
      void this.#settle();
    }
    this.#overlay.hideProgress();
  }

  /** Gives a candle what the page has asked for meanwhile, if anything; without `onPlaced` it is not shown yet. */
  applyPending(candle: CandleFlame, onPlaced?: () => void): boolean {
    const { shownRequest = null, isFetching = false } = this.#session ?? {};
    return this.pending.applyTo(candle, shownRequest, isFetching, onPlaced);
  }

  /** Shows the first frame. */
  onCandle(candle: CandleFlame): void {
    const session = this.#session;
    this.applyPending(candle, this.#emitPlace);
    this.reporter.watch(candle);
    candle.view.onDrawn = () => this.draws.drawn();
    candle.onFrame = () => this.reporter.frame(candle);
    session?.resize();
    this.draws.draw();
    if (!session?.candle) return; // it could not be drawn
    this.#machine.send("reveal");
    this.#overlay.hideProgress();
    this.#overlay.hidePoster();
    this.#states.toggle("loading", false);
    this.reporter.flame(candle);
    session.followSize((appears) => this.draws.drawIfVisible(appears));
    const { signal } = this.#abort;
    lessMotion(this.#element).addEventListener("change", () => this.apply(), { signal });
    this.#applyMotion();
    if (this.#session !== session) return; // a listener asked for another scene
    if (session.look !== this.#element.look) this.#overlay.hint.tell(NO_PHYSICAL_LOOK, true);
    void this.#settle();
    emit(this.#element, "load", null);
  }

  /** Resolves `ready`, unless another scene is on its way. */
  async #settle(): Promise<void> {
    const session = this.#session;
    const completion = session?.completion;
    if (completion) await completion;
    if (this.#session === session && !session?.isFetching) this.#ready.settle();
  }

  onContextLost(): void {
    // It may be lost again before all of it is restored.
    if (!this.#machine.send("lose")) return;
    this.#applyMotion();
    this.#overlay.showPoster(this.#element);
    emit(this.#element, "contextlost", null);
  }

  onContextRestored(): void {
    if (!this.#machine.send("restore")) return;
    this.#overlay.clearFailure();
    const wasRejected = this.#ready.renewRejected(); // a first frame is to come after all
    if (this.#machine.current === "running") this.#overlay.hidePoster();
    this.#applyMotion();
    if (wasRejected) this.draws.afterNext(() => void this.#settle());
    emit(this.#element, "contextrestored", null);
  }

  onContextGivenUp(): void {
    this.#session?.candle?.input?.leave();
    this.#overlay.fail(LOST, "alert", this.#reload);
    this.#report(new ContextLostError(LOST));
  }

  plays(): boolean {
    return !this.#element.paused && this.isVisible;
  }

  /** Applies the attributes `paused` and `controls`. */
  #applyMotion(): void {
    const session = this.#session;
    const candle = session?.candle;
    if (!candle) return;
    const plays = this.plays() && this.#machine.current === "running";
    if (plays) candle.play();
    else candle.pause();
    session.controls.apply(candle, (...entering) => this.reporter.entered(candle, ...entering));
    if (plays === this.#states.has("playing")) return;
    this.#states.toggle("playing", plays);
    // Last: a listener may have it otherwise.
    emit(this.#element, plays ? "play" : "pause", null);
  }

  /** Ends the session after an error in drawing or in preparing to draw. */
  onError(cause: unknown): void {
    const error = frameError(cause);
    // The event of a lost context follows, and the frame comes back with it. Queries of a lost context end in any error.
    if (typeOf(error) !== "context-lost" && !this.#session?.isLost) this.#fail(error);
  }

  /** Shows an error message in place of frames, over the poster. Does not throw. */
  #fail(error: Error): void {
    if (!this.#machine.send("fail")) return;
    this.#release();
    this.#states.toggle("alone", this.#element.scene === "candle"); // nothing lies behind it
    const type = typeOf(error);
    const isLost = type === "context-lost";
    const reload = isLost || type === "asset" ? this.#reload : null;
    this.#overlay.fail(isLost ? LOST : error.message, "alert", reload);
    this.#overlay.showPoster(this.#element);
    this.#report(error);
    if (type === "graphics") console.error(error); // the driver's own words are in its cause
  }

  /** `ready` rejects with it, if it is pending. */
  #report(error: Error): void {
    this.#ready.settle(error);
    this.emitError(error);
  }

  emitError(error: Error): void {
    emit(this.#element, "error", { type: typeOf(error), message: error.message, cause: error });
  }

  readonly #reload = (): void => {
    this.restart();
    // The focus would go with the button.
    if (this.#element.controls) this.#element.focus({ preventScroll: true });
  };

  #release(): void {
    this.#abort.abort();
    this.#session?.dispose();
    this.#session = null;
    this.#overlay.clear();
    this.draws.reset();
    const emitPause = () => emit(this.#element, "pause", null);
    if (this.#states.has("playing")) queueMicrotask(emitPause); // all is free by then
    this.reporter.stop();
    contextPool.free(this.#client);
  }
}
