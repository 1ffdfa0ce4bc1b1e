import { HEAT } from "../flame/burning.js";
import { type Flame, type FlameMeasures, GLOWING, ROOM } from "../flame/flame.js";
import type { Vec3 } from "../geometry.js";
import { Smoke } from "../particles/smoke.js";
import type { Air } from "./air.js";
import { coarsePlumeGrid, type PlumeGrid } from "./plume-grid.js";
import { type Heater, PLUME_STEP, PlumeSolver } from "./plume-solver.js";

/** Share of a flame's heat that rises with its gas; the rest shines, and melts the wax. */
const CONVECTED = 0.72;
/** Height over which it is released, as a share of the flame's. */
const BURNING = 0.8;
/** Heat of the ember just after its flame is out, W, and its height, m. */
const EMBER_POWER = 2.4;
const EMBER_HEIGHT = 0.012;
/** Height over the foot of the flame at which smoke begins in its air, metres: between the ends of all wicks. */
export const WICK_END = 0.004;
/** A candle that moves farther in a step has jumped, into air at rest. Metres. */
const JUMP = 0.3;
/** Time until the glowing wick smokes at full strength, seconds. */
const KINDLING = 0.12;
/** Time in which a flame that is lit anew comes to burn all of its vapour, seconds. */
const BURNING_OFF = 0.05;
/** Share of the full smoke that is not seen. */
const LEAST_STRENGTH = 0.01;

/** Plume of a flame: hot gas that rises, and smoke when it is out. */
export class Plume {
  readonly solver: PlumeSolver;
  readonly smoke: Smoke;
  readonly #seed: number;
  readonly #heater: Heater = { power: Number.NaN, height: Number.NaN };
  readonly #wind: Vec3 = [0, 0, 0];
  readonly #wick: Vec3 = [0, 0, 0];

  /** @param grid of its air; default: the carried candle's */
  constructor(seed: number, foot: Readonly<Vec3>, grid?: PlumeGrid) {
    this.#seed = seed;
    this.solver = new PlumeSolver(grid);
    this.smoke = new Smoke(seed);
    this.solver.reset(foot, this.#wind);
  }

  /** Another in the same state. */
  clone(): Plume {
    const { solver, smoke } = this;
    const other = new Plume(this.#seed, solver.origin, solver.grid);
    other.solver.copy(solver);
    other.smoke.copy(smoke);
    return other;
  }

  /**
   * Advances by one `PLUME_STEP`.
   *
   * @param foot of the flame, metres
   * @param air around, or null where it is to stay at rest
   */
  step(flame: Flame, foot: Readonly<Vec3>, air: Air | null): void {
    const { origin } = this.solver;
    const wind = this.#wind;
    const { smoke } = this;
    const gauge = flame.measure();
    if (!flame.isLit && gauge.smoking === 0 && smoke.count === 0) {
      origin[1] = Number.NEGATIVE_INFINITY; // all is cold: the next flame begins in air at rest
      return;
    }
    if (air) air.velocity(foot, wind);
    else wind.fill(0);
    const x = foot[0] - origin[0];
    const y = foot[1] - origin[1];
    const z = foot[2] - origin[2];
    if (x * x + y * y + z * z > JUMP * JUMP) this.solver.reset(foot, wind);
    const wick = this.#wick;
    wick[0] = foot[0];
    wick[1] = foot[1] + WICK_END;
    wick[2] = foot[2];
    this.#updateHeater(flame, gauge);
    this.solver.step(foot, wind, this.#heater);
    smoke.step(this.solver, wick);
  }

  /** How far a wick has come since the last step, metres; none if it has jumped, and its smoke stays behind. */
  wayTo(foot: Readonly<Vec3>): Vec3 {
    const [x, y, z] = this.solver.origin;
    const way: Vec3 = [foot[0] - x, foot[1] - y, foot[2] - z];
    return Math.hypot(...way) > JUMP ? [0, 0, 0] : way;
  }

  /** Sets the heat and the smoke that the wick gives off now. */
  #updateHeater(flame: Flame, { rate, height, smoking }: Readonly<FlameMeasures>): void {
    const { smoke } = this;
    const heater = this.#heater;
    if (flame.isLit) {
      heater.power = CONVECTED * HEAT * rate;
      heater.height = BURNING * height;
    } else {
      heater.power = (EMBER_POWER * (flame.ember - ROOM)) / (GLOWING - ROOM);
      heater.height = EMBER_HEIGHT;
    }
    const time = flame.isLit ? BURNING_OFF : KINDLING;
    smoke.strength += ((smoking - smoke.strength) * PLUME_STEP) / time;
    smoke.isFed = smoking > 0 || smoke.strength > LEAST_STRENGTH;
  }
}

/** Makes the plume of a flame at a foot, metres; for standing candles on a coarse grid. Null: not yet. */
export type CreatePlume = (seed: number, foot: Readonly<Vec3>, isCoarse: boolean) => Plume | null;

export const createPlume = (seed: number, foot: Readonly<Vec3>, isCoarse: boolean): Plume =>
  new Plume(seed, foot, isCoarse ? coarsePlumeGrid() : undefined);
