import type { Flame } from "../flame/flame.js";
import type { Vec3 } from "../geometry.js";
import type { PlumeGrid } from "./plume-grid.js";
import type { PlumeSolver } from "./plume-solver.js";

/** Floats per level of `hotColumn`. */
export const COLUMN_FLOATS = 5;
/** Less excess of temperature is part of no column, in units of the room's. */
const FAINT = 0.004;

/**
 * Hot column above a flame, level by level from below: its middle along x, y, z (metres, in the room), its
 * breadth (standard deviation, metres), and how much of the air is missing there (m²), since it is hot and thin.
 *
 * @param out `COLUMN_FLOATS` for each level of the grid
 */
export function hotColumn(solver: PlumeSolver, out: Float32Array): void {
  const { x, y, z } = solver.grid;
  const { heat, origin } = solver;
  const nx = x.count;
  const ny = y.count;
  const nz = z.count;
  for (let j = 0; j < ny; j++) {
    let missing = 0;
    let sumX = 0;
    let sumZ = 0;
    let squares = 0;
    for (let k = 0; k < nz; k++) {
      const row = nx * (j + ny * k);
      const cz = 0.5 * (z.edges[k]! + z.edges[k + 1]!);
      for (let i = 0; i < nx; i++) {
        const h = heat[row + i]!;
        if (h < FAINT) continue;
        const thin = (h / (1 + h)) * x.widths[i]! * z.widths[k]!;
        const cx = 0.5 * (x.edges[i]! + x.edges[i + 1]!);
        missing += thin;
        sumX += thin * cx;
        sumZ += thin * cz;
        squares += thin * (cx * cx + cz * cz);
      }
    }
    const inverse = 1 / Math.max(missing, 1e-12);
    const mx = sumX * inverse;
    const mz = sumZ * inverse;
    const at = j * COLUMN_FLOATS;
    out[at] = origin[0] + mx;
    out[at + 1] = origin[1] + 0.5 * (y.edges[j]! + y.edges[j + 1]!);
    out[at + 2] = origin[2] + mz;
    out[at + 3] = Math.sqrt(Math.max(0.5 * (squares * inverse - mx * mx - mz * mz), 1e-6));
    out[at + 4] = missing;
  }
}

/** What is missing above a flame that burns `RATE` (kg/s), m²; hot air that cools is thinned over more of it. */
const RATE = 1.75e-6;
const MISSING = 1.38e-4;
const COOLING = 2;
const COOLED = 0.25;
/** Breadth at the foot, metres, and for each metre above it. */
const BREADTH = 0.0045;
const SPREADING = 0.018;
/** Speed at which a column that wind bends rises, m/s. */
const RISING = 0.32;
/** For each metre that it is bent: share by which it thickens, and breadth. It ends between these, metres. */
const THICKENING = 35;
const BROADENING = 0.15;
const BENT = [0.08, 0.11] as const;

/**
 * The same above a flame whose air is not solved, by laws fitted to the solver's columns: within 15 %
 * in still air, and a third in a wind of 0.3 m/s.
 *
 * @param root of the flame, metres
 * @param wind around it, m/s
 * @param out `COLUMN_FLOATS` for each level of `grid`
 */
export function unsolvedColumn(
  { y }: PlumeGrid,
  flame: Flame,
  root: Readonly<Vec3>,
  wind: Readonly<Vec3>,
  out: Float32Array,
): void {
  const rate = flame.isLit ? flame.rate : 0;
  for (let j = 0; j < y.count; j++) {
    const height = 0.5 * (y.edges[j]! + y.edges[j + 1]!);
    const rise = Math.max(height, 0) / RISING;
    const bend = Math.hypot(wind[0] * rise, wind[2] * rise);
    const ends = Math.min(Math.max((BENT[1] - bend) / (BENT[1] - BENT[0]), 0), 1);
    const at = j * COLUMN_FLOATS;
    out[at] = root[0] + wind[0] * rise;
    out[at + 1] = root[1] + height;
    out[at + 2] = root[2] + wind[2] * rise;
    out[at + 3] = BREADTH + SPREADING * Math.min(height, COOLED) + BROADENING * bend;
    const cooling = 1 + COOLING * Math.min(height, COOLED) ** 2;
    out[at + 4] =
      MISSING *
      Math.sqrt(rate / RATE) *
      cooling *
      (1 + THICKENING * bend) *
      ends *
      (height > 0 ? 1 : 0);
  }
}
