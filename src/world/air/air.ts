import { length2, type Vec3 } from "../geometry.js";
import { TICK } from "../timeline.js";
import { Breath } from "./breath.js";
import { Gusts } from "./gusts.js";

/** The draught in the room. */
export interface Wind {
  /** Mean, m/s. */
  readonly speed: number;
  /** Where it blows to, radians: 0 is -Z, counter-clockwise from above. */
  readonly direction: number;
  /** 0 steady to 1 squally. */
  readonly gustiness: number;
}

const NO_MOTION: Vec3 = [0, 0, 0];
export const CALM: Wind = { speed: 0, direction: 0, gustiness: 0 };

/** Turbulence of a squally wind, as a share of its mean along each axis. */
const TURBULENCE = 0.6;
/** Rate at which the wind nears a new one, 1/s. */
const VEERING = 3;

/** Half-width of the visitor's body, which displaces the air. Metres. */
const GIRTH = 0.22;
/** Feet and crown of the body, below and above the eye. Metres. */
const BELOW_EYE = 1.6;
const ABOVE_EYE = 0.15;

/** Share of a carried candle's velocity that the air around it has: the other hand shelters it. */
const SHELTER = 0.4;
/** How far around the flame, metres. */
const SHELTERED = 0.12;

/**
 * Air of the room: a draught with gusts, the wake of the walking visitor, and a breath.
 *
 * Velocities are those of the current tick.
 */
export class Air {
  #wind = CALM;
  /** Target mean velocity and turbulence, m/s. Of one shape, or V8 would box the numbers. */
  readonly #target = { x: Number.NaN, z: Number.NaN, turbulence: Number.NaN };
  readonly #gusts: Gusts;
  readonly #mean: Vec3 = [0, 0, 0];
  #turbulence = 0;
  /** Ticks, and seconds, since the beginning. */
  #tick = 0;
  #time = 0;
  /** The visitor's eye, metres, and velocity, m/s. */
  readonly #body: Vec3 = [0, 0, 0];
  readonly #pace: Vec3 = [0, 0, 0];
  /** The flame that is carried, and the velocity that the air around it shares. */
  readonly #carried: Vec3 = [0, 0, 0];
  readonly #shelter: Vec3 = [0, 0, 0];
  readonly #gusty: Vec3 = [0, 0, 0];
  /** The visitor's, then one for each candle that is blown at by itself. */
  readonly #breaths = [new Breath()];

  constructor(seed: number, wind: Wind) {
    this.#gusts = new Gusts(seed);
    this.wind = wind;
    this.#veer(Number.POSITIVE_INFINITY);
  }

  /** Target wind; the air approaches it within a second. */
  get wind(): Wind {
    return this.#wind;
  }

  set wind(wind: Wind) {
    const { speed, direction, gustiness } = wind;
    this.#wind = wind;
    this.#target.x = -speed * Math.sin(direction);
    this.#target.z = -speed * Math.cos(direction);
    this.#target.turbulence = speed * gustiness * TURBULENCE;
  }

  /**
   * Advances by one tick.
   *
   * @param tick number of ticks since the beginning
   * @param eye the visitor's, metres
   * @param pace velocity of the visitor, m/s
   * @param flame foot of the flame, metres
   * @param carrying velocity of the flame that is carried, m/s
   */
  advance(
    tick: number,
    eye: Readonly<Vec3>,
    pace: Readonly<Vec3>,
    flame: Readonly<Vec3>,
    carrying: Readonly<Vec3>,
  ): void {
    const previous = this.#tick;
    this.#tick = tick;
    this.#time = tick * TICK;
    this.#veer(tick - previous);
    for (let i = 0; i < this.#breaths.length; i++) this.#breaths[i]!.time = this.#time;
    for (let axis = 0; axis < 3; axis++) {
      this.#body[axis] = eye[axis]!;
      this.#pace[axis] = pace[axis]!;
      this.#carried[axis] = flame[axis]!;
      this.#shelter[axis] = carrying[axis]! * SHELTER;
    }
  }

  #veer(ticks: number): void {
    const blend = 1 - Math.exp(-VEERING * TICK * Math.max(0, ticks));
    const { x, z, turbulence } = this.#target;
    this.#mean[0] += (x - this.#mean[0]) * blend;
    this.#mean[2] += (z - this.#mean[2]) * blend;
    this.#turbulence += (turbulence - this.#turbulence) * blend;
  }

  /**
   * A breath along a direction of length 1, from now on. `strength` 1 blows out a candle at arm's length.
   *
   * @param distance of the target from the eye, metres
   * @param mouth 0 is the visitor's
   * @param reach beyond which nothing is felt, metres
   */
  blow(
    eye: Readonly<Vec3>,
    towards: Readonly<Vec3>,
    distance: number,
    strength: number,
    mouth = 0,
    reach = Infinity,
  ): void {
    const breaths = this.#breaths;
    while (breaths.length <= mouth) breaths.push(new Breath());
    const breath = breaths[mouth]!;
    breath.time = this.#time;
    breath.begin(eye, towards, distance, strength, reach);
  }

  /**
   * Velocity of the air at a place, m/s, written to `out`.
   *
   * @param aside from the place to the one whose gusts it has, metres
   */
  velocity(place: Readonly<Vec3>, out: Vec3, aside: Readonly<Vec3> = NO_MOTION): Vec3 {
    out[0] = this.#mean[0];
    out[1] = this.#mean[1];
    out[2] = this.#mean[2];
    if (this.#turbulence > 0) {
      this.#gusts.strength = this.#turbulence;
      this.#gusts.time = this.#time;
      const gusty = this.#gusty;
      gusty[0] = place[0] + aside[0];
      gusty[1] = place[1] + aside[1];
      gusty[2] = place[2] + aside[2];
      this.#gusts.add(gusty, out);
    }
    this.#addWake(place, out);
    this.#addShelter(place, out);
    const breaths = this.#breaths;
    for (let i = 0; i < breaths.length; i++) breaths[i]!.add(place, out);
    return out;
  }

  /** Around a walking cylinder the air flows as a doublet, which has no divergence (Lamb 1932, 68). */
  #addWake(place: Readonly<Vec3>, out: Vec3): void {
    const speed = length2(this.#pace[0], this.#pace[2]);
    const height = place[1] - this.#body[1];
    if (speed < 1e-6 || height < -BELOW_EYE || height > ABOVE_EYE) return;
    const dx = place[0] - this.#body[0];
    const dz = place[2] - this.#body[2];
    const squared = dx * dx + dz * dz;
    const weight = Math.min(1, (GIRTH * GIRTH) / Math.max(squared, 1e-9));
    const along = weight < 1 ? (2 * (dx * this.#pace[0] + dz * this.#pace[2])) / squared : 0;
    const back = weight < 1 ? -1 : 1;
    out[0] += weight * (along * dx + back * this.#pace[0]);
    out[2] += weight * (along * dz + back * this.#pace[2]);
  }

  #addShelter(place: Readonly<Vec3>, out: Vec3): void {
    const dx = place[0] - this.#carried[0];
    const dy = place[1] - this.#carried[1];
    const dz = place[2] - this.#carried[2];
    const weight = Math.exp(-(dx * dx + dy * dy + dz * dz) / (SHELTERED * SHELTERED));
    for (let axis = 0; axis < 3; axis++) out[axis]! += weight * this.#shelter[axis]!;
  }
}
