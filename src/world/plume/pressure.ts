import type { Axis } from "./axis.js";

/** Sweeps over the grid in each step. Each starts from the step before, so few are needed. */
const SWEEPS = 6;
/** Over-relaxation. */
const PUSH = 1.6;

/**
 * The pressure that keeps air from piling up anywhere, and takes away what of a flow would.
 *
 * Poisson's equation by successive over-relaxation, odd cells and even ones by turns (Young 1954), so
 * that a symmetric flow stays symmetric. Outside of the grid the pressure is the room's.
 */
export class PressureSolver {
  readonly #x: Axis;
  readonly #y: Axis;
  readonly #z: Axis;
  /** With a rim of the room's pressure, 0, all around. */
  readonly #pressure: Float32Array;
  readonly #excess: Float32Array;
  /** What a cell's lower and upper neighbours along each axis weigh. */
  readonly #weights: readonly (readonly [lower: Float64Array, upper: Float64Array])[];

  constructor({ x, y, z }: { readonly x: Axis; readonly y: Axis; readonly z: Axis }) {
    this.#x = x;
    this.#y = y;
    this.#z = z;
    this.#pressure = new Float32Array((x.count + 2) * (y.count + 2) * (z.count + 2));
    this.#excess = new Float32Array(x.count * y.count * z.count);
    this.#weights = [x, y, z].map(({ widths, spans }) => [
      widths.map((width, i) => 1 / (width * spans[i]!)),
      widths.map((width, i) => 1 / (width * spans[i + 1]!)),
    ]);
  }

  forget(): void {
    this.#pressure.fill(0);
  }

  /** Makes a flow keep its volume everywhere. */
  project(velocities: readonly [Float32Array, Float32Array, Float32Array]): void {
    this.#diverge(velocities);
    for (let sweep = 0; sweep < SWEEPS; sweep++) {
      this.#relax(0);
      this.#relax(1);
    }
    this.#push(velocities);
  }

  divergence(velocities: readonly [Float32Array, Float32Array, Float32Array]): number {
    this.#diverge(velocities);
    const narrowest = this.#x.widths[this.#x.count >> 1]!;
    let most = 0;
    let fastest = 0;
    for (const excess of this.#excess) most = Math.max(most, Math.abs(excess));
    for (const speed of velocities[1]) fastest = Math.max(fastest, Math.abs(speed));
    return (most * narrowest) / Math.max(fastest, 1e-6);
  }

  /** Net outflow of each cell, 1/s. */
  #diverge([u, v, w]: readonly [Float32Array, Float32Array, Float32Array]): void {
    const nx = this.#x.count;
    const ny = this.#y.count;
    const nz = this.#z.count;
    let cell = 0;
    for (let k = 0; k < nz; k++) {
      const deep = 1 / this.#z.widths[k]!;
      for (let j = 0; j < ny; j++) {
        const high = 1 / this.#y.widths[j]!;
        const west = (nx + 1) * (j + ny * k);
        const south = nx * (j + (ny + 1) * k);
        const front = nx * (j + ny * k);
        const back = front + nx * ny;
        for (let i = 0; i < nx; i++, cell++) {
          this.#excess[cell] =
            (u[west + i + 1]! - u[west + i]!) / this.#x.widths[i]! +
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
    const [[west, east], [south, north], [front, back]] = this.#weights as [
      [Float64Array, Float64Array],
      [Float64Array, Float64Array],
      [Float64Array, Float64Array],
    ];
    for (let k = 0; k < nz; k++) {
      const f = front[k]!;
      const b = back[k]!;
      for (let j = 0; j < ny; j++) {
        const s = south[j]!;
        const n = north[j]!;
        const others = f + b + s + n;
        const start = nx * (j + ny * k);
        const corner = 1 + row * (j + 1) + plane * (k + 1);
        for (let i = (color + j + k) & 1; i < nx; i += 2) {
          const at = corner + i;
          const e = east[i]!;
          const g = west[i]!;
          const sum =
            e * pressure[at + 1]! +
            g * pressure[at - 1]! +
            n * pressure[at + row]! +
            s * pressure[at - row]! +
            b * pressure[at + plane]! +
            f * pressure[at - plane]! -
            excess[start + i]!;
          pressure[at]! += PUSH * (sum / (others + e + g) - pressure[at]!);
        }
      }
    }
  }

  #push([u, v, w]: readonly [Float32Array, Float32Array, Float32Array]): void {
    const nx = this.#x.count;
    const ny = this.#y.count;
    const nz = this.#z.count;
    const row = nx + 2;
    const plane = row * (ny + 2);
    const pressure = this.#pressure;
    for (let k = 0; k <= nz; k++) {
      const deep = 1 / this.#z.spans[k]!;
      for (let j = 0; j <= ny; j++) {
        const high = 1 / this.#y.spans[j]!;
        const corner = 1 + row * (j + 1) + plane * (k + 1);
        if (j < ny && k < nz) {
          const west = (nx + 1) * (j + ny * k);
          for (let i = 0; i <= nx; i++) {
            u[west + i]! -= (pressure[corner + i]! - pressure[corner + i - 1]!) / this.#x.spans[i]!;
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
