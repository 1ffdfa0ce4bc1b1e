import type { Vec3 } from "../geometry.js";
import { type GridAxis, rising, symmetric } from "./grid-axis.js";

/** Grid of the air around a flame, relative to its origin. */
export interface PlumeGrid {
  readonly x: GridAxis;
  readonly y: GridAxis;
  readonly z: GridAxis;
}

/** 15 x 31 x 15 cells, 24 cm wide and 51 cm high; 7 mm small around the flame. */
export function plumeGrid(): PlumeGrid {
  const level = symmetric(0.007, 1.22, 7);
  return { x: level, y: rising(-0.035, 0.008, 1.044, 31), z: level };
}

/** 9 x 20 x 9 cells of the same extent, for the smoke of a standing candle. */
export function coarsePlumeGrid(): PlumeGrid {
  const level = symmetric(0.01, 1.45, 4);
  return { x: level, y: rising(-0.035, 0.012, 1.07, 20), z: level };
}

/**
 * Trilinear interpolation of a field of nx x ny x nz values, written to `out[axis]`.
 *
 * @param place counted from the first value, clamped to the grid
 */
export function trilinear(
  field: Float64Array,
  nx: number,
  ny: number,
  nz: number,
  place: Readonly<Vec3>,
  out: Vec3,
  axis: 0 | 1 | 2,
): void {
  const x = place[0];
  const y = place[1];
  const z = place[2];
  const cx = x < 0 ? 0 : x > nx - 1 ? nx - 1 : x;
  const cy = y < 0 ? 0 : y > ny - 1 ? ny - 1 : y;
  const cz = z < 0 ? 0 : z > nz - 1 ? nz - 1 : z;
  const i = Math.min(cx | 0, nx - 2);
  const j = Math.min(cy | 0, ny - 2);
  const k = Math.min(cz | 0, nz - 2);
  const fx = cx - i;
  const fy = cy - j;
  const fz = cz - k;
  const at = i + nx * (j + ny * k);
  const up = at + nx;
  const back = at + nx * ny;
  const upBack = back + nx;
  const near = field[at]! + (field[at + 1]! - field[at]!) * fx;
  const nearUp = field[up]! + (field[up + 1]! - field[up]!) * fx;
  const far = field[back]! + (field[back + 1]! - field[back]!) * fx;
  const farUp = field[upBack]! + (field[upBack + 1]! - field[upBack]!) * fx;
  const low = near + (nearUp - near) * fy;
  const high = far + (farUp - far) * fy;
  out[axis] = low + (high - low) * fz;
}
