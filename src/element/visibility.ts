/** Visibility of an element: whether it is in the viewport, of a page that is not hidden. */
export class Visibility {
  readonly #element: Element;
  readonly #document: Document;
  readonly #signal: AbortSignal;
  #isInViewport: boolean;
  #approach: (() => void) | null = null;

  /**
   * @param onChange called when the visibility may have changed, until the signal aborts
   * @param before an earlier observer of the element, whose answer counts until the browser has given one
   */
  constructor(
    element: Element,
    signal: AbortSignal,
    onChange: () => void,
    before: Visibility | null = null,
  ) {
    this.#isInViewport = before ? before.#isInViewport : true;
    this.#element = element;
    this.#document = element.ownerDocument;
    this.#signal = signal;
    const viewport = new IntersectionObserver((entries) => {
      this.#isInViewport = entries.at(-1)?.isIntersecting ?? true;
      onChange();
    });
    viewport.observe(element);
    signal.addEventListener("abort", () => viewport.disconnect());
    this.#document.addEventListener("visibilitychange", onChange, { signal });
  }

  get isVisible(): boolean {
    return this.#isInViewport && this.#element.ownerDocument.visibilityState === "visible";
  }

  /** Whether another document has taken the element in: listeners are the former one's. */
  get isElsewhere(): boolean {
    return this.#document !== this.#element.ownerDocument;
  }

  /** Calls back once the viewport is a screen away, or at `stopWaiting`. */
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

  stopWaiting(): void {
    this.#approach?.();
  }
}
