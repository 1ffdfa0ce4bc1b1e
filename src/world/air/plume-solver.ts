import { length3, type Vec3 } from "../geometry.js";
import {
  advect,
  advectAmount,
  type Layout,
  type Lines,
  linesOf,
  type Stream,
} from "./advection.js";
import type { GridAxis } from "./grid-axis.js";
import { type PlumeGrid, plumeGrid, trilinear } from "./plume-grid.js";
import { PressureSolver } from "./pressure-solver.js";

/** Length of the air's own step, seconds: every other tick of the world. */
export const PLUME_STEP = 1 / 60;

/** Temperature of the room, kelvin. */
export const ROOM_TEMPERATURE = 293;
/** Density times specific heat of the room's air, J/(m³ K). */
const HEAT_CAPACITY = 1.2 * 1005;
/** m/s² */
const GRAVITY = 9.81;
/** Effective kinematic viscosity, m²/s: more than the 1.5e-5 of air at 293 K, for a grid as coarse as this. */
const VISCOSITY = 4e-5;
/** Prandtl number of air: viscosity over thermal diffusivity. */
const PRANDTL = 0.7;

/** Beyond the grid its motion fades over about this length, metres. */
const FADING = 0.35;

/** Heat source of the air: an upright rod of hot gas above the origin. */
export interface Heater {
  /** W */
  power: number;
  /** Metres. */
  height: number;
}

type Three<T> = readonly [T, T, T];

/**
 * Buoyant plume solver: the air around a flame, an incompressible fluid that heat makes rise.
 *
 * Velocities (m/s, in the room) lie on the faces of the cells, the excess of temperature (in units of the room's
 * own) in their middles. The grid moves with the flame; the air around it is wind. Harlow and Welch 1965,
 * "Numerical Calculation of Time-Dependent Viscous Incompressible Flow", for the staggered grid; Boussinesq 1903
 * for the buoyancy.
 */
export class PlumeSolver {
  readonly grid: PlumeGrid;
  /** Velocities along x, y and z. */
  readonly velocities: Three<Float64Array>;
  /** T / T0 - 1 */
  readonly heat: Float64Array;
  /** Origin of the grid in the room, metres. */
  readonly origin: Vec3 = [0, 0, 0];
  readonly #previous: Three<Float64Array>;
  readonly #warmth: Float64Array;
  /** Of each component of velocity and of heat, the lines along each axis. */
  readonly #lines: Three<Three<Lines>>;
  readonly #heatLines: Three<Lines>;
  readonly #pressure: PressureSolver;
  readonly #wind: Vec3 = [0, 0, 0];
  readonly #stream: Stream = { ride: Number.NaN, outside: Number.NaN };
  /** Place of a query, in cells. */
  readonly #at: Vec3 = [0, 0, 0];
  readonly #rulers: Three<GridAxis>;
  /** `GridAxis`' weights of a cell's neighbours along x, times the step. */
  readonly #diffusionLower: Float64Array;
  readonly #diffusionUpper: Float64Array;

  constructor(grid: PlumeGrid = plumeGrid()) {
    this.grid = grid;
    this.#rulers = [grid.x, grid.y, grid.z];
    const { widths, spans } = grid.x;
    this.#diffusionLower = widths.map((width, i) => PLUME_STEP / (width * spans[i]!));
    this.#diffusionUpper = widths.map((width, i) => PLUME_STEP / (width * spans[i + 1]!));
    const { x, y, z } = grid;
    const middles = layout(x.count, y.count, z.count);
    // A component of velocity lies on the faces across its axis.
    const faces = [
      layout(x.count + 1, y.count, z.count),
      layout(x.count, y.count + 1, z.count),
      layout(x.count, y.count, z.count + 1),
    ] as const;
    this.velocities = three((axis) => zeros(faces[axis]));
    this.#previous = three((axis) => zeros(faces[axis]));
    this.heat = zeros(middles);
    this.#warmth = zeros(middles);
    const lines = (field: Layout, across: 0 | 1 | 2 | null) =>
      three((along) =>
        linesOf(field, faces[along], across, along, this.#rulers[along], PLUME_STEP),
      );
    this.#lines = three((axis) => lines(faces[axis], axis));
    this.#heatLines = lines(middles, null);
    this.#pressure = new PressureSolver(grid);
  }

  /** Clears the grid: nothing but wind, m/s, around an origin, metres. */
  reset(origin: Readonly<Vec3>, wind: Readonly<Vec3>): void {
    for (let axis = 0; axis < 3; axis++) {
      this.velocities[axis]!.fill(wind[axis]!);
      this.origin[axis] = origin[axis]!;
      this.#wind[axis] = wind[axis]!;
    }
    this.heat.fill(0);
    this.#pressure.forget();
  }

  /** Takes over the state of another, on the same grid. */
  copy(other: PlumeSolver): void {
    for (let axis = 0; axis < 3; axis++) {
      this.velocities[axis]!.set(other.velocities[axis]!);
      this.origin[axis] = other.origin[axis]!;
      this.#wind[axis] = other.#wind[axis]!;
    }
    this.heat.set(other.heat);
    this.#pressure.copy(other.#pressure);
  }

  /**
   * One `PLUME_STEP`.
   *
   * @param origin foot of the flame, metres
   * @param wind of the room around, m/s
   */
  step(origin: Readonly<Vec3>, wind: Readonly<Vec3>, heater: Readonly<Heater>): void {
    const { velocities } = this;
    const stream = this.#stream;
    for (let axis = 0; axis < 3; axis++) {
      const flow = velocities[axis]!;
      // A wind that changes is pushed by the room's pressure, which reaches all of this air at once.
      const change = wind[axis]! - this.#wind[axis]!;
      if (change !== 0) for (let at = 0; at < flow.length; at++) flow[at]! += change;
      this.#previous[axis]!.set(flow);
      this.#wind[axis] = wind[axis]!;
    }
    // The grid's own motion: a flame carried through still air stands in a wind.
    for (let along = 0; along < 3; along++) {
      stream.ride = (origin[along]! - this.origin[along]!) / PLUME_STEP;
      const flow = this.#previous[along]!;
      for (let axis = 0; axis < 3; axis++) {
        stream.outside = wind[axis]!;
        advect(velocities[axis]!, flow, this.#lines[axis]![along]!, stream);
      }
      const { widths } = this.#rulers[along]!;
      advectAmount(this.heat, flow, widths, this.#heatLines[along]!, stream);
    }
    for (let axis = 0; axis < 3; axis++) this.origin[axis] = origin[axis]!;
    if (heater.power > 0) this.#addHeat(heater);
    this.#diffuse();
    this.#addBuoyancy();
    this.#pressure.project(velocities);
  }

  /** Velocity of the air at a place in the room, m/s. Away from the grid it fades to the wind's. */
  velocity(place: Readonly<Vec3>, out: Vec3): Vec3 {
    const { grid, origin } = this;
    const x = place[0] - origin[0];
    const y = place[1] - origin[1];
    const z = place[2] - origin[2];
    const px = grid.x.place(x);
    const py = grid.y.place(y);
    const pz = grid.z.place(z);
    const nx = grid.x.count;
    const ny = grid.y.count;
    const nz = grid.z.count;
    const u = this.velocities[0];
    const v = this.velocities[1];
    const w = this.velocities[2];
    const at = this.#at;
    at[0] = px;
    at[1] = py - 0.5;
    at[2] = pz - 0.5;
    trilinear(u, nx + 1, ny, nz, at, out, 0);
    at[0] = px - 0.5;
    at[1] = py;
    trilinear(v, nx, ny + 1, nz, at, out, 1);
    at[1] = py - 0.5;
    at[2] = pz;
    trilinear(w, nx, ny, nz + 1, at, out, 2);
    if (px >= 0 && py >= 0 && pz >= 0 && px <= nx && py <= ny && pz <= nz) return out;
    const dx = Math.max(grid.x.low - x, 0, x - grid.x.high);
    const dy = Math.max(grid.y.low - y, 0, y - grid.y.high);
    const dz = Math.max(grid.z.low - z, 0, z - grid.z.high);
    const weight = Math.exp(-length3(dx, dy, dz) / FADING);
    for (let axis = 0; axis < 3; axis++) {
      const wind = this.#wind[axis]!;
      out[axis] = wind + (out[axis]! - wind) * weight;
    }
    return out;
  }

  /** Diffusion of heat and of upward motion; hotter air has more of it. */
  #diffuse(): void {
    const { x, y, z } = this.grid;
    const { heat } = this;
    const v = this.velocities[1];
    const warm = this.#warmth;
    const ease = this.#previous[0];
    const fast = this.#previous[1];
    warm.set(heat);
    fast.set(v);
    // Halves, so that two neighbours add up to their mean.
    for (let at = 0; at < heat.length; at++) {
      const h = heat[at]!;
      const hotter = 1 + h;
      ease[at] = h > 0 ? 0.5 * VISCOSITY * hotter * Math.sqrt(hotter) : 0.5 * VISCOSITY;
    }
    const nx = x.count;
    const ny = y.count;
    const nz = z.count;
    const plane = nx * ny;
    const vPlane = nx * (ny + 1);
    for (let k = 1; k < nz - 1; k++) {
      const nearer = PLUME_STEP / (z.widths[k]! * z.spans[k]!);
      const farther = PLUME_STEP / (z.widths[k]! * z.spans[k + 1]!);
      for (let j = 1; j < ny - 1; j++) {
        const row = nx * (j + ny * k);
        const vRow = nx * (j + (ny + 1) * k);
        for (let i = 1; i < nx - 1; i++) {
          const at = row + i;
          const h = warm[at]!;
          const d = ease[at]!;
          const west = (d + ease[at - 1]!) * this.#diffusionLower[i]!;
          const east = (d + ease[at + 1]!) * this.#diffusionUpper[i]!;
          const front = (d + ease[at - plane]!) * nearer;
          const back = (d + ease[at + plane]!) * farther;
          heat[at] =
            h +
            (west * (warm[at - 1]! - h) +
              east * (warm[at + 1]! - h) +
              front * (warm[at - plane]! - h) +
              back * (warm[at + plane]! - h)) /
              PRANDTL;
          const up = vRow + i;
          const f = fast[up]!;
          v[up] =
            f +
            west * (fast[up - 1]! - f) +
            east * (fast[up + 1]! - f) +
            front * (fast[up - vPlane]! - f) +
            back * (fast[up + vPlane]! - f);
        }
      }
    }
  }

  #addHeat({ power, height }: Readonly<Heater>): void {
    const { x, y, z } = this.grid;
    const i = x.count >> 1;
    const k = z.count >> 1;
    const area = x.widths[i]! * z.widths[k]!;
    const gain = (power * PLUME_STEP) / (HEAT_CAPACITY * ROOM_TEMPERATURE * area * height);
    for (let j = 0; j < y.count; j++) {
      const top = Math.min(y.edges[j + 1]!, height);
      const coverage = (top - Math.max(y.edges[j]!, 0)) / y.widths[j]!;
      if (coverage <= 0) continue;
      const at = i + x.count * (j + y.count * k);
      this.heat[at]! += gain * coverage;
    }
  }

  /** Buoyancy, after Boussinesq. */
  #addBuoyancy(): void {
    const { x, y, z } = this.grid;
    const v = this.velocities[1];
    const { heat } = this;
    const half = 0.5 * GRAVITY * PLUME_STEP;
    for (let k = 0; k < z.count; k++) {
      for (let j = 1; j < y.count; j++) {
        const below = x.count * (j - 1 + y.count * k);
        const face = x.count * (j + (y.count + 1) * k);
        for (let i = 0; i < x.count; i++) {
          v[face + i]! += half * (heat[below + i]! + heat[below + x.count + i]!);
        }
      }
    }
  }
}

function layout(nx: number, ny: number, nz: number): Layout {
  return { sizes: [nx, ny, nz], strides: [1, nx, nx * ny] };
}

const zeros = ({ sizes }: Layout) => new Float64Array(sizes[0] * sizes[1] * sizes[2]);

const three = <T>(make: (axis: 0 | 1 | 2) => T): Three<T> => [make(0), make(1), make(2)];
