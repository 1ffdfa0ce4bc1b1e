/** Time constant of the low-pass, seconds: cutoff at 2.5 Hz. */
const LAG = 1 / (2 * Math.PI * 2.5);
/** Largest share by which faster changes pass: with the display's contrast, below a tenth. */
const TREMBLE = 0.0295;

/**
 * Flash limiter of the flame's light.
 *
 * A room that brightens and darkens by a tenth more than three times a second can bring on a seizure (WCAG 2.2,
 * success criterion 2.3.1), and flames that puff do so ten times a second. So light passes a critically damped
 * low-pass of second order, beside which changes below a tenth pass.
 */
export class Limiter {
  /** Light before the limiter. */
  target = 0;
  /** Light after it. */
  light = 0;
  #first = 0;
  #slow = 0;

  /** Sets a steady state. */
  settle(light: number): void {
    this.target = this.light = this.#first = this.#slow = light;
  }

  /** Exact for any step in which the target does not change. Seconds. */
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
