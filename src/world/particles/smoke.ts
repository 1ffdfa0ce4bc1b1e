import { PLUME_STEP, type PlumeSolver } from "../air/plume-solver.js";
import { length3, type Vec3 } from "../geometry.js";
import { pcg, signed } from "../random.js";

/** Streaklines, born around the rim of the wick's end. */
export const LINES = 12;
/** Parcels along each, one for every step of the air: as long as smoke is visible. */
export const ROWS = 256;
/** Floats per parcel: position (m), extinction's cross-section per metre of its line (m), breadth (m). */
export const SMOKE_FLOATS = 8;

/** Radius of the rim, metres. */
const RIM = 0.0011;
/** Breadth (standard deviation) of a line at birth, metres, and how it spreads: m²/s. */
const BREADTH = 0.0005;
const SPREADING = 1.1e-6;
/**
 * Of a breath, a turbulent jet: growth of the breadth per metre of way, and the speed from which it counts, m/s. What a
 * round jet carries is wide as 0.127 of its way at 1/e (Fischer et al. 1979, "Mixing in Inland and Coastal Waters"); the
 * speed is fitted: neither a plume nor a visitor is as fast.
 */
const JET_SPREADING = 0.127 / Math.SQRT2;
const JET_SPEED = 2.5;
/** Time in which eddies that it leaves at the wick decay by a factor e, seconds: about their size over their speed. */
const TURBULENCE_DECAY = 0.1;
/** Extinction's cross-section of all smoke of a step at full strength, m². */
const THICKNESS = 7e-6;
/** Seconds over which an old parcel dissolves. */
const DISSOLVING = 2.2;
/** Frequency, Hz, and amplitude of the variations of the smoke's strength. */
const GRAIN_RATE = 14;
const GRAIN = 0.45;

/**
 * White smoke: wax vapour of a hot wick whose flame is out.
 *
 * Parcels that left the rim of the wick one after another make streaklines, which the air carries and stretches;
 * where it pulls neighbours apart the smoke thins. After von Funck, Weinkauf, Theisel and Seidel 2008, "Smoke
 * Surfaces: An Interactive Flow Visualization Technique Inspired by Real-World Flow Experiments".
 */
export class Smoke {
  /** One row after the other, `LINES` parcels in each; the youngest row is `newest`. */
  readonly parcels = new Float32Array(LINES * ROWS * SMOKE_FLOATS);
  newest = 0;
  count = 0;
  /** Strength of the smoke, as a share of the most that a wick gives off, and whether it gives off any. */
  strength = 0;
  isFed = false;
  readonly #velocities = new Float32Array(LINES * ROWS * 3);
  readonly #amounts = new Float32Array(LINES * ROWS);
  /** Breadth that a breath has given each parcel, metres. */
  readonly #jetBreadth = new Float32Array(LINES * ROWS);
  readonly #key: number;
  /** Of a breath at the wick, or what is left of it: its speed above `JET_SPEED`, m/s. */
  #turbulence = 0;
  #step = 0;
  readonly #place: Vec3 = [0, 0, 0];
  readonly #flow: Vec3 = [0, 0, 0];

  constructor(seed: number) {
    this.#key = pcg(seed ^ 0x5306e);
  }

  /** Takes over the state of another, of the same seed. */
  copy(other: Smoke): void {
    this.parcels.set(other.parcels);
    this.#velocities.set(other.#velocities);
    this.#amounts.set(other.#amounts);
    this.#jetBreadth.set(other.#jetBreadth);
    this.#turbulence = other.#turbulence;
    this.#step = other.#step;
    this.newest = other.newest;
    this.count = other.count;
    this.strength = other.strength;
    this.isFed = other.isFed;
  }

  /**
   * One `PLUME_STEP`.
   *
   * @param wick its end, metres
   */
  step(air: PlumeSolver, wick: Readonly<Vec3>): void {
    this.#step++;
    if (this.count === 0 && !this.isFed) return;
    this.#followTurbulence(air, wick);
    this.#advect(air);
    this.#emit(air, wick);
    this.#dilute();
  }

  #followTurbulence(air: PlumeSolver, wick: Readonly<Vec3>): void {
    const flow = air.velocity(wick, this.#flow);
    const speed = length3(flow[0], flow[1], flow[2]) - JET_SPEED;
    this.#turbulence = Math.max(speed, this.#turbulence * Math.exp(-PLUME_STEP / TURBULENCE_DECAY));
  }

  #advect(air: PlumeSolver): void {
    const { parcels } = this;
    const place = this.#place;
    const flow = this.#flow;
    const velocities = this.#velocities;
    for (let n = 0; n < this.count; n++) {
      const first = ((this.newest - n + ROWS) % ROWS) * LINES;
      for (let at = first; at < first + LINES; at++) {
        const p = at * SMOKE_FLOATS;
        const v = at * 3;
        for (let axis = 0; axis < 3; axis++) place[axis] = parcels[p + axis]!;
        air.velocity(place, flow);
        // Adams and Bashforth 1883: second order with one sample of the air.
        for (let axis = 0; axis < 3; axis++) {
          const before = velocities[v + axis]!;
          parcels[p + axis]! += PLUME_STEP * (1.5 * flow[axis]! - 0.5 * before);
          velocities[v + axis] = flow[axis]!;
        }
        const speed = length3(flow[0], flow[1], flow[2]);
        this.#jetBreadth[at]! += JET_SPREADING * PLUME_STEP * Math.max(speed - JET_SPEED, 0);
      }
    }
  }

  #emit(air: PlumeSolver, wick: Readonly<Vec3>): void {
    const { parcels } = this;
    // Vapour that is diluted before it condenses becomes finer droplets, which scatter less: fitted by eye.
    const share = 1 / (1 + this.#turbulence * this.#turbulence);
    const strength = this.isFed ? this.strength * share : 0;
    this.newest = (this.newest + 1) % ROWS;
    this.count = Math.min(this.count + 1, ROWS);
    const place = this.#place;
    const flow = this.#flow;
    for (let n = 0; n < LINES; n++) {
      const at = this.newest * LINES + n;
      const p = at * SMOKE_FLOATS;
      const angle = (2 * Math.PI * n) / LINES;
      place[0] = wick[0] + RIM * Math.cos(angle);
      place[1] = wick[1];
      place[2] = wick[2] + RIM * Math.sin(angle);
      air.velocity(place, flow);
      for (let axis = 0; axis < 3; axis++) {
        parcels[p + axis] = place[axis]!;
        this.#velocities[at * 3 + axis] = flow[axis]!;
      }
      const grain = 1 + GRAIN * this.#grain(n);
      this.#jetBreadth[at] = 0;
      this.#amounts[at] = (strength * grain * THICKNESS) / LINES;
    }
    // Rows that have dissolved are dropped from the old end.
    while (this.count > 0 && this.#isClear(this.newest - this.count + 1)) this.count--;
  }

  #isClear(row: number): boolean {
    const first = ((row + ROWS) % ROWS) * LINES;
    for (let at = first; at < first + LINES; at++) if (this.#amounts[at]! > 0) return false;
    return true;
  }

  /** -1 to 1, smooth in time, another one for each line. */
  #grain(lineIndex: number): number {
    const time = this.#step * PLUME_STEP * GRAIN_RATE;
    const beat = Math.floor(time);
    const t = time - beat;
    const key = pcg(this.#key + (lineIndex >> 1));
    const here = signed(pcg((key + beat) >>> 0));
    const next = signed(pcg((key + beat + 1) >>> 0));
    return here + (next - here) * t * t * (3 - 2 * t);
  }

  /** Updates extinction and breadth of each line. */
  #dilute(): void {
    const { parcels } = this;
    for (let n = 0; n < this.count; n++) {
      const row = (this.newest - n + ROWS) % ROWS;
      const younger = n === 0 ? row : (row + 1) % ROWS;
      const older = n === this.count - 1 ? row : (row + ROWS - 1) % ROWS;
      const seconds = n * PLUME_STEP;
      const life = ROWS * PLUME_STEP;
      const remainder = Math.min((life - seconds) / DISSOLVING, 1);
      const fades = remainder * remainder * (3 - 2 * remainder);
      const steps = (n === 0 ? 0 : 1) + (n === this.count - 1 ? 0 : 1);
      for (let i = 0; i < LINES; i++) {
        const at = row * LINES + i;
        const p = at * SMOKE_FLOATS;
        const a = (younger * LINES + i) * SMOKE_FLOATS;
        const b = (older * LINES + i) * SMOKE_FLOATS;
        const length = Math.max(apart(parcels, a, b) / Math.max(steps, 1), 1e-4);
        const before = (row * LINES + ((i + LINES - 1) % LINES)) * SMOKE_FLOATS;
        const after = (row * LINES + ((i + 1) % LINES)) * SMOKE_FLOATS;
        const gap = 0.5 * (apart(parcels, p, before) + apart(parcels, p, after));
        parcels[p + 3] = (this.#amounts[at]! * fades) / length;
        const jet = this.#jetBreadth[at]!;
        parcels[p + 4] = Math.sqrt(
          BREADTH * BREADTH + 2 * SPREADING * seconds + 0.12 * gap * gap + jet * jet,
        );
      }
    }
  }
}

function apart(parcels: Float32Array, a: number, b: number): number {
  return length3(
    parcels[a]! - parcels[b]!,
    parcels[a + 1]! - parcels[b + 1]!,
    parcels[a + 2]! - parcels[b + 2]!,
  );
}
