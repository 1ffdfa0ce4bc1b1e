// A buoyant diffusion flame over a round source, solved in radius and height: the laboratory against
// which the live model of puffing (src/world/flame/puffing.ts) is fitted and tested. Never shipped.
//
// Gas at low Mach number: temperature follows the mixture fraction Z (fuel and air burn where they meet:
// Burke and Schumann 1928, "Diffusion Flames"), density follows temperature. So hot gas rises with
// g (T/T0 - 1), and swells where it is heated:
//
//   DZ/Dt = div(rho D grad Z) / rho          div u = (T'/T) DZ/Dt
//   Du/Dt = -grad p / rho + g (T/T0 - 1) + div(mu grad u) / rho
//
// Staggered grid, finest at the source and stretched away from it. Advection by limited third-order
// differences (Koren 1993) and Adams-Bashforth in time: semi-Lagrangian steps damp the instability away.
// Pressure is exact in one go: the constant-coefficient operator is diagonal in the eigenvectors of its
// radial part (Lynch, Rice and Thomas 1964), and the variable density is split off to the right-hand
// side (Dodd and Ferrante 2014, "A fast pressure-correction method for incompressible two-fluid flows").
// SI units; density is a share of the cold air's.

import { EigenvalueDecomposition } from "ml-matrix";

/** Mixture fraction at which fuel and air are used up together: paraffin in air. */
const STOICHIOMETRIC = 0.063;

/** Kelvin: cold air, where the two lines of Burke and Schumann would cross, and fuel at the source. */
const AIR = 300;
const SHEET = 1900;
const FUEL = 600;
/** How far the crossing is rounded off, kelvin: the sheet itself has 1800 K. */
const ROUNDING = 200;
/** Kinematic viscosity of cold air, m²/s. It grows as the 1.75th power of temperature, and density falls. */
const VISCOSITY = 1.57e-5;
/** Viscosity to diffusivity. */
const SCHMIDT = 0.7;

/** Part of a cell that gas may cross in a step, and part of the limit of explicit diffusion. */
const COURANT = 0.5;
const DIFFUSIVE = 0.5;
/** Ghost cells around each field. */
const GHOSTS = 2;

/** A wick of 30 mm on Earth. */
const DEFAULTS = {
  /** Of the source, metres. */
  diameter: 0.03,
  gravity: 9.81,
  /** Of the fuel as it leaves the source, m/s. */
  fuelSpeed: 0.015,
  cellsPerDiameter: 16,
  /** Reach of the grid, in diameters. */
  radius: 3.5,
  height: 10,
};

const RISE = (SHEET - AIR) / STOICHIOMETRIC;
const FALL = -(SHEET - FUEL) / (1 - STOICHIOMETRIC);

/** Kelvin, of gas with this share of fuel: the lesser of two lines, rounded where they cross. */
function temperature(mixture) {
  const lean = AIR + RISE * mixture;
  const rich = SHEET + FALL * (mixture - STOICHIOMETRIC);
  const gap = lean - rich;
  return 0.5 * (lean + rich - Math.sqrt(gap * gap + ROUNDING * ROUNDING));
}

/** Its derivative. */
function heating(mixture) {
  const gap = AIR - SHEET + RISE * mixture - FALL * (mixture - STOICHIOMETRIC);
  return 0.5 * (RISE + FALL - ((RISE - FALL) * gap) / Math.sqrt(gap * gap + ROUNDING * ROUNDING));
}

const COLD = temperature(0);

/** Faces of cells along an axis: alike up to `even`, then each wider than the last. */
function faces(width, even, reach, stretch) {
  const at = [0];
  for (let i = 0; at[i] < reach; i++) at.push(at[i] + width * stretch ** Math.max(0, i + 1 - even));
  return Float64Array.from(at);
}

const differences = (edges) => edges.slice(1).map((edge, i) => edge - edges[i]);
const middles = (edges) => edges.slice(1).map((edge, i) => (edge + edges[i]) / 2);

/** From centre to centre; across the rim of the grid, as far as the last cell is wide. */
function gaps(centres, widths) {
  const last = widths.length - 1;
  const inner = centres.slice(1).map((centre, i) => centre - centres[i]);
  return Float64Array.from([widths[0], ...inner, widths[last]]);
}

/** Value at a cell's face, carried from the cell at `from` on to the next: Koren's limiter. */
function carried(field, from, step) {
  const near = field[from];
  const back = near - field[from - step];
  const ahead = field[from + step] - near;
  if (back * ahead <= 0) return near;
  const third = (back + 2 * ahead) / 3;
  return back > 0
    ? near + 0.5 * Math.min(2 * ahead, third, 2 * back)
    : near + 0.5 * Math.max(2 * ahead, third, 2 * back);
}

/** The same for a face between `from` and the next one, crossed at this speed. */
function across(field, from, step, speed) {
  return speed > 0 ? carried(field, from, step) : carried(field, from + step, -step);
}

export class Fire {
  /** Seconds since it was lit. */
  time = 0;

  constructor(options = {}) {
    Object.assign(this, DEFAULTS, options);
    const { diameter, cellsPerDiameter, radius, height } = this;
    const width = diameter / cellsPerDiameter;
    this.rf = faces(width, cellsPerDiameter, radius * diameter, 1.08);
    this.zf = faces(width, 4 * cellsPerDiameter, height * diameter, 1.05);
    this.rc = middles(this.rf);
    this.zc = middles(this.zf);
    this.dr = differences(this.rf);
    this.dz = differences(this.zf);
    this.gr = gaps(this.rc, this.dr);
    this.gz = gaps(this.zc, this.dz);
    this.nr = this.dr.length;
    this.nz = this.dz.length;
    this.source = Math.round(cellsPerDiameter / 2);
    this.stride = this.nr + 1 + 2 * GHOSTS;
    const length = this.stride * (this.nz + 1 + 2 * GHOSTS);
    const field = (value = 0) => new Float64Array(length).fill(value);
    // Speeds on faces, inward of and below the cell of that index; the rest in the middle of cells.
    this.u = field();
    this.w = field();
    this.mixture = field();
    this.kelvin = field(COLD);
    this.mu = field(VISCOSITY);
    this.pressure = field();
    this.pressureBefore = field();
    this.guess = field();
    this.diffusion = field();
    this.swelling = field();
    this.rates = { u: field(), w: field(), mixture: field() };
    this.ratesBefore = { u: field(), w: field(), mixture: field() };
    this.shear = { u: field(), w: field() };
    this.stepBefore = 0;
    this.#factorize();
    this.#surround();
  }

  /** Lets seconds pass, in as few equal steps as are stable. */
  advance(seconds) {
    const steps = Math.ceil(seconds / this.#longestStep());
    for (let i = 0; i < steps; i++) this.#step(seconds / steps);
    this.time += seconds;
  }

  /** Volume inside of the flame's sheet, m³: soot glows there. */
  get volume() {
    let sum = 0;
    for (let j = 0; j < this.nz; j++) {
      const row = this.#at(0, j);
      for (let i = 0; i < this.nr; i++) {
        const within = (this.mixture[row + i] / STOICHIOMETRIC - 0.9) * 5;
        if (within > 0) sum += Math.min(within, 1) * this.rc[i] * this.dr[i] * this.dz[j];
      }
    }
    return 2 * Math.PI * sum;
  }

  #at(i, j) {
    return (j + GHOSTS) * this.stride + i + GHOSTS;
  }

  #longestStep() {
    const { nr, nz, dr, dz, u, w, mu, kelvin } = this;
    let crossing = 1e-3;
    let spread = 0;
    for (let j = 0; j < nz; j++) {
      const row = this.#at(0, j);
      for (let i = 0; i < nr; i++) {
        const q = row + i;
        crossing = Math.max(crossing, Math.abs(u[q]) / dr[i] + Math.abs(w[q]) / dz[j]);
        spread = Math.max(spread, mu[q] * kelvin[q]);
      }
    }
    const diffusivity = spread / (COLD * SCHMIDT);
    return Math.min(COURANT / crossing, (DIFFUSIVE * dr[0] * dr[0]) / (4 * diffusivity));
  }

  #step(dt) {
    const { u, w, mixture, diffusion, swelling, shear, rates, ratesBefore } = this;
    this.#diffuse();
    this.#accelerate();
    // Adams and Bashforth: the rate in the middle of this step, from this one's begin and the last one's.
    const back = this.stepBefore > 0 ? dt / (2 * this.stepBefore) : 0;
    for (let q = 0; q < u.length; q++) {
      u[q] += dt * ((1 + back) * rates.u[q] - back * ratesBefore.u[q] + shear.u[q]);
      w[q] += dt * ((1 + back) * rates.w[q] - back * ratesBefore.w[q] + shear.w[q]);
      const rate = (1 + back) * rates.mixture[q] - back * ratesBefore.mixture[q] + diffusion[q];
      mixture[q] = Math.min(Math.max(mixture[q] + dt * rate, 0), 1);
    }
    this.rates = ratesBefore;
    this.ratesBefore = rates;
    this.stepBefore = dt;
    this.#surround();
    this.#diffuse();
    this.#project(dt, swelling);
    this.#surround();
  }

  /** Fills the ghosts: axis, cold and still air that is drawn in, floor with the source in it. */
  #surround() {
    const { nr, nz, stride, u, w, mixture, source, fuelSpeed, kelvin, mu } = this;
    for (let j = 0; j <= nz; j++) {
      const row = this.#at(0, j);
      u[row] = 0;
      u[row - 1] = -u[row + 1];
      u[row - 2] = -u[row + 2];
      const leaves = u[row + nr] > 0 ? 1 : 0;
      u[row + nr + 1] = u[row + nr];
      u[row + nr + 2] = u[row + nr];
      for (let ghost = 0; ghost < GHOSTS; ghost++) {
        w[row - 1 - ghost] = w[row + ghost];
        mixture[row - 1 - ghost] = mixture[row + ghost];
        w[row + nr + ghost] = leaves * w[row + nr - 1];
        mixture[row + nr + ghost] = leaves * mixture[row + nr - 1];
      }
    }
    const floor = this.#at(0, 0);
    const top = this.#at(0, nz);
    for (let i = -GHOSTS; i <= nr + 1; i++) {
      const isSource = (i < 0 ? -1 - i : i) < source;
      const below = floor + i;
      const above = top + i;
      const leaves = w[above] > 0 ? 1 : 0;
      // It is heated as it enters: as much mass, in more room.
      w[below] = isSource ? (fuelSpeed * kelvin[below]) / FUEL : 0;
      for (let ghost = 1; ghost <= GHOSTS; ghost++) {
        w[below - ghost * stride] = w[below];
        u[below - ghost * stride] = -u[below + (ghost - 1) * stride];
        mixture[below - ghost * stride] = isSource ? 1 : 0;
        w[above + ghost * stride] = w[above];
        u[above + (ghost - 1) * stride] = leaves * u[above - stride];
        mixture[above + (ghost - 1) * stride] = leaves * mixture[above - stride];
      }
    }
    for (let q = 0; q < mixture.length; q++) {
      kelvin[q] = temperature(mixture[q]);
      const ratio = kelvin[q] / COLD;
      mu[q] = VISCOSITY * Math.sqrt(ratio * Math.sqrt(ratio));
    }
  }

  /** Diffusion of the mixture fraction, div(rho D grad Z) / rho, and what the gas swells by. */
  #diffuse() {
    const { nr, nz, stride, rf, rc, dr, dz, gr, gz } = this;
    const { mixture, kelvin, mu, diffusion, swelling } = this;
    for (let j = 0; j < nz; j++) {
      const row = this.#at(0, j);
      for (let i = 0; i < nr; i++) {
        const q = row + i;
        const here = mixture[q];
        const outer = (rf[i + 1] * (mu[q] + mu[q + 1]) * (mixture[q + 1] - here)) / gr[i + 1];
        const inner = (rf[i] * (mu[q] + mu[q - 1]) * (here - mixture[q - 1])) / gr[i];
        const upper = ((mu[q] + mu[q + stride]) * (mixture[q + stride] - here)) / gz[j + 1];
        // Nothing diffuses into the floor or the source.
        const lower =
          j === 0 ? 0 : ((mu[q] + mu[q - stride]) * (here - mixture[q - stride])) / gz[j];
        const sum = (outer - inner) / (rc[i] * dr[i]) + (upper - lower) / dz[j];
        diffusion[q] = (0.5 * sum * kelvin[q]) / (COLD * SCHMIDT);
        swelling[q] = (heating(here) / kelvin[q]) * diffusion[q];
      }
    }
  }

  /** What carries and lifts the gas (`rates`), and its friction (`shear`). */
  #accelerate() {
    const { nr, nz, stride, rf, rc, dr, dz, gr, gz, u, w, mixture, kelvin, mu, gravity } = this;
    const { rates, shear } = this;
    for (let j = 0; j < nz; j++) {
      const row = this.#at(0, j);
      for (let i = 0; i < nr; i++) {
        const q = row + i;
        const ring = 1 / (rc[i] * dr[i]);
        const outer = rf[i + 1] * u[q + 1];
        const inner = rf[i] * u[q];
        const upper = w[q + stride];
        const lower = w[q];
        const left =
          (outer * across(mixture, q, 1, outer) - inner * across(mixture, q - 1, 1, inner)) * ring +
          (upper * across(mixture, q, stride, upper) -
            lower * across(mixture, q - stride, stride, lower)) /
            dz[j];
        rates.mixture[q] = mixture[q] * ((outer - inner) * ring + (upper - lower) / dz[j]) - left;
      }
    }
    for (let j = 1; j <= nz; j++) {
      const row = this.#at(0, j);
      const above = j === nz ? dz[nz - 1] : dz[j];
      for (let i = 0; i < nr; i++) {
        const q = row + i;
        const b = q - stride;
        const ring = 1 / (rc[i] * dr[i]);
        const outer = rf[i + 1] * 0.5 * (u[q + 1] + u[b + 1]);
        const inner = rf[i] * 0.5 * (u[q] + u[b]);
        const upper = 0.5 * (w[q] + w[q + stride]);
        const lower = 0.5 * (w[q] + w[b]);
        const left =
          (outer * across(w, q, 1, outer) - inner * across(w, q - 1, 1, inner)) * ring +
          (upper * across(w, q, stride, upper) - lower * across(w, b, stride, lower)) / gz[j];
        const hotness = (0.5 * (kelvin[q] + kelvin[b])) / COLD;
        rates.w[q] =
          w[q] * ((outer - inner) * ring + (upper - lower) / gz[j]) -
          left +
          gravity * (hotness - 1);
        const outerMu = 0.25 * (mu[q] + mu[b] + mu[q + 1] + mu[b + 1]);
        const innerMu = 0.25 * (mu[q] + mu[b] + mu[q - 1] + mu[b - 1]);
        shear.w[q] =
          hotness *
          (((rf[i + 1] * outerMu * (w[q + 1] - w[q])) / gr[i + 1] -
            (rf[i] * innerMu * (w[q] - w[q - 1])) / gr[i]) *
            ring +
            ((mu[q] * (w[q + stride] - w[q])) / above - (mu[b] * (w[q] - w[b])) / dz[j - 1]) /
              gz[j]);
      }
    }
    for (let j = 0; j < nz; j++) {
      const row = this.#at(0, j);
      for (let i = 1; i <= nr; i++) {
        const q = row + i;
        const outside = i === nr ? rf[nr] + 0.5 * dr[nr - 1] : rc[i];
        const ring = 1 / (rf[i] * gr[i]);
        const outer = outside * 0.5 * (u[q] + u[q + 1]);
        const inner = rc[i - 1] * 0.5 * (u[q] + u[q - 1]);
        const upper = 0.5 * (w[q + stride] + w[q + stride - 1]);
        const lower = 0.5 * (w[q] + w[q - 1]);
        const left =
          (outer * across(u, q, 1, outer) - inner * across(u, q - 1, 1, inner)) * ring +
          (upper * across(u, q, stride, upper) - lower * across(u, q - stride, stride, lower)) /
            dz[j];
        rates.u[q] = u[q] * ((outer - inner) * ring + (upper - lower) / dz[j]) - left;
        const hotness = (0.5 * (kelvin[q] + kelvin[q - 1])) / COLD;
        const upperMu = 0.25 * (mu[q] + mu[q - 1] + mu[q + stride] + mu[q + stride - 1]);
        const lowerMu = 0.25 * (mu[q] + mu[q - 1] + mu[q - stride] + mu[q - stride - 1]);
        const wider = i === nr ? dr[nr - 1] : dr[i];
        shear.u[q] =
          hotness *
          (((outside * mu[q] * (u[q + 1] - u[q])) / wider -
            (rc[i - 1] * mu[q - 1] * (u[q] - u[q - 1])) / dr[i - 1]) *
            ring -
            (0.5 * (mu[q] + mu[q - 1]) * u[q]) / (rf[i] * rf[i]) +
            ((upperMu * (u[q + stride] - u[q])) / gz[j + 1] -
              (lowerMu * (u[q] - u[q - stride])) / gz[j]) /
              dz[j]);
      }
    }
  }

  /** Makes the flow swell as it must, and by no more. */
  #project(dt, swelling) {
    const { nr, nz, stride, rf, rc, dr, dz, u, w, kelvin, guess } = this;
    let hottest = COLD;
    for (const value of kelvin) hottest = Math.max(hottest, value);
    // Everywhere as light as the lightest gas; the difference acts through the pressure as foreseen.
    const light = hottest / COLD;
    const { pressure: last, pressureBefore: next } = this;
    for (let q = 0; q < guess.length; q++) guess[q] = 2 * last[q] - next[q];
    for (let j = 0; j < nz; j++) guess[this.#at(nr, j)] = 0;
    for (let i = 0; i < nr; i++) guess[this.#at(i, nz)] = 0;
    this.#push(guess, (q, step) => dt * ((0.5 * (kelvin[q] + kelvin[q - step])) / COLD - light));
    for (let j = 0; j < nz; j++) {
      const row = this.#at(0, j);
      for (let i = 0; i < nr; i++) {
        const q = row + i;
        const out =
          (rf[i + 1] * u[q + 1] - rf[i] * u[q]) / (rc[i] * dr[i]) + (w[q + stride] - w[q]) / dz[j];
        this.right[j * nr + i] = (out - swelling[q]) / (dt * light);
      }
    }
    this.#solve(next);
    this.#push(next, () => dt * light);
    this.pressure = next;
    this.pressureBefore = last;
  }

  /** Pushes gas across faces. `share`: impulse for a gradient, between a cell and the one that is a step before it. */
  #push(pressure, share) {
    const { nr, nz, stride, gr, gz, u, w } = this;
    for (let j = 0; j <= nz; j++) {
      const row = this.#at(0, j);
      for (let i = 0; i <= nr; i++) {
        const q = row + i;
        if (j < nz && i > 0) u[q] -= (share(q, 1) * (pressure[q] - pressure[q - 1])) / gr[i];
        if (j > 0 && i < nr)
          w[q] -= (share(q, stride) * (pressure[q] - pressure[q - stride])) / gz[j];
      }
    }
  }

  /** Pressure whose Laplacian is the right-hand side. */
  #solve(out) {
    const { nr, nz, right, modes, sums, toModes, fromModes, lower, pivot, ahead } = this;
    for (let j = 0; j < nz; j++) {
      sums.fill(0);
      for (let i = 0; i < nr; i++) {
        const value = right[j * nr + i];
        for (let k = 0; k < nr; k++) sums[k] += toModes[i * nr + k] * value;
      }
      for (let k = 0; k < nr; k++) {
        const before = j === 0 ? 0 : lower[j] * modes[(j - 1) * nr + k];
        modes[j * nr + k] = (sums[k] - before) * pivot[j * nr + k];
      }
    }
    for (let j = nz - 2; j >= 0; j--) {
      for (let k = 0; k < nr; k++) modes[j * nr + k] -= ahead[j * nr + k] * modes[(j + 1) * nr + k];
    }
    for (let j = 0; j < nz; j++) {
      const row = this.#at(0, j);
      sums.fill(0);
      for (let k = 0; k < nr; k++) {
        const value = modes[j * nr + k];
        for (let i = 0; i < nr; i++) sums[i] += fromModes[k * nr + i] * value;
      }
      out.set(sums, row);
    }
  }

  /** Factorizes the operator of pressure: open (p = 0) at the side and above, closed below. */
  #factorize() {
    const { nr, nz, rf, rc, dr, dz, gr, gz } = this;
    const weight = rc.map((r, i) => Math.sqrt(r * dr[i]));
    const matrix = Array.from({ length: nr }, () => new Array(nr).fill(0));
    for (let i = 0; i < nr; i++) {
      const [inner, outer] = [rf[i] / gr[i], rf[i + 1] / gr[i + 1]];
      matrix[i][i] = -(inner + outer) / weight[i] ** 2;
      if (i === nr - 1) continue;
      matrix[i][i + 1] = outer / (weight[i] * weight[i + 1]);
      matrix[i + 1][i] = matrix[i][i + 1];
    }
    const { eigenvectorMatrix, realEigenvalues: values } = new EigenvalueDecomposition(matrix);
    const vectors = eigenvectorMatrix.transpose().to2DArray();
    this.toModes = new Float64Array(nr * nr);
    this.fromModes = new Float64Array(nr * nr);
    for (let k = 0; k < nr; k++) {
      for (let i = 0; i < nr; i++) {
        this.toModes[i * nr + k] = vectors[k][i] * weight[i];
        this.fromModes[k * nr + i] = vectors[k][i] / weight[i];
      }
    }
    // Thomas's algorithm in z: a tridiagonal matrix for each radial mode.
    this.lower = dz.map((size, j) => (j === 0 ? 0 : 1 / (gz[j] * size)));
    this.pivot = new Float64Array(nr * nz);
    this.ahead = new Float64Array(nr * nz);
    for (let j = 0; j < nz; j++) {
      const upper = 1 / (gz[j + 1] * dz[j]);
      for (let k = 0; k < nr; k++) {
        const before = j === 0 ? 0 : this.lower[j] * this.ahead[(j - 1) * nr + k];
        const pivot = 1 / (values[k] - this.lower[j] - upper - before);
        this.pivot[j * nr + k] = pivot;
        this.ahead[j * nr + k] = upper * pivot;
      }
    }
    this.right = new Float64Array(nr * nz);
    this.modes = new Float64Array(nr * nz);
    this.sums = new Float64Array(nr);
  }
}
