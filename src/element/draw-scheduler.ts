import { windowOf } from "../window-of.js";

interface Hooks {
  /** Whether a visitor can see the canvas. */
  readonly isVisible: () => boolean;
  /** Whether the animation loop draws anyway. */
  readonly isPlaying: () => boolean;
  /** @param isRequired whether the canvas may not keep the image that it has */
  readonly draw: (isRequired?: boolean) => void;
}

/**
 * Draw scheduler: one draw in a frame at most, and none while the canvas is invisible.
 *
 * It also tracks whether the canvas still holds its pixels, which the browser may discard after the task that drew
 * them.
 */
export class DrawScheduler {
  readonly #element: Element;
  readonly #hooks: Hooks;
  #isRequested = false;
  #isFresh = false;
  #afterwards: (() => void) | null = null;
  /** Whether something changed while the canvas was invisible. */
  #isStale = false;

  constructor(element: Element, hooks: Hooks) {
    this.#element = element;
    this.#hooks = hooks;
  }

  /** Draws at the next frame, or once the canvas is visible. */
  request(): void {
    this.#isFresh = false;
    if (this.#hooks.isPlaying() || this.#isRequested) return;
    this.#isRequested = this.#hooks.isVisible();
    const draw = () => this.#isRequested && this.draw();
    if (this.#isRequested) windowOf(this.#element).requestAnimationFrame(draw);
    else this.#isStale = true;
  }

  draw(isRequired?: boolean): void {
    this.#isStale = false;
    this.#isRequested = false;
    this.#hooks.draw(isRequired);
  }

  /**
   * Draws now, or once the canvas is visible.
   *
   * @param appears whether it may be, before the browser says so
   */
  drawIfVisible(appears: boolean): void {
    this.#isFresh = false;
    if (appears || this.#hooks.isVisible()) this.draw();
    else this.#isStale = true;
  }

  /** Calls back after the next frame: one that is drawn now, unless the animation loop draws. */
  afterNext(callback: () => void): void {
    this.#afterwards = callback;
    this.review();
  }

  /** Draws unless the canvas holds the current frame. */
  refresh(): void {
    if (!this.#isFresh) this.draw(true);
  }

  /** Marks the pixels of the canvas as outdated. */
  invalidate(): void {
    this.#isFresh = false;
  }

  /** To be called when the canvas may have become visible, or the animation loop may have stopped. */
  review(): void {
    if (this.#afterwards && !this.#hooks.isPlaying()) this.draw(true);
    else if (this.#isStale && this.#hooks.isVisible()) this.draw();
  }

  /** To be called when a frame was drawn: none is while a renderer is prepared, unless it is required. */
  drawn(): void {
    this.#isRequested = false;
    this.#isFresh = true;
    this.#afterwards?.();
    this.#afterwards = null;
    queueMicrotask(() => {
      this.#isFresh = false;
    });
  }

  reset(): void {
    this.#isRequested = false;
    this.#isFresh = false;
    this.#isStale = false;
    this.#afterwards = null;
  }
}
