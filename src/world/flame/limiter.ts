/** The light follows with two lags of this length, seconds: what is faster than 2.5 Hz fades. */
const LAG = 1 / (2 * Math.PI * 2.5);
/** What is faster still shows, by no more than this share either way: with the display's contrast, below a tenth. */
const TREMBLE = 0.0295;

/**
 * Light that may change as it likes, and never flashes.
 *
 * A room that brightens and darkens by a tenth more than three times a second can bring on a seizure
 * (WCAG 2.2, success criterion 2.3.1), and flames that puff do so ten times a second. So light passes a
 * low-pass of second order, critically damped, beside which only a tremble below a tenth is let by.
 */
export class Limiter {
  /** The light that there would be. */
  target = 0;
  /** The light that is given. */
  light = 0;
  #first = 0;
  #slow = 0;

  /** Starts from a light that has been so for long. */
  settle(light: number): void {
    this.target = this.light = this.#first = this.#slow = light;
  }

  /** Lets seconds pass. Exact for any step in which the target does not change. */
  advance(seconds: number): void {
    const { target } = this;
    const lags = seconds / LAG;
    const decay = Math.exp(-lags);
    const first = this.#first - target;
    this.#first = target + first * decay;
    this.#slow = target + (this.#slow - target + first * lags) * decay;
    const limit = TREMBLE * this.#slow;
    this.light = this.#slow + Math.min(Math.max(target - this.#slow, -limit), limit);
  }
}
