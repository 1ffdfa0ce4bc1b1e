import { windowOf } from "./window-of.js";

/** Weight of the newest frame in the running mean of frame times. */
const SMOOTHING = 0.1;

/**
 * Animation loop: calls back in each frame of the window that shows a canvas, with the milliseconds since the last one.
 */
export class AnimationLoop {
  /** Running mean of the time from frame to frame, milliseconds; NaN before the second frame. */
  frameMs = Number.NaN;
  readonly #onFrame: (elapsed: number) => void;
  readonly #window: Window;
  #request = 0;
  #last = Number.NaN;

  constructor(onFrame: (elapsed: number) => void, canvas: HTMLCanvasElement) {
    this.#onFrame = onFrame;
    this.#window = windowOf(canvas);
  }

  get isRunning(): boolean {
    return this.#request !== 0;
  }

  start(): void {
    if (this.isRunning) return;
    this.#last = Number.NaN;
    this.#request = this.#window.requestAnimationFrame(this.#frame);
  }

  stop(): void {
    this.#window.cancelAnimationFrame(this.#request);
    this.#request = 0;
  }

  readonly #frame = (milliseconds: DOMHighResTimeStamp): void => {
    this.#request = this.#window.requestAnimationFrame(this.#frame);
    const elapsed = milliseconds - this.#last;
    this.#last = milliseconds;
    if (elapsed > 0) {
      const mean = Number.isNaN(this.frameMs) ? elapsed : this.frameMs;
      this.frameMs = mean + (elapsed - mean) * SMOOTHING;
    }
    this.#onFrame(elapsed);
  };
}
