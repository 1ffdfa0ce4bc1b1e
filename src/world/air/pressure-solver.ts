import type { GridAxis } from "./grid-axis.js";
import type { PlumeGrid } from "./plume-grid.js";

/** Sweeps over the grid in each step. Each starts from the step before, so few are needed. */
const SWEEPS = 6;
/** Over-relaxation. */
const PUSH = 1.6;

/**
 * Pressure solver: projects a flow onto one without divergence.
 *
 * Poisson's equation by successive over-relaxation, odd cells and even ones by turns (Young 1954), so
 * that a symmetric flow stays symmetric. Outside of the grid the pressure is the room's.
 */
export class PressureSolver {
  readonly #grid: PlumeGrid;
  /** With a rim of the room's pressure, 0, all around. */
  readonly #pressure: Float64Array;
  readonly #excess: Float64Array;
  /** Of each cell, the reciprocal of its six neighbours' weights, over-relaxed. */
  readonly #relaxations: Float64Array;

  constructor(grid: PlumeGrid) {
    const { x, y, z } = grid;
    this.#grid = grid;
    this.#pressure = new Float64Array((x.count + 2) * (y.count + 2) * (z.count + 2));
    this.#excess = new Float64Array(x.count * y.count * z.count);
    const both = ({ lower, upper }: GridAxis) => lower.map((weight, i) => weight + upper[i]!);
    const [east, north, back] = [both(x), both(y), both(z)];
    this.#relaxations = Float64Array.from(this.#excess, (_, cell) => {
      const i = cell % x.count;
      const j = Math.floor(cell / x.count) % y.count;
      const k = Math.floor(cell / (x.count * y.count));
      return PUSH / (east[i]! + north[j]! + back[k]!);
    });
  }

  forget(): void {
    this.#pressure.fill(0);
  }

  /** Begins its next step where another, on the same grid, would. */
  copy(other: PressureSolver): void {
    this.#pressure.set(other.#pressure);
  }

  project(velocities: readonly [Float64Array, Float64Array, Float64Array]): void {
    this.#diverge(velocities);
    for (let sweep = 0; sweep < SWEEPS; sweep++) {
      this.#relax(0);
      this.#relax(1);
    }
    this.#push(velocities);
  }

  /** Net outflow of each cell, 1/s. */
  #diverge(velocities: readonly [Float64Array, Float64Array, Float64Array]): void {
    const u = velocities[0];
    const v = velocities[1];
    const w = velocities[2];
    const { count: nx, perWidth: perX } = this.#grid.x;
    const { count: ny, perWidth: perY } = this.#grid.y;
    const { count: nz, perWidth: perZ } = this.#grid.z;
    const excess = this.#excess;
    let cell = 0;
    for (let k = 0; k < nz; k++) {
      const deep = perZ[k]!;
      for (let j = 0; j < ny; j++) {
        const high = perY[j]!;
        const west = (nx + 1) * (j + ny * k);
        const south = nx * (j + (ny + 1) * k);
        const front = nx * (j + ny * k);
        const back = front + nx * ny;
        for (let i = 0; i < nx; i++, cell++) {
          excess[cell] =
            (u[west + i + 1]! - u[west + i]!) * perX[i]! +
            (v[south + nx + i]! - v[south + i]!) * high +
            (w[back + i]! - w[front + i]!) * deep;
        }
      }
    }
  }

  #relax(color: number): void {
    const { count: nx, lower: west, upper: east } = this.#grid.x;
    const { count: ny, lower: south, upper: north } = this.#grid.y;
    const { count: nz, lower: front, upper: back } = this.#grid.z;
    const row = nx + 2;
    const plane = row * (ny + 2);
    const pressure = this.#pressure;
    const excess = this.#excess;
    const relaxations = this.#relaxations;
    for (let k = 0; k < nz; k++) {
      const f = front[k]!;
      const b = back[k]!;
      for (let j = 0; j < ny; j++) {
        const s = south[j]!;
        const n = north[j]!;
        const start = nx * (j + ny * k);
        const corner = 1 + row * (j + 1) + plane * (k + 1);
        for (let i = (color + j + k) & 1; i < nx; i += 2) {
          const at = corner + i;
          const sum =
            east[i]! * pressure[at + 1]! +
            west[i]! * pressure[at - 1]! +
            n * pressure[at + row]! +
            s * pressure[at - row]! +
            b * pressure[at + plane]! +
            f * pressure[at - plane]! -
            excess[start + i]!;
          pressure[at] = (1 - PUSH) * pressure[at]! + relaxations[start + i]! * sum;
        }
      }
    }
  }

  #push(velocities: readonly [Float64Array, Float64Array, Float64Array]): void {
    const u = velocities[0];
    const v = velocities[1];
    const w = velocities[2];
    const { count: nx, perSpan: perX } = this.#grid.x;
    const { count: ny, perSpan: perY } = this.#grid.y;
    const { count: nz, perSpan: perZ } = this.#grid.z;
    const row = nx + 2;
    const plane = row * (ny + 2);
    const pressure = this.#pressure;
    for (let k = 0; k <= nz; k++) {
      const deep = perZ[k]!;
      for (let j = 0; j <= ny; j++) {
        const high = perY[j]!;
        const corner = 1 + row * (j + 1) + plane * (k + 1);
        if (j < ny && k < nz) {
          const west = (nx + 1) * (j + ny * k);
          for (let i = 0; i <= nx; i++) {
            u[west + i]! -= (pressure[corner + i]! - pressure[corner + i - 1]!) * perX[i]!;
          }
        }
        if (k < nz) {
          const south = nx * (j + (ny + 1) * k);
          for (let i = 0; i < nx; i++) {
            v[south + i]! -= (pressure[corner + i]! - pressure[corner + i - row]!) * high;
          }
        }
        if (j < ny) {
          const front = nx * (j + ny * k);
          for (let i = 0; i < nx; i++) {
            w[front + i]! -= (pressure[corner + i]! - pressure[corner + i - plane]!) * deep;
          }
        }
      }
    }
  }
}
