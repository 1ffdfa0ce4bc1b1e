import type { GridAxis } from "./grid-axis.js";

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
  readonly #x: GridAxis;
  readonly #y: GridAxis;
  readonly #z: GridAxis;
  /** With a rim of the room's pressure, 0, all around. */
  readonly #pressure: Float64Array;
  readonly #excess: Float64Array;
  /** Weights of a cell's lower and upper neighbours along each axis. */
  readonly #weights: readonly [Weights, Weights, Weights];
  /** Of each cell, the reciprocal of its six neighbours' weights, over-relaxed. */
  readonly #relaxations: Float64Array;
  /** Of each axis, 1 / width of its cells and 1 / span between them. */
  readonly #perWidth: readonly [Float64Array, Float64Array, Float64Array];
  readonly #perSpan: readonly [Float64Array, Float64Array, Float64Array];

  constructor({ x, y, z }: { readonly x: GridAxis; readonly y: GridAxis; readonly z: GridAxis }) {
    this.#x = x;
    this.#y = y;
    this.#z = z;
    this.#pressure = new Float64Array((x.count + 2) * (y.count + 2) * (z.count + 2));
    this.#excess = new Float64Array(x.count * y.count * z.count);
    this.#weights = [weights(x), weights(y), weights(z)];
    this.#perWidth = [inverse(x.widths), inverse(y.widths), inverse(z.widths)];
    this.#perSpan = [inverse(x.spans), inverse(y.spans), inverse(z.spans)];
    const [east, north, back] = this.#weights.map(({ lower, upper }) =>
      lower.map((weight, i) => weight + upper[i]!),
    ) as [Float64Array, Float64Array, Float64Array];
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

  /** Removes the divergence of a flow. */
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
    const nx = this.#x.count;
    const ny = this.#y.count;
    const nz = this.#z.count;
    const excess = this.#excess;
    const perX = this.#perWidth[0];
    const perY = this.#perWidth[1];
    const perZ = this.#perWidth[2];
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
    const nx = this.#x.count;
    const ny = this.#y.count;
    const nz = this.#z.count;
    const row = nx + 2;
    const plane = row * (ny + 2);
    const pressure = this.#pressure;
    const excess = this.#excess;
    const relaxations = this.#relaxations;
    const { lower: west, upper: east } = this.#weights[0];
    const { lower: south, upper: north } = this.#weights[1];
    const { lower: front, upper: back } = this.#weights[2];
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
    const nx = this.#x.count;
    const ny = this.#y.count;
    const nz = this.#z.count;
    const row = nx + 2;
    const plane = row * (ny + 2);
    const pressure = this.#pressure;
    const perX = this.#perSpan[0];
    const perY = this.#perSpan[1];
    const perZ = this.#perSpan[2];
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

/** Weights of the neighbours along an axis. */
interface Weights {
  readonly lower: Float64Array;
  readonly upper: Float64Array;
}

function weights({ widths, spans }: GridAxis): Weights {
  return {
    lower: widths.map((width, i) => 1 / (width * spans[i]!)),
    upper: widths.map((width, i) => 1 / (width * spans[i + 1]!)),
  };
}

function inverse(lengths: Float64Array): Float64Array {
  return lengths.map((length) => 1 / length);
}
