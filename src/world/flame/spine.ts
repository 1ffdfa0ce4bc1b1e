import type { Air } from "../air/air.js";
import type { Vec3 } from "../geometry.js";
import { BUOYANCY, flameSpeed, plumeSpeed, topSpeed } from "./burning.js";

/** Parcels of gas along the flame. */
export const PARCELS = 24;
/**
 * Speed at which air is drawn in through the sides, m/s: a taper's gas takes up the air's sideways speed
 * in 12 ms, that of a flame twice as wide in twice the time.
 */
const ENTRAINMENT = 0.002 / 0.012;
/** Height up to which the wick shelters the gas, m, and share of the wind at the foot. */
const CLINGING = 0.004;
const LEAST_FELT = 0.5;
/** √z grows at this rate where the gas rises freely, √m/s. */
const CLIMB = Math.sqrt(BUOYANCY / 2);

/** Initial state of a flame's gas. */
export interface GasSource {
  /** Of fuel, kg/s. */
  rate: number;
  /** Of the wick, metres. */
  width: number;
  /** Seconds between two parcels. */
  spacing: number;
}

/**
 * The middle of the flame as a streakline: parcels of gas that left the wick one after another.
 *
 * Each rises by a measured law and is advected by the air. So the flame lags when it is carried, leans in a wind,
 * and straightens within the time that gas takes from base to tip, without a spring to tune.
 */
export class Spine {
  /** x, y, z of each parcel from the foot of the flame, the youngest first, metres. */
  readonly positions = new Float64Array(PARCELS * 3);
  /** x and z of each parcel's velocity in the room, m/s. */
  readonly #drift = new Float64Array(PARCELS * 2);
  /** Age of the youngest, seconds. */
  #youngest = 0;
  readonly #aside: Readonly<Vec3>;
  readonly #place: Vec3 = [0, 0, 0];
  readonly #flow: Vec3 = [0, 0, 0];
  /** Rate at which the gas takes up the air's speed, 1/s. */
  #mixing = 0;
  /** Fastest that gas rises now, m/s, in the flame and 1 m over it; for how long a parcel is carried, seconds. */
  #flameSpeed = 0;
  #plumeSpeed = 0;
  #seconds = 0;

  /**
   * Upright and at rest, as in still air.
   *
   * @param aside from the flame to where its eddies are those of the air, metres
   */
  constructor({ rate, spacing }: Readonly<GasSource>, aside: Readonly<Vec3>) {
    this.#aside = aside;
    for (let i = 0; i < PARCELS; i++) {
      let left = i * spacing;
      const at = i * 3 + 1;
      while (left > 1e-9) {
        const step = Math.min(left, 0.002);
        this.positions[at] = heightAfter(this.positions[at] ?? 0, step, rate);
        left -= step;
      }
    }
  }

  /**
   * Advances by one tick.
   *
   * @param foot of the flame, metres, at the end of the tick
   * @param motion of the foot, m/s
   * @param air that carries the gas; null holds it still
   */
  advance(
    foot: Readonly<Vec3>,
    motion: Readonly<Vec3>,
    feed: Readonly<GasSource>,
    air: Air | null,
    seconds: number,
  ): void {
    const { rate, width, spacing } = feed;
    this.#mixing = ENTRAINMENT / width;
    this.#flameSpeed = flameSpeed(rate);
    this.#plumeSpeed = plumeSpeed(rate);
    this.#seconds = seconds;
    for (let i = 0; i < PARCELS; i++) this.#carry(i, foot, motion, air);
    const age = this.#youngest + seconds;
    const born = Math.min(Math.floor(age / spacing + 1e-9), PARCELS);
    this.#youngest = Math.max(0, age - Math.floor(age / spacing + 1e-9) * spacing);
    if (born === 0) return;
    this.positions.copyWithin(born * 3, 0, (PARCELS - born) * 3);
    this.#drift.copyWithin(born * 2, 0, (PARCELS - born) * 2);
    for (let i = 0; i < born; i++) {
      this.positions.fill(0, i * 3, i * 3 + 3);
      this.#drift[i * 2] = air ? motion[0] : 0;
      this.#drift[i * 2 + 1] = air ? motion[2] : 0;
      this.#seconds = this.#youngest + i * spacing;
      this.#carry(i, foot, motion, air);
    }
  }

  #carry(i: number, foot: Readonly<Vec3>, motion: Readonly<Vec3>, air: Air | null): void {
    const { positions } = this;
    const seconds = this.#seconds;
    const at = i * 3;
    const height = positions[at + 1] ?? 0;
    if (!air) {
      positions[at] = positions[at + 2] = 0;
      this.#rise(at + 1, AT_REST);
      return;
    }
    const x = positions[at] ?? 0;
    const z = positions[at + 2] ?? 0;
    const place = this.#place;
    place[0] = foot[0] + x;
    place[1] = foot[1] + height;
    place[2] = foot[2] + z;
    const flow = air.velocity(place, this.#flow, this.#aside);
    const windFactor = LEAST_FELT + (1 - LEAST_FELT) * Math.min(height / CLINGING, 1);
    for (let axis = 0; axis < 3; axis++) {
      const carried = motion[axis]!;
      flow[axis] = carried + (flow[axis]! - carried) * windFactor;
    }
    flow[1] -= motion[1];
    this.#rise(at + 1, flow);
    const left = Math.exp(-this.#mixing * seconds);
    const lagging = (1 - left) / this.#mixing;
    const behindX = (this.#drift[i * 2] ?? 0) - flow[0];
    const behindZ = (this.#drift[i * 2 + 1] ?? 0) - flow[2];
    positions[at] = x + (flow[0] - motion[0]) * seconds + behindX * lagging;
    positions[at + 2] = z + (flow[2] - motion[2]) * seconds + behindZ * lagging;
    this.#drift[i * 2] = flow[0] + behindX * left;
    this.#drift[i * 2 + 1] = flow[2] + behindZ * left;
  }

  /** Lets the gas at a height rise, as in `heightAfter`, with an updraught. */
  #rise(at: number, updraught: Readonly<Vec3>): void {
    const seconds = this.#seconds;
    const height = this.positions[at] ?? 0;
    const root = Math.sqrt(height) + CLIMB * seconds;
    const fastest = Math.min(
      this.#flameSpeed,
      this.#plumeSpeed / Math.cbrt(Math.max(height, 1e-3)),
    );
    const risenHeight = Math.min(root * root, height + fastest * seconds);
    this.positions[at] = Math.max(0, risenHeight + updraught[1] * seconds);
  }
}

const AT_REST: Vec3 = [0, 0, 0];

/** Where gas at a height is after a while, metres. Exact where it rises freely. */
export function heightAfter(height: number, seconds: number, rate: number): number {
  const freeHeight = (Math.sqrt(height) + CLIMB * seconds) ** 2;
  return Math.min(freeHeight, height + topSpeed(rate, height) * seconds);
}

/** How long gas takes to rise to a height, seconds. */
export function timeToRise(height: number, rate: number): number {
  const STEP = 0.0005;
  let seconds = 0;
  for (let z = 0; z < height && seconds < 5; z = heightAfter(z, STEP, rate)) seconds += STEP;
  return seconds;
}
