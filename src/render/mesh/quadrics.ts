/** Numbers of a quadric: the symmetric 4 x 4 matrix, and the area that it speaks for. */
const SIZE = 11;
/** How much more an open edge counts than a surface. */
const RIM = 10;

/**
 * How far away each point's surfaces would be, were it elsewhere.
 *
 * A quadric is the sum of the squared distances to planes, each for its area: Garland and Heckbert 1997,
 * "Surface Simplification Using Quadric Error Metrics".
 */
export class Quadrics {
  readonly #positions: ArrayLike<number>;
  readonly #sums: Float64Array;

  /**
   * @param positions xyz of each point, metres
   * @param corners points of the triangles, three to each
   */
  constructor(positions: ArrayLike<number>, corners: ArrayLike<number>) {
    this.#positions = positions;
    this.#sums = new Float64Array((positions.length / 3) * SIZE);
    for (let i = 0; i < corners.length; i += 3) this.#addTriangle(corners, i);
    for (const edge of rimsOf(corners)) this.#addRim(corners, edge);
  }

  /** Mean of the squared distances from what has fallen into a point, were that to fall into another; m². */
  cost(point: number, target: number): number {
    const p = this.#positions;
    const [x, y, z] = [p[3 * target]!, p[3 * target + 1]!, p[3 * target + 2]!];
    const at = point * SIZE;
    const q = this.#sums;
    const sum =
      x * (q[at]! * x + 2 * (q[at + 1]! * y + q[at + 2]! * z + q[at + 3]!)) +
      y * (q[at + 4]! * y + 2 * (q[at + 5]! * z + q[at + 6]!)) +
      z * (q[at + 7]! * z + 2 * q[at + 8]!) +
      q[at + 9]!;
    return Math.max(sum, 0) / Math.max(q[at + 10]!, 1e-12);
  }

  /** What a point stands for is another's now. */
  move(point: number, target: number): void {
    for (let k = 0; k < SIZE; k++) this.#sums[target * SIZE + k]! += this.#sums[point * SIZE + k]!;
  }

  #place(point: number): number[] {
    return [0, 1, 2].map((axis) => this.#positions[3 * point + axis]!);
  }

  #addTriangle(corners: ArrayLike<number>, first: number): void {
    const points = [0, 1, 2].map((k) => corners[first + k]!);
    const [a, b, c] = points.map((point) => this.#place(point)) as [number[], number[], number[]];
    const normal = cross(minus(b, a), minus(c, a));
    const twice = Math.hypot(...normal);
    if (!(twice > 0)) return;
    const unit = normal.map((x) => x / twice);
    for (const point of points) {
      this.#addPlane(point, unit, a, twice / 6);
      this.#sums[point * SIZE + 10]! += twice / 6;
    }
  }

  /** A plane that stands upright on an edge, across what lies beside it. */
  #addRim(corners: ArrayLike<number>, edge: number): void {
    const first = edge - (edge % 3);
    const [from, to, beside] = [0, 1, 2].map((k) => corners[first + ((edge + k) % 3)]!);
    const a = this.#place(from!);
    const along = minus(this.#place(to!), a);
    const across = cross(along, cross(along, minus(this.#place(beside!), a)));
    const length = Math.hypot(...across);
    if (!(length > 0)) return;
    const unit = across.map((x) => x / length);
    const weight = RIM * (along[0]! ** 2 + along[1]! ** 2 + along[2]! ** 2);
    for (const point of [from!, to!]) this.#addPlane(point, unit, a, weight);
  }

  /** The squared distance to a plane through a place, for an area. */
  #addPlane(
    point: number,
    normal: readonly number[],
    through: readonly number[],
    weight: number,
  ): void {
    const [a = 0, b = 0, c = 0] = normal;
    const d = -(a * through[0]! + b * through[1]! + c * through[2]!);
    const terms = [a * a, a * b, a * c, a * d, b * b, b * c, b * d, c * c, c * d, d * d];
    for (let k = 0; k < 10; k++) this.#sums[point * SIZE + k]! += weight * terms[k]!;
  }
}

/** The corner at which each edge begins that has a triangle on one side only. */
function* rimsOf(corners: ArrayLike<number>): Generator<number> {
  const open = new Map<number, number>();
  for (let i = 0; i < corners.length; i++) {
    const [from, to] = [corners[i]!, corners[i % 3 === 2 ? i - 2 : i + 1]!];
    const key = Math.min(from, to) * 2 ** 26 + Math.max(from, to);
    // Shared by two it is no rim; by more, neither.
    open.set(key, open.has(key) ? -1 : i);
  }
  for (const edge of open.values()) if (edge >= 0) yield edge;
}

const minus = (a: readonly number[], b: readonly number[]) => a.map((x, k) => x - (b[k] ?? 0));

function cross(a: readonly number[], b: readonly number[]): number[] {
  const [ax = 0, ay = 0, az = 0] = a;
  const [bx = 0, by = 0, bz = 0] = b;
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}
