/**
 * Reports of what has happened, given one after another in that order. What a listener does is reported last, after
 * what had happened before.
 */
export class Reports {
  readonly #waiting: (() => void)[] = [];
  #isTelling = false;

  /** Has something reported by the next `tell`. */
  note(report: () => void): void {
    this.#waiting.push(report);
  }

  /** Tells what waits, and last a further report; from within a report, after the others. */
  tell(last?: () => void): void {
    if (last) this.note(last);
    if (this.#isTelling) return;
    this.#isTelling = true;
    try {
      for (let report = this.#waiting.shift(); report; report = this.#waiting.shift()) report();
    } finally {
      this.#isTelling = false;
    }
  }
}
