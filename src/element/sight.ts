/** Whether a visitor can see an element: it is in the viewport, of a page that is not hidden. */
export class Sight {
  readonly #element: Element;
  readonly #signal: AbortSignal;
  /** As far as anyone knows. */
  #isInViewport: boolean;
  #approach: (() => void) | null = null;

  /**
   * @param onChange called when that may have changed, until the signal aborts
   * @param before what was known of the element, which counts until more is
   */
  constructor(
    element: Element,
    signal: AbortSignal,
    onChange: () => void,
    before: Sight | null = null,
  ) {
    this.#isInViewport = before ? before.#isInViewport : true;
    this.#element = element;
    this.#signal = signal;
    const viewport = new IntersectionObserver((entries) => {
      this.#isInViewport = entries.at(-1)?.isIntersecting ?? true;
      onChange();
    });
    viewport.observe(element);
    signal.addEventListener("abort", () => viewport.disconnect());
    element.ownerDocument.addEventListener("visibilitychange", onChange, { signal });
  }

  get isSeen(): boolean {
    return this.#isInViewport && this.#element.ownerDocument.visibilityState === "visible";
  }

  /** Waits until the visitor is a screen away, or until nobody wants to wait any more. */
  awaitApproach(onApproach: () => void): void {
    const nearby = new IntersectionObserver(
      (entries) => {
        if (entries.some(({ isIntersecting }) => isIntersecting)) this.stopWaiting();
      },
      { rootMargin: "100%" },
    );
    this.#approach = () => {
      this.#approach = null;
      nearby.disconnect();
      if (!this.#signal.aborted) onApproach();
    };
    nearby.observe(this.#element);
    this.#signal.addEventListener("abort", () => nearby.disconnect());
  }

  /** Goes on at once with what waits for the visitor, if anything does. */
  stopWaiting(): void {
    this.#approach?.();
  }
}
