/** One who wants a WebGL context of its own. */
export interface Guest {
  /** Whether a visitor sees it. */
  readonly isSeen: boolean;
  /** There is a place. */
  enter(): void;
  /** Gives its place up, for another who is seen; it may ask again. */
  yield(): void;
}

/**
 * The WebGL contexts that rooms on one page may hold at once.
 *
 * Beyond its limit a browser takes the oldest away, whether it is seen or not. Here the rest waits: whoever
 * is not seen gives way to whoever is, and nobody who is seen ever has to.
 */
export class Places {
  readonly #limit: () => number;
  readonly #held = new Set<Guest>();
  readonly #waiting = new Set<Guest>();

  constructor(limit: () => number) {
    this.#limit = limit;
  }

  /** Lets the guest enter, at once or when a place is free; says whether it was at once. */
  ask(guest: Guest): boolean {
    this.#waiting.add(guest);
    this.review();
    return this.#held.has(guest);
  }

  /** The guest's place is free, or it no longer wants one. */
  leave(guest: Guest): void {
    this.#waiting.delete(guest);
    if (this.#held.delete(guest)) this.review();
  }

  /** To be called when somebody has come into sight, or gone out of it. */
  review(): void {
    for (const guest of this.#inOrder()) {
      if (!this.#waiting.has(guest)) continue; // another's coming or going has changed it meanwhile
      if (this.#held.size >= this.#limit() && guest.isSeen) this.#makeRoom();
      if (this.#held.size >= this.#limit()) return;
      this.#waiting.delete(guest);
      this.#held.add(guest);
      guest.enter();
    }
  }

  /** Those who are seen first, then by the order in which they asked. */
  #inOrder(): readonly Guest[] {
    const guests = [...this.#waiting];
    return [...guests.filter(({ isSeen }) => isSeen), ...guests.filter(({ isSeen }) => !isSeen)];
  }

  #makeRoom(): void {
    for (const guest of this.#held) {
      if (guest.isSeen) continue;
      this.#held.delete(guest);
      guest.yield();
      return;
    }
  }
}

/** Browsers give a page sixteen contexts, on phones eight; some are left to lone candles and to the page. */
const LIMIT = { fine: 14, coarse: 7 } as const;

export const rooms = new Places(() =>
  matchMedia("(pointer: coarse)").matches ? LIMIT.coarse : LIMIT.fine,
);
