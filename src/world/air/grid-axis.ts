/** Entries of the table that finds a place on an axis. */
const TABLE = 512;

/**
 * One axis of a stretched grid: fine cells near the flame, wider ones away from it.
 *
 * Cells lie between edges; all lengths in metres.
 */
export class GridAxis {
  readonly count: number;
  readonly low: number;
  readonly high: number;
  readonly edges: Float64Array;
  readonly widths: Float64Array;
  /** From the middle of the cell below each edge to the middle of the one above it. */
  readonly spans: Float64Array;
  readonly perWidth: Float64Array;
  readonly perSpan: Float64Array;
  /** Of each cell, the weight of the one below it in a second derivative. */
  readonly lower: Float64Array;
  /** The same of the one above it. */
  readonly upper: Float64Array;
  readonly #table = new Float32Array(TABLE + 2);
  readonly #perMetre: number;

  constructor(widths: readonly number[], low: number) {
    this.count = widths.length;
    this.widths = Float64Array.from(widths);
    this.edges = new Float64Array(widths.length + 1);
    this.edges[0] = low;
    for (const [i, width] of widths.entries()) this.edges[i + 1] = this.edges[i]! + width;
    const first = widths[0]!;
    const last = widths[widths.length - 1]!;
    this.spans = Float64Array.from(
      this.edges,
      (_, i) => ((widths[i - 1] ?? first) + (widths[i] ?? last)) / 2,
    );
    this.perWidth = this.widths.map((width) => 1 / width);
    this.perSpan = this.spans.map((span) => 1 / span);
    this.lower = this.widths.map((width, i) => 1 / (width * this.spans[i]!));
    this.upper = this.widths.map((width, i) => 1 / (width * this.spans[i + 1]!));
    this.low = low;
    this.high = this.edges[this.count]!;
    this.#perMetre = TABLE / (this.high - low);
    for (let entry = 0, cell = 0; entry < this.#table.length; entry++) {
      const x = low + entry / this.#perMetre;
      while (cell < this.count - 1 && this.edges[cell + 1]! <= x) cell++;
      this.#table[entry] = cell + (x - this.edges[cell]!) / this.widths[cell]!;
    }
  }

  /** A place, counted in cells from the lower end; a number below 0 or above `count` lies outside. */
  place(x: number): number {
    const entry = (x - this.low) * this.#perMetre;
    if (entry < 0) return entry / TABLE;
    if (entry >= TABLE) return this.count * (entry / TABLE);
    const below = Math.floor(entry);
    const low = this.#table[below]!;
    return low + (this.#table[below + 1]! - low) * (entry - below);
  }
}

/** Cells that widen by a constant factor to both sides of one in the middle of the axis, around 0. */
export function symmetric(narrowest: number, growth: number, toEachSide: number): GridAxis {
  const side = Array.from({ length: toEachSide }, (_, i) => narrowest * growth ** (i + 1));
  const reach = side.reduce((sum, width) => sum + width, narrowest / 2);
  return new GridAxis([...side.toReversed(), narrowest, ...side], -reach);
}

/** Cells that widen upwards. */
export function rising(low: number, narrowest: number, growth: number, count: number): GridAxis {
  return new GridAxis(
    Array.from({ length: count }, (_, i) => narrowest * growth ** i),
    low,
  );
}
