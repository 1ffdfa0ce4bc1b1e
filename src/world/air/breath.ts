import type { Vec3 } from "../geometry.js";

/** Of a breath at full strength: speed at the lips, m/s, and the width of the mouth, m. */
const BREATH_SPEED = 20;
const MOUTH = 0.015;
/** Distance of the lips from the eye, towards the flame: this, or half of the way. Metres. */
const BENDING = 0.25;
/** How long a breath lasts, and how long it takes to swell and to end. Seconds. */
const BREATH = 0.45;
const SWELL = 0.08;
/**
 * A round jet keeps its speed for this many widths of the mouth; then it goes as 1/distance: 7.0 sqrt(pi/4), after
 * Fischer et al. 1979, "Mixing in Inland and Coastal Waters".
 */
const CORE = 6.2;
/** Its half-width where the speed has fallen to 1/e, per metre of way: the same. */
const SPREAD = 0.107;

/** Breaths of one mouth that are under way at a time, a further one in place of the first. */
const PUFFS = 12;
/** One that begins this soon after the last, in its direction, is the same one: made stronger, if it is. Seconds. */
const APART = 0.2;
const SAME = 0.99; // cosine
/** Age at which the weakest that a draught does not hide has passed the end of its reach, seconds. */
const OLDEST = 15;

type Puff = ReturnType<typeof createPuff>;

const createPuff = () => ({
  lips: [0, 0, 0] as Vec3,
  towards: [0, 0, -1] as Vec3,
  began: Number.NEGATIVE_INFINITY,
  speed: Number.NaN,
  reach: Number.NaN,
  /** At the place asked for, m/s. */
  felt: Number.NaN,
});

/** Breaths of one mouth: round jets. Of several at a place the strongest is felt. */
export class Breath {
  readonly #puffs = Array.from({ length: PUFFS }, createPuff);
  /** Current time, seconds. A field, since V8 boxes numbers that are passed. */
  time = 0;
  /** When the last of them began, seconds. */
  #latest = Number.NEGATIVE_INFINITY;

  /**
   * Begins another at `time`.
   *
   * @param towards of length 1
   * @param distance of the target from the eye, metres
   * @param strength 1 blows out a candle at arm's length
   * @param reach from the eye, beyond which nothing is felt, metres
   */
  begin(
    eye: Readonly<Vec3>,
    towards: Readonly<Vec3>,
    distance: number,
    strength: number,
    reach: number,
  ): void {
    const last = this.#puffs[PUFFS - 1]!;
    const [x, y, z] = last.towards;
    const isSame = x * towards[0] + y * towards[1] + z * towards[2] > SAME;
    if (isSame && this.time - last.began < APART) {
      last.speed = Math.max(last.speed, BREATH_SPEED * strength);
      return;
    }
    const bent = Math.min(BENDING, distance / 2);
    const puff = this.#puffs.shift()!;
    this.#puffs.push(puff);
    for (const axis of [0, 1, 2] as const) {
      puff.lips[axis] = eye[axis] + towards[axis] * bent;
      puff.towards[axis] = towards[axis];
    }
    puff.began = this.time;
    this.#latest = Math.max(this.#latest, this.time);
    puff.speed = BREATH_SPEED * strength;
    puff.reach = reach - bent;
  }

  /** Adds its velocity at a place to `out`, m/s. */
  add(place: Readonly<Vec3>, out: Vec3): void {
    if (this.time - this.#latest > OLDEST) return; // all are over
    let strongest = this.#puffs[0]!;
    for (let i = 0; i < PUFFS; i++) {
      const puff = this.#puffs[i]!;
      this.#feel(puff, place);
      if (puff.felt > strongest.felt) strongest = puff;
    }
    for (let axis = 0; axis < 3; axis++) out[axis]! += strongest.felt * strongest.towards[axis]!;
  }

  #feel(puff: Puff, place: Readonly<Vec3>): void {
    const { lips, towards, speed } = puff;
    puff.felt = 0;
    const age = this.time - puff.began;
    if (age < 0 || age > OLDEST) return;
    const dx = place[0] - lips[0];
    const dy = place[1] - lips[1];
    const dz = place[2] - lips[2];
    const way = dx * towards[0] + dy * towards[1] + dz * towards[2];
    if (way <= 0 || way > puff.reach) return;
    // The front of a jet slows down as the jet does: the time to here is the integral of way/speed.
    const reach = CORE * MOUTH;
    const delay =
      (Math.min(way, reach) + Math.max(0, way * way - reach * reach) / (2 * reach)) /
      Math.max(speed, 1e-3);
    const elapsed = age - delay;
    if (elapsed <= 0 || elapsed >= BREATH) return;
    const swell = Math.min(1, elapsed / SWELL, (BREATH - elapsed) / SWELL);
    const aside = dx * dx + dy * dy + dz * dz - way * way;
    const width = MOUTH / 2 + SPREAD * way;
    puff.felt = speed * swell * Math.min(1, reach / way) * Math.exp(-aside / (width * width));
  }
}
