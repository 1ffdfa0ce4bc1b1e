import type { Air } from "../air/air.js";
import { length3, type Vec3 } from "../geometry.js";
import { pcg, signed } from "../random.js";
import {
  type Combustion,
  flameHeight,
  flameRadius,
  fuelRate,
  riseTime,
  updateLight,
} from "./burning.js";
import { Limiter } from "./limiter.js";
import { Puffing, puffingFrequency } from "./puffing.js";
import { type GasSource, PARCELS, Spine, timeToRise } from "./spine.js";

/** Time in which a small flame grows by a factor e, as its heat evaporates more wax. Seconds. */
const GROWTH = 0.15;
/** Share of its fuel that a flame begins with. */
const SPARK = 0.03;
/** Time in which enough vapour gathers to be lit. Seconds. */
const GATHERING = 0.4;
/** Share of fuel below which the flame goes out. */
const LEAST = 0.035;
/**
 * Extinction strain, 1/s: with more, air passes the flame faster than it burns. Of hydrocarbons in air it is 300 to
 * 500 (Tsuji 1982, "Counterflow Diffusion Flames").
 */
const EXTINCTION_STRAIN = 330;
/** Share of it that puts out a remnant in the lee of the wick. */
const REMNANT_STRENGTH = 0.7;
/** Rate of dying beyond the limit, 1/s for each multiple of the limit. */
const DYING = 14;
/** Share of the limit below which strain has no effect. */
const UNNOTICED = 0.04;
/** Fuel lost at the limit, and what shortens and narrows it there besides. */
const COOLING = 0.5;
const SHORTENING = 1;
const NARROWING = 0.5;
/** Time constant of the flame's response to the air. Seconds. */
const INERTIA = 0.012;
/** Height at which the strain is sampled, as a share of the flame's. */
const STRAINED_AT = 0.25;

/** The wick's tip in the flame, and the room, kelvin. */
export const GLOWING = 1120;
export const ROOM = 293;
/** Time constants of the tip's heating and cooling, seconds: dark (798 K, Draper) after five seconds. */
const HEATING = 0.3;
const FADING = 10;
/** Invisible remainder of light, as a share of a taper's. */
const UNSEEN = 2e-3;
/**
 * Least share of fuel that a flame looks like, for the root of its light: a breath takes fuel faster than light may fade, and
 * what shines is no smaller than its light. Fitted: without effect on a flame that flickers.
 */
const LINGERING = 0.8;
/** Change of the tip's radius for each share of the volume, as the flame puffs; less below. */
const NECKING = 1.5;
const NARROWEST = 0.4;
/** Temperature below which no wax evaporates, kelvin. */
const DRY = 550;
/** Share of the fuel that still evaporates just after the flame has gone out. */
const AFTERGLOW = 0.3;

/** Largest offset at which a flame with a seed samples the gusts, along each axis, metres. */
const ASIDE = 0.25;

/** Measures of a flame, which follow from its state. */
export interface FlameMeasures extends Combustion {
  /** Share of fuel that sets its size: after it went out, it shrinks onto its wick. */
  extent: number;
  /** Unburnt wax that leaves the wick, as a share of that just after the flame went out. */
  smoking: number;
}

/** The flame on its wick, at the current tick. Lengths in metres, from the foot of the flame. */
export class Flame {
  isLit: boolean;
  // Initialised, since V8 boxes the numbers of fields that were once undefined.
  /** Fuel that burns, as a share of what the wick gives in still air. */
  fuel = 0;
  /** Strain by the air that passes, as a share of what puts the flame out. */
  strain = 0;
  /** Tip of the wick, kelvin. */
  ember = 0;
  /** Light of its soot as a share of a taper's in still air, as fast as it may change. */
  glow = 0;
  readonly spine: Spine;
  /** Its neck, which swings by itself over a wide wick. */
  readonly puffing = new Puffing();
  readonly #limiter = new Limiter();
  /** Without lean, flicker and puffing. */
  #isStill = false;
  /** Of the flame that went out: its share of fuel, its light, and the time since. Seconds. */
  #remains = 0;
  #lastGlow = 1;
  #outFor = Number.POSITIVE_INFINITY;
  /** Of the wick: its diameter, metres, what it burns in still air, kg/s, and the light of that. */
  #wick = 0;
  #full = 0;
  #fullLight = 0;
  /** Widest that it burns, metres. */
  #width = 0;
  readonly #feed: GasSource = { rate: Number.NaN, width: Number.NaN, spacing: Number.NaN };
  readonly #gauge: FlameMeasures = {
    rate: Number.NaN,
    height: Number.NaN,
    effectiveStrain: Number.NaN,
    light: Number.NaN,
    extent: Number.NaN,
    smoking: Number.NaN,
  };
  /** Offset at which it samples the gusts, metres: flames side by side differ. */
  readonly #aside: Vec3 = [0, 0, 0];
  readonly #airspeed: Vec3 = [0, 0, 0];
  readonly #place: Vec3 = [0, 0, 0];
  readonly #flow: Vec3 = [0, 0, 0];

  /** @param seed of its own; null for the carried candle's, which is in the air as it is */
  constructor(wick: number, isLit: boolean, seed: number | null = null) {
    if (seed !== null) {
      for (const axis of [0, 1, 2] as const) this.#aside[axis] = ASIDE * signed(pcg(seed + axis));
      this.puffing.begin(Math.PI * signed(pcg(seed + 3)));
    }
    this.wick = wick;
    this.isLit = isLit;
    this.fuel = isLit ? 1 : 0;
    this.#remains = this.fuel;
    this.ember = isLit ? GLOWING : ROOM;
    this.#limiter.settle(this.measure().light);
    this.glow = this.#limiter.light;
    this.#feed.rate = this.#full;
    this.spine = new Spine(this.#feed, this.#aside);
  }

  get wick(): number {
    return this.#wick;
  }

  set wick(wick: number) {
    if (wick === this.#wick) return;
    this.#wick = wick;
    this.#full = fuelRate(wick);
    const still: Combustion = {
      rate: this.#full,
      height: flameHeight(this.#full),
      effectiveStrain: 0,
      light: 0,
    };
    updateLight(still);
    this.#fullLight = still.light;
    this.#width = 2 * flameRadius(wick, 1);
    this.#feed.width = wick;
    // Parcels reach half as far again as the flame does in still air.
    this.#feed.spacing = timeToRise(1.5 * flameHeight(this.#full), this.#full) / (PARCELS - 1);
  }

  /** Rate of burning, kg/s. */
  get rate(): number {
    return this.measure().rate;
  }

  /** Its volume as a share of its mean, as it puffs; exactly 1 of a candle. */
  get pulse(): number {
    return this.#isStill ? 1 : this.puffing.pulse;
  }

  /** Luminous length along the spine, metres; of what still glows after it went out, too. */
  get height(): number {
    return this.measure().height;
  }

  /** Largest luminous radius, metres. */
  get radius(): number {
    const { extent, effectiveStrain } = this.measure();
    return flameRadius(this.#wick, extent) / (1 + NARROWING * effectiveStrain);
  }

  /** Factor on the radius at a height, m, as necks and bulges travel up with the gas. */
  neck(height: number): number {
    const { real, imaginary } = this.puffing;
    if (this.#isStill || (real === 0 && imaginary === 0) || !(this.height > 0)) return 1;
    const riseDuration = riseTime(this.#full, height);
    const angle = 2 * Math.PI * puffingFrequency(this.wick) * riseDuration;
    const wave = real * Math.cos(angle) + imaginary * Math.sin(angle);
    return Math.max(1 + NECKING * wave * Math.min(height / this.height, 1), NARROWEST);
  }

  /** Returns the same object each time, since V8 boxes numbers that are returned. */
  measure(): Readonly<FlameMeasures> {
    const gauge = this.#gauge;
    const volume = this.pulse * this.#full;
    gauge.effectiveStrain = this.#isStill ? 0 : Math.max(0, Math.min(this.strain, 1.5) - UNNOTICED);
    const lingering = LINGERING * Math.sqrt(this.relativeLight);
    gauge.extent = this.isLit
      ? Math.max(this.fuel, lingering)
      : this.#remains * Math.sqrt(this.presence);
    gauge.rate = this.fuel * volume;
    gauge.height = flameHeight(gauge.extent * volume) / (1 + SHORTENING * gauge.effectiveStrain);
    updateLight(gauge);
    const warmth = this.isLit ? 0 : Math.max(0, (this.ember - DRY) / (GLOWING - DRY));
    gauge.smoking = warmth * Math.sqrt(warmth);
    return gauge;
  }

  /** Wax that leaves the wick unburnt, kg/s: it condenses to smoke. */
  get vapour(): number {
    return AFTERGLOW * this.#full * this.measure().smoking;
  }

  /** Strain above `UNNOTICED`, as a share of what puts it out. */
  get effectiveStrain(): number {
    return this.measure().effectiveStrain;
  }

  /** Light as a share of what this wick gives in still air. */
  get relativeLight(): number {
    return this.glow / this.#fullLight;
  }

  /** 1 while it burns; once it is out, the share of its last light that is left. */
  get presence(): number {
    return this.isLit ? 1 : this.glow / this.#lastGlow;
  }

  /** False if it burns already. */
  light(): boolean {
    if (this.isLit) return false;
    // Toggled quickly, it restarts from a spark, and cannot flash.
    const buildUp = Math.min(this.#outFor / GATHERING, 1) ** 3;
    this.fuel = Math.max(SPARK, (buildUp * this.vapour) / this.#full);
    this.isLit = true;
    this.strain = 0;
    this.#airspeed.fill(0); // the gust that put it out is long over
    return true;
  }

  /** False if it is out already. */
  extinguish(): boolean {
    if (!this.isLit) return false;
    this.#remains = this.measure().extent;
    this.isLit = false;
    this.#lastGlow = Math.max(this.glow, UNSEEN);
    this.#outFor = 0;
    this.fuel = 0;
    return true;
  }

  /**
   * Advances by one tick.
   *
   * @param foot of the flame, metres, at the end of the tick
   * @param motion of the foot, m/s
   * @param isStill whether it is to stay upright and even
   */
  advance(
    foot: Readonly<Vec3>,
    motion: Readonly<Vec3>,
    air: Air,
    isStill: boolean,
    seconds: number,
  ): void {
    this.#isStill = isStill;
    if (isStill) this.puffing.begin();
    else this.puffing.advance(this.#feed, seconds);
    const target = this.isLit ? GLOWING : ROOM;
    const pace = this.isLit ? HEATING : FADING;
    this.ember = target + (this.ember - target) * Math.exp(-seconds / pace);
    this.#feed.rate = Math.max(this.measure().rate, 0.1 * this.#full);
    this.spine.advance(foot, motion, this.#feed, isStill ? null : air, seconds);
    if (this.isLit) {
      this.#strain(foot, motion, air, seconds);
      this.#burn(seconds);
    } else {
      this.#outFor += seconds;
    }
    this.#limiter.target = this.measure().light;
    this.#limiter.advance(seconds);
    this.glow = this.#limiter.light > UNSEEN ? this.#limiter.light : 0;
  }

  #strain(foot: Readonly<Vec3>, motion: Readonly<Vec3>, air: Air, seconds: number): void {
    const flow = this.#flow;
    const place = this.#place;
    place[0] = foot[0];
    place[1] = foot[1] + STRAINED_AT * this.measure().height;
    place[2] = foot[2];
    air.velocity(place, flow, this.#aside);
    const blend = 1 - Math.exp(-seconds / INERTIA);
    const airspeed = this.#airspeed;
    for (let axis = 0; axis < 3; axis++) {
      airspeed[axis]! += (flow[axis]! - motion[axis]! - airspeed[axis]!) * blend;
    }
    const speed = length3(airspeed[0], airspeed[1], airspeed[2]);
    this.strain = speed / (this.#width * EXTINCTION_STRAIN);
  }

  #burn(seconds: number): void {
    const target = 1 - COOLING * Math.min(this.measure().effectiveStrain, 1);
    const strength = REMNANT_STRENGTH + (1 - REMNANT_STRENGTH) * Math.min(this.fuel, 1);
    const excess = Math.max(0, this.strain / strength - 1);
    const mending = Math.max(0, 1 - this.strain / strength);
    const lack = (target - this.fuel) / GROWTH;
    const growth = (lack > 0 ? lack * mending : lack) - DYING * excess;
    this.fuel *= Math.exp(growth * seconds);
    if (this.fuel < LEAST && excess > 0) this.extinguish();
  }
}
