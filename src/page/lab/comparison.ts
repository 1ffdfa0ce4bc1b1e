import type { CandleFlameElement, Look } from "../../candle-flame-element.js";
import { copyShared, createSecondRoom, SHARED } from "./second-room.js";

/** Longest time step of a frame, seconds: a tab that was hidden does not fast-forward. */
const MAX_FRAME = 1 / 20;

/**
 * A second room over the first, in another look, with the same camera at the same time.
 *
 * Both are paused and stepped by one loop. The visitor walks in the first; its camera, candle and settings are
 * copied to the second. The second exists while the comparison is open.
 */
export class Comparison {
  /** Called when it opens or closes; with a sentence when it closed because a room failed. */
  onChange: (failure: string) => void = () => {};
  readonly #room: CandleFlameElement;
  readonly #stage: HTMLElement;
  readonly #observer = new MutationObserver(() => this.#copyAttributes());
  #second: CandleFlameElement | null = null;
  #open = new AbortController();
  #wasHeld = true;
  #state: "closed" | "loading" | "open" = "closed";
  #request = 0;
  #lastTime = Number.NaN;
  #frameMs = Number.NaN;

  constructor(room: CandleFlameElement, stage: HTMLElement) {
    this.#room = room;
    this.#stage = stage;
  }

  get state() {
    return this.#state;
  }

  /** Time from frame to frame, milliseconds; `null` while there is none, since both are paused. */
  get frameMs(): number | null {
    return this.#state === "open" && this.#frameMs > 0 ? this.#frameMs : null;
  }

  /** The room that is visible at a share of the stage's width, which the divider cuts. */
  roomAt(x: number): CandleFlameElement {
    const divider = Number.parseFloat(this.#stage.style.getPropertyValue("--divider"));
    return (this.#state === "open" && 100 * x < divider && this.#second) || this.#room;
  }

  /** The second room's. */
  set look(look: Look) {
    if (this.#second) this.#second.look = look;
  }

  open(look: Look): void {
    if (this.#second) return;
    const second = createSecondRoom(this.#room, look);
    second.classList.add("beside");
    this.#second = second;
    this.#state = "loading";
    this.#open = new AbortController();
    const { signal } = this.#open;
    const loaded = () => {
      if (this.#state === "loading") this.#begin(signal);
      second.mirror(this.#room); // its models may change later, too
    };
    second.addEventListener("load", loaded, { signal });
    for (const room of [this.#room, second]) {
      room.addEventListener("error", ({ detail }) => this.close(detail.message), { signal });
    }
    this.#stage.append(second);
    this.onChange("");
  }

  #begin(signal: AbortSignal): void {
    const room = this.#room;
    this.#state = "open";
    this.#copyAttributes();
    const wasPaused = room.paused;
    room.pause();
    this.#wasHeld = room.held;
    this.#observer.observe(room, { attributeFilter: SHARED });
    this.#lastTime = Number.NaN;
    this.#request = requestAnimationFrame(this.#frame);
    signal.addEventListener("abort", () => {
      cancelAnimationFrame(this.#request);
      this.#observer.disconnect();
      room.paused = wasPaused;
    });
    this.onChange("");
  }

  close(failure = ""): void {
    if (!this.#second) return;
    this.#open.abort();
    this.#second.remove();
    this.#second = null;
    this.#state = "closed";
    this.onChange(failure);
  }

  readonly #frame = (milliseconds: DOMHighResTimeStamp): void => {
    this.#request = requestAnimationFrame(this.#frame);
    this.#frameMs = milliseconds - this.#lastTime;
    this.#lastTime = milliseconds;
    this.#step(this.#frameMs > 0 ? Math.min(this.#frameMs / 1000, MAX_FRAME) : 0);
  };

  #step(seconds: number): void {
    const second = this.#second;
    if (!second) return;
    second.features = this.#room.features;
    this.#room.step(seconds);
    this.#copyCamera(second);
    this.#copyCandle(second);
    for (const [i, { lit }] of this.#room.candles.entries()) {
      const candle = second.candles[i];
      if (candle && candle.lit !== lit) candle.lit = lit;
    }
    second.step(seconds);
  }

  #copyAttributes(): void {
    if (this.#second) copyShared(this.#room, this.#second);
  }

  // Only one that differs: setting it brings the hand to rest.
  #copyCamera(second: CandleFlameElement): void {
    const { camera } = this.#room;
    if (JSON.stringify(camera) !== JSON.stringify(second.camera)) second.camera = camera;
  }

  #copyCandle(second: CandleFlameElement): void {
    const { held } = this.#room;
    if (held === this.#wasHeld) return;
    this.#wasHeld = held;
    if (held) second.take();
    else second.place();
  }
}
