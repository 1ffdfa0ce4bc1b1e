import type { Vec3 } from "../bounds.js";

/** Ghosts on either side of a line: what the outside has. */
const GHOSTS = 4;
const line = new Float32Array(128 + 2 * GHOSTS);

/**
 * Carries a field along one axis, in place: each line takes on what was upstream of it.
 *
 * Semi-Lagrangian (Stam 1999, "Stable Fluids"), one axis at a time, through four points instead of two
 * (Lagrange's cubic): linear interpolation is a hundred times as viscous as air.
 *
 * @param way cells that each value has come along the axis since the step before
 * @param count values of a line, and `stride` from each to the next
 * @param inner lines that lie `innerStride` apart, and so on
 * @param outside what flows in
 */
export function carry(
  field: Float32Array,
  way: Float32Array,
  count: number,
  stride: number,
  inner: number,
  innerStride: number,
  outer: number,
  outerStride: number,
  outside: number,
): void {
  line.fill(outside, 0, GHOSTS);
  line.fill(outside, GHOSTS + count, count + 2 * GHOSTS);
  const least = 1;
  const most = count + 2 * GHOSTS - 3;
  for (let b = 0; b < outer; b++) {
    for (let a = 0; a < inner; a++) {
      const start = a * innerStride + b * outerStride;
      for (let n = 0, at = start; n < count; n++, at += stride) line[GHOSTS + n] = field[at]!;
      for (let n = 0, at = start; n < count; n++, at += stride) {
        let from = n + GHOSTS - way[at]!;
        if (from < least) from = least;
        else if (from > most) from = most;
        const cell = from | 0;
        const t = from - cell;
        const s = 1 - t;
        const f0 = line[cell - 1]!;
        const f1 = line[cell]!;
        const f2 = line[cell + 1]!;
        const f3 = line[cell + 2]!;
        // s (f1) + t (f2), less what the third differences bend.
        field[at] =
          s * f1 +
          t * f2 -
          (s * t * ((1 + s) * (f0 - 2 * f1 + f2) + (1 + t) * (f1 - 2 * f2 + f3))) / 6;
      }
    }
  }
}

const sums = new Float64Array(128 + 2 * GHOSTS + 1);

/**
 * Carries an amount along one axis, in place, so that none is lost or made: what has passed each face is
 * what lay upstream of it, as far as the flow has come.
 *
 * Lin and Rood 1996, "Multidimensional Flux-Form Semi-Lagrangian Transport Schemes", with the amounts
 * summed up along the line, and Lagrange's cubic through the sums. Nothing flows in from outside.
 *
 * @param field amount per cell's length, and `widths` of the cells
 * @param way cells that the flow through each face has come
 * @param strides from one cell to the next, along x, y and z; `wayStrides` from face to face
 * @param along which axis; the lines are numbered along the axes `inner` and `outer`
 */
export function carryAmount(
  field: Float32Array,
  way: Float32Array,
  widths: Float64Array,
  strides: Readonly<Vec3>,
  wayStrides: Readonly<Vec3>,
  along: number,
  inner: number,
  outer: number,
  innerCount: number,
  outerCount: number,
): void {
  const stride = strides[along]!;
  const wayStride = wayStrides[along]!;
  const count = widths.length;
  sums.fill(0, 0, GHOSTS + 1);
  const least = 1;
  const most = count + 2 * GHOSTS - 3;
  for (let b = 0; b < outerCount; b++) {
    for (let a = 0; a < innerCount; a++) {
      const start = a * strides[inner]! + b * strides[outer]!;
      let sum = 0;
      for (let n = 0, at = start; n < count; n++, at += stride) {
        sum += field[at]! * widths[n]!;
        sums[GHOSTS + n + 1] = sum;
      }
      if (sum === 0) continue;
      for (let n = GHOSTS + count + 1; n < count + 2 * GHOSTS; n++) sums[n] = sum;
      const wayStart = a * wayStrides[inner]! + b * wayStrides[outer]!;
      let below = 0;
      for (let n = 0, face = wayStart; n <= count; n++, face += wayStride) {
        let from = n + GHOSTS - way[face]!;
        if (from < least) from = least;
        else if (from > most) from = most;
        const cell = from | 0;
        const t = from - cell;
        const s = 1 - t;
        const f0 = sums[cell - 1]!;
        const f1 = sums[cell]!;
        const f2 = sums[cell + 1]!;
        const f3 = sums[cell + 2]!;
        const passed =
          s * f1 +
          t * f2 -
          (s * t * ((1 + s) * (f0 - 2 * f1 + f2) + (1 + t) * (f1 - 2 * f2 + f3))) / 6;
        if (n > 0) field[start + (n - 1) * stride] = (passed - below) / widths[n - 1]!;
        below = passed;
      }
    }
  }
}
