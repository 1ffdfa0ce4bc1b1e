import type { Vec3 } from "../geometry.js";

/** Of a breath at full strength: speed at the lips, m/s, and the width of the mouth, m. */
const BREATH_SPEED = 20;
const MOUTH = 0.015;
/** Distance of the lips from the eye, towards the flame: this, or half of the way. Metres. */
const BENDING = 0.25;
/** How long a breath lasts, and how long it takes to swell and to end. Seconds. */
const BREATH = 0.45;
const SWELL = 0.08;
/** A round jet keeps its speed for this many widths of the mouth; then it goes as 1/distance. */
const CORE = 6.2;
/** Its half-width where the speed has fallen to 1/e, per metre of way. */
const SPREAD = 0.107;

/** Breath: a round jet. Pope 2000, "Turbulent Flows". */
export class Breath {
  readonly #lips: Vec3 = [0, 0, 0];
  readonly #towards: Vec3 = [0, 0, -1];
  /** Current time, seconds. A field, since V8 boxes numbers that are passed. */
  time = 0;
  #began = Number.NEGATIVE_INFINITY;
  #speed = 0;

  /**
   * Begins at `time`.
   *
   * @param towards of length 1
   * @param distance of the target from the eye, metres
   * @param strength 1 blows out a candle at arm's length
   */
  begin(eye: Readonly<Vec3>, towards: Readonly<Vec3>, distance: number, strength: number): void {
    const bent = Math.min(BENDING, distance / 2);
    for (const axis of [0, 1, 2] as const) {
      this.#lips[axis] = eye[axis] + towards[axis] * bent;
      this.#towards[axis] = towards[axis];
    }
    this.#began = this.time;
    this.#speed = BREATH_SPEED * strength;
  }

  /** Adds its velocity at a place to `out`, m/s. */
  add(place: Readonly<Vec3>, out: Vec3): void {
    const age = this.time - this.#began;
    if (age < 0 || age > BREATH + 1) return;
    const dx = place[0] - this.#lips[0];
    const dy = place[1] - this.#lips[1];
    const dz = place[2] - this.#lips[2];
    const tx = this.#towards[0];
    const ty = this.#towards[1];
    const tz = this.#towards[2];
    const way = dx * tx + dy * ty + dz * tz;
    if (way <= 0) return;
    // The front of a jet slows down as the jet does: the time to here is the integral of way/speed.
    const reach = CORE * MOUTH;
    const delay =
      (Math.min(way, reach) + Math.max(0, way * way - reach * reach) / (2 * reach)) /
      Math.max(this.#speed, 1e-3);
    const elapsed = age - delay;
    if (elapsed <= 0 || elapsed >= BREATH) return;
    const swell = Math.min(1, elapsed / SWELL, (BREATH - elapsed) / SWELL);
    const aside = dx * dx + dy * dy + dz * dz - way * way;
    const width = MOUTH / 2 + SPREAD * way;
    const speed =
      this.#speed * swell * Math.min(1, reach / way) * Math.exp(-aside / (width * width));
    out[0] += speed * tx;
    out[1] += speed * ty;
    out[2] += speed * tz;
  }
}
