import type { Vec3 } from "../geometry.js";
import type { GridAxis } from "./grid-axis.js";

/** Ghost values on either side of a line: those of the outside. */
const GHOSTS = 4;
const line = new Float64Array(128 + 2 * GHOSTS);
/** Where each value of the line has come from: a place on it, ghosts included. */
const origins = new Float64Array(128 + 2 * GHOSTS);
const sums = new Float64Array(128 + 2 * GHOSTS + 1);

/** Largest amount in a line that is treated as empty. */
const NOTHING = 1e-6;

/** Values of a field along each axis, and the strides from one to the next. */
export interface Layout {
  readonly sizes: Readonly<Vec3>;
  readonly strides: Readonly<Vec3>;
}

export type Lines = Readonly<ReturnType<typeof linesOf>>;

/** The axes that lines along x, y and z lie side by side on. */
const INNER = [1, 0, 0] as const;
const OUTER = [2, 2, 1] as const;

/**
 * The lines of a field along one axis, and where the flow along them is found.
 *
 * @param field layout of the values
 * @param flow layout of the flow, on the faces across `along`
 * @param across axis of the faces that the values lie on; null in the middles of the cells
 * @param along axis of the lines
 * @param ruler of the grid along that axis
 * @param seconds of a step
 */
export function linesOf(
  field: Layout,
  flow: Layout,
  across: 0 | 1 | 2 | null,
  along: 0 | 1 | 2,
  ruler: GridAxis,
  seconds: number,
) {
  const { sizes, strides } = field;
  const inner = INNER[along];
  const outer = OUTER[along];
  const isAside = across !== null && across !== along;
  return {
    /** Values of a line, and the stride between them. */
    count: sizes[along],
    stride: strides[along],
    /** Lines along the two other axes, and the strides between them. */
    inner: sizes[inner],
    innerStride: strides[inner],
    outer: sizes[outer],
    outerStride: strides[outer],
    /** The same steps in the field of the flow. */
    flowStride: flow.strides[along],
    flowInner: flow.strides[inner],
    flowOuter: flow.strides[outer],
    /** Offset to the flow on the values' other side, where values and flow lie on different faces; else 0. */
    aside: isAside ? flow.strides[across] : 0,
    /** Whether those faces are counted by the inner lines, and the last of them. */
    isAsideInner: across === inner,
    lastAside: isAside ? sizes[across] - 1 : 0,
    /** Cells that a flow of 1 m/s travels in a step, at each value of a line, or face between them. */
    rates: (isAside ? ruler.widths : ruler.spans).map((length) => seconds / length),
  };
}

/** Flow along an axis. An object, since V8 boxes numbers that are passed: see DECISIONS.md. */
export interface Stream {
  /** Of the grid itself, m/s. */
  ride: number;
  /** Value outside of the grid. */
  outside: number;
}

/**
 * Advection of a field along one axis, in place.
 *
 * Semi-Lagrangian (Stam 1999, "Stable Fluids"), one axis at a time, through four points instead of two
 * (Lagrange's cubic): linear interpolation is a hundred times as viscous as air.
 *
 * @param flow along the axis, m/s
 */
export function advect(
  field: Float64Array,
  flow: Float64Array,
  lines: Lines,
  stream: Stream,
): void {
  const { count, stride, inner, outer, innerStride, outerStride } = lines;
  const { flowStride, flowInner, flowOuter, aside, isAsideInner, lastAside, rates } = lines;
  for (let n = 0, above = GHOSTS + count; n < GHOSTS; n++) {
    line[n] = line[above + n] = stream.outside;
  }
  for (let b = 0; b < outer; b++) {
    for (let a = 0; a < inner; a++) {
      const near = a * flowInner + b * flowOuter;
      if (aside === 0) {
        traceFaces(flow, near, flowStride, rates, count, stream);
      } else {
        const face = isAsideInner ? a : b;
        const far = face > 0 ? near - aside : near;
        traceMiddles(flow, face === lastAside ? far : near, far, flowStride, rates, count, stream);
      }
      fetchLine(field, a * innerStride + b * outerStride, stride, count);
    }
  }
}

/** Origins for flow on the same faces as the values. */
function traceFaces(
  flow: Float64Array,
  start: number,
  stride: number,
  rates: Float64Array,
  count: number,
  { ride }: Stream,
): void {
  const most = count + 2 * GHOSTS - 3;
  for (let n = 0, at = start; n < count; n++, at += stride) {
    const from = n + GHOSTS - (flow[at]! - ride) * rates[n]!;
    origins[n] = from < 1 ? 1 : from > most ? most : from;
  }
}

/** Origins for flow on other faces: the mean of the four around. */
function traceMiddles(
  flow: Float64Array,
  near: number,
  far: number,
  stride: number,
  rates: Float64Array,
  count: number,
  { ride }: Stream,
): void {
  const most = count + 2 * GHOSTS - 3;
  let previous = flow[near]! + flow[far]!;
  for (let n = 0, step = stride; n < count; n++, step += stride) {
    const next = flow[near + step]! + flow[far + step]!;
    const from = n + GHOSTS - (0.25 * (previous + next) - ride) * rates[n]!;
    origins[n] = from < 1 ? 1 : from > most ? most : from;
    previous = next;
  }
}

function fetchLine(field: Float64Array, start: number, stride: number, count: number): void {
  for (let n = 0, at = start; n < count; n++, at += stride) line[GHOSTS + n] = field[at]!;
  for (let n = 0, at = start; n < count; n++, at += stride) {
    const from = origins[n]!;
    const cell = from | 0;
    field[at] = through(line, cell, from - cell);
  }
}

/** Lagrange's cubic between the second and the third of four values in a row. */
function through(values: Float64Array, cell: number, t: number): number {
  const s = 1 - t;
  const f0 = values[cell - 1]!;
  const f1 = values[cell]!;
  const f2 = values[cell + 1]!;
  const f3 = values[cell + 2]!;
  // s (f1) + t (f2), less what the third differences bend.
  const bend = (1 + s) * (f0 - 2 * f1 + f2) + (1 + t) * (f1 - 2 * f2 + f3);
  return s * f1 + t * f2 - s * t * bend * (1 / 6);
}

/**
 * Conservative advection of an amount along one axis, in place: through each face passes what lay upstream of it.
 *
 * Lin and Rood 1996, "Multidimensional Flux-Form Semi-Lagrangian Transport Schemes", with the amounts
 * summed up along the line, and Lagrange's cubic through the sums. Nothing flows in from outside.
 *
 * @param field amount per cell's length, in the middles of the cells, and `widths` of those along the axis
 */
export function advectAmount(
  field: Float64Array,
  flow: Float64Array,
  widths: Float64Array,
  lines: Lines,
  stream: Stream,
): void {
  const { count, stride, inner, outer, innerStride, outerStride } = lines;
  sums.fill(0, 0, GHOSTS + 1);
  for (let b = 0; b < outer; b++) {
    for (let a = 0; a < inner; a++) {
      const start = a * innerStride + b * outerStride;
      let sum = 0;
      let most = 0;
      for (let n = 0, at = start; n < count; n++, at += stride) {
        const value = field[at]!;
        most = Math.max(most, Math.abs(value));
        sum += value * widths[n]!;
        sums[GHOSTS + n + 1] = sum;
      }
      if (most < NOTHING) {
        for (let n = 0, at = start; n < count; n++, at += stride) field[at] = 0;
        continue;
      }
      for (let n = GHOSTS + count + 1; n < count + 2 * GHOSTS; n++) sums[n] = sum;
      const face = a * lines.flowInner + b * lines.flowOuter;
      traceFaces(flow, face, lines.flowStride, lines.rates, count + 1, stream);
      let below = 0;
      for (let n = 0, at = start - stride; n <= count; n++, at += stride) {
        const from = Math.min(origins[n]!, count + 2 * GHOSTS - 3);
        const cell = from | 0;
        const amount = through(sums, cell, from - cell);
        if (n > 0) field[at] = (amount - below) / widths[n - 1]!;
        below = amount;
      }
    }
  }
}
