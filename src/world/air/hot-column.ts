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
