/** Holder of a WebGL context of its own, or an applicant for one. */
export interface ContextClient {
  isVisible(): boolean;
  acquire(): void;
  /** The context must go, in favour of a visible client. Another may be requested. */
  release(): void;
}

/**
 * Pool of the WebGL contexts that the rooms on one page may hold at once.
 *
 * Beyond its limit a browser drops the oldest context, visible or not. Here the rest waits: an invisible client
 * gives way to a visible one, and a visible one never has to.
 */
export class ContextPool {
  readonly #limit: () => number;
  readonly #holders = new Set<ContextClient>();
  readonly #waiting = new Set<ContextClient>();

  constructor(limit: () => number) {
    this.#limit = limit;
  }

  /** Calls `acquire`, at once or when a context is free. Returns whether it was at once. */
  request(client: ContextClient): boolean {
    this.#waiting.add(client);
    this.review();
    return this.#holders.has(client);
  }

  /** The client has no context any more, and waits for none. */
  free(client: ContextClient): void {
    this.#waiting.delete(client);
    if (this.#holders.delete(client)) this.review();
  }

  /** To be called when a client's visibility has changed. */
  review(): void {
    // Visible clients first, then by the order of their requests.
    const clients = [...this.#waiting].sort(
      (a, b) => Number(b.isVisible()) - Number(a.isVisible()),
    );
    for (const client of clients) {
      if (!this.#waiting.has(client)) continue; // an `acquire` or `release` above has changed it
      if (this.#holders.size >= this.#limit() && client.isVisible()) this.#evictInvisible();
      if (this.#holders.size >= this.#limit()) return;
      this.#waiting.delete(client);
      this.#holders.add(client);
      client.acquire();
    }
  }

  #evictInvisible(): void {
    for (const client of this.#holders) {
      if (client.isVisible()) continue;
      this.#holders.delete(client);
      client.release();
      return;
    }
  }
}

/** Browsers give a page sixteen contexts, on phones eight; some are left to lone candles and to the page. */
export const contextPool = new ContextPool(() =>
  matchMedia("(pointer: coarse)").matches ? 7 : 14,
);
