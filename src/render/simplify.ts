/** Triangles that share vertices; a place may have several vertices, where a surface has an edge or its maps a seam. */
export interface Simplifiable {
  /** xyz, metres. */
  readonly positions: ArrayLike<number>;
  /** xyz of length 1. */
  readonly normals: ArrayLike<number>;
  /** Places in pictures. */
  readonly uvs?: ArrayLike<number>;
  /** Four to a vertex, 0 to 1. */
  readonly colors?: ArrayLike<number> | null;
  /** Three to a triangle. */
  readonly indices: ArrayLike<number>;
}

/** Numbers of a quadric: the symmetric 4 x 4 matrix, and the area that it speaks for. */
const QUADRIC = 11;
const MOST_ROUNDS = 16;
/** A round that leaves out less than this share of the corners is the last. */
const WORTHWHILE = 0.01;
/** Least cosine between a triangle before and after; and between the normals of vertices that become one. */
const LEAST_TURN = 0.3;
/** Both sides of a cloth keep apart: most that a surface moves, as a share of how thick a thing is. */
const SHARE_OF_THICKNESS = 0.25;
/** Least share of a surface that faces some way on the whole for it to be open. */
const OPEN = 0.02;
/** How far out of a triangle a place still counts as within, as a share of it. */
const WITHIN = 0.02;
/** Most that a picture is shifted on its surface, in errors of the surface; and a colour, 0 to 1. */
const SHIFT = 3;
const SHADE = 0.2;
/** How much more an open edge counts than a surface. */
const RIM = 10;

/**
 * Makes fewer triangles of the same vertices, nowhere much farther than `error` (metres) from where they
 * were, in rounds that can be spread over frames.
 *
 * Vertices fall into a neighbour, those first that change least: Garland and Heckbert 1997, "Surface
 * Simplification Using Quadric Error Metrics"; each once in a round, as meshoptimizer does (Kapoulkine
 * 2016). Along an edge or a seam both of its sides fall together, so that none opens.
 */
export class Simplification {
  readonly #mesh: Simplifiable;
  readonly #error: number;
  readonly #shift: number;
  readonly #points: Uint32Array;
  readonly #quadrics: Float64Array;
  #rounds = 0;
  /** Vertices of the triangles so far. */
  indices: Uint32Array;

  constructor(mesh: Simplifiable, error: number) {
    this.#mesh = mesh;
    this.#error = Math.min(error, thicknessOf(mesh) * SHARE_OF_THICKNESS);
    this.#shift = SHIFT * this.#error * picturesPerMetre(mesh);
    this.#points = pointsOf(mesh.positions);
    this.#quadrics = quadricsOf(mesh, this.#points);
    this.indices = withoutSlivers(Uint32Array.from(mesh.indices), this.#points);
  }

  /** Does one round. Whether there is more to do. */
  proceed(): boolean {
    const before = this.indices.length;
    const round = new Round(this.#mesh, this.#points, this.#quadrics, this.indices);
    this.indices = round.collapse(this.#error * this.#error, this.#shift);
    this.#rounds++;
    return this.#rounds < MOST_ROUNDS && this.indices.length <= before * (1 - WORTHWHILE);
  }
}

/** How thick what a surface encloses is in the mean, metres; infinite where it is open. */
export function thicknessOf({ positions, indices }: Simplifiable): number {
  let volume = 0;
  let area = 0;
  const facing = [0, 0, 0];
  const vertex = (corner: number) => [0, 1, 2].map((k) => positions[indices[corner]! * 3 + k]!);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [vertex(i), vertex(i + 1), vertex(i + 2)];
    const normal = cross(minus(b, a), minus(c, a));
    for (let k = 0; k < 3; k++) {
      facing[k]! += normal[k]! / 2;
      volume += (a[k]! * normal[k]!) / 6;
    }
    area += Math.hypot(...normal) / 2;
  }
  // What is closed faces all ways alike.
  if (Math.hypot(...facing) > OPEN * area) return Number.POSITIVE_INFINITY;
  return (2 * Math.abs(volume)) / Math.max(area, 1e-12);
}

/** Lengths of a mesh's pictures, as a share of them, along a metre of it. */
function picturesPerMetre({ positions, uvs, indices }: Simplifiable): number {
  if (!uvs) return 0;
  let metres = 0;
  let pictures = 0;
  for (let i = 0; i < indices.length; i++) {
    const from = indices[i]!;
    const to = indices[i % 3 === 2 ? i - 2 : i + 1]!;
    const along = (of: ArrayLike<number>, size: number, axis: number) =>
      of[to * size + axis]! - of[from * size + axis]!;
    metres += Math.hypot(along(positions, 3, 0), along(positions, 3, 1), along(positions, 3, 2));
    pictures += Math.hypot(along(uvs, 2, 0), along(uvs, 2, 1));
  }
  return pictures / Math.max(metres, 1e-9);
}

/** For each vertex the first that is in the same place. */
function pointsOf(positions: ArrayLike<number>): Uint32Array {
  const count = positions.length / 3;
  const points = new Uint32Array(count);
  const size = 2 ** Math.ceil(Math.log2(2 * count + 1));
  const table = new Int32Array(size).fill(-1);
  const bits = new Int32Array(Float32Array.from(positions).buffer);
  for (let vertex = 0; vertex < count; vertex++) {
    const [x, y, z] = [bits[3 * vertex]!, bits[3 * vertex + 1]!, bits[3 * vertex + 2]!];
    let slot = (Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791)) >>> 0;
    slot ^= slot >>> 15;
    for (slot &= size - 1; table[slot] !== -1; slot = (slot + 1) & (size - 1)) {
      const other = table[slot]!;
      if (bits[3 * other] === x && bits[3 * other + 1] === y && bits[3 * other + 2] === z) break;
    }
    if (table[slot] === -1) table[slot] = vertex;
    points[vertex] = table[slot]!;
  }
  return points;
}

function withoutSlivers(corners: Uint32Array, points: Uint32Array): Uint32Array {
  let length = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [corners[i]!, corners[i + 1]!, corners[i + 2]!];
    if (points[a] === points[b] || points[b] === points[c] || points[c] === points[a]) continue;
    corners[length++] = a;
    corners[length++] = b;
    corners[length++] = c;
  }
  return corners.slice(0, length);
}

/** Sum of the squared distances to a plane through a point, for an area. */
function addPlane(
  to: Float64Array,
  point: number,
  normal: readonly number[],
  through: readonly number[],
  weight: number,
): void {
  const [a = 0, b = 0, c = 0] = normal;
  const d = -(a * through[0]! + b * through[1]! + c * through[2]!);
  const terms = [a * a, a * b, a * c, a * d, b * b, b * c, b * d, c * c, c * d, d * d];
  for (let k = 0; k < 10; k++) to[point * QUADRIC + k]! += weight * terms[k]!;
}

function quadricsOf({ positions, indices }: Simplifiable, points: Uint32Array): Float64Array {
  const quadrics = new Float64Array(points.length * QUADRIC);
  const place = (vertex: number) => [0, 1, 2].map((k) => positions[3 * vertex + k] ?? 0);
  const open = new Map<number, number>();
  for (let i = 0; i < indices.length; i += 3) {
    const corner = [0, 1, 2].map((k) => points[indices[i + k] ?? 0]!);
    const [a, b, c] = corner.map(place) as [number[], number[], number[]];
    const normal = cross(minus(b, a), minus(c, a));
    const twice = Math.hypot(...normal);
    if (!(twice > 0)) continue;
    const unit = normal.map((x) => x / twice);
    for (const point of corner) {
      addPlane(quadrics, point, unit, a, twice / 6);
      quadrics[point * QUADRIC + 10]! += twice / 6;
    }
    for (let k = 0; k < 3; k++) {
      const [from, to] = [corner[k]!, corner[(k + 1) % 3]!];
      const key = Math.min(from, to) * points.length + Math.max(from, to);
      // Shared by two it is no rim; by more, it is.
      open.set(key, open.has(key) ? -1 : i * 3 + k);
    }
  }
  for (const edge of open.values()) {
    if (edge < 0) continue;
    const [i, k] = [Math.floor(edge / 9) * 3, edge % 9];
    const corner = [0, 1, 2].map((n) => points[indices[i + ((k + n) % 3)] ?? 0]!);
    const [from, to] = [corner[0]!, corner[1]!];
    const [a, b, c] = corner.map(place) as [number[], number[], number[]];
    const along = minus(b, a);
    const across = cross(along, cross(along, minus(c, a)));
    const length = Math.hypot(...across);
    if (!(length > 0)) continue;
    const unit = across.map((x) => x / length);
    const weight = RIM * (along[0]! ** 2 + along[1]! ** 2 + along[2]! ** 2);
    for (const point of [from, to]) addPlane(quadrics, point, unit, a, weight);
  }
  return quadrics;
}

const minus = (a: readonly number[], b: readonly number[]) => a.map((x, k) => x - (b[k] ?? 0));

function cross(a: readonly number[], b: readonly number[]): number[] {
  const [ax = 0, ay = 0, az = 0] = a;
  const [bx = 0, by = 0, bz = 0] = b;
  return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

/** Each vertex falls once, or is fallen into. */
class Round {
  readonly #positions: ArrayLike<number>;
  readonly #normals: ArrayLike<number>;
  readonly #uvs: ArrayLike<number> | undefined;
  readonly #colors: ArrayLike<number> | null | undefined;
  readonly #points: Uint32Array;
  readonly #quadrics: Float64Array;
  readonly #corners: Uint32Array;
  /** Corners at each point, one list after another. */
  readonly #begins: Uint32Array;
  readonly #fans: Uint32Array;
  /** What each vertex has become. */
  readonly #became: Uint32Array;

  constructor(
    { positions, normals, uvs, colors }: Simplifiable,
    points: Uint32Array,
    quadrics: Float64Array,
    corners: Uint32Array,
  ) {
    this.#positions = positions;
    this.#normals = normals;
    this.#uvs = uvs;
    this.#colors = colors;
    this.#points = points;
    this.#quadrics = quadrics;
    this.#corners = corners;
    this.#became = Uint32Array.from(points.keys());
    const begins = new Uint32Array(points.length + 1);
    for (const vertex of corners) begins[points[vertex]! + 1]!++;
    for (let point = 0; point < points.length; point++) begins[point + 1]! += begins[point]!;
    const ends = begins.slice();
    this.#fans = new Uint32Array(corners.length);
    for (let corner = 0; corner < corners.length; corner++) {
      this.#fans[ends[points[corners[corner]!]!]!++] = corner;
    }
    this.#begins = begins;
  }

  /** @param shift most that a picture moves, as a share of it */
  collapse(limit: number, shift: number): Uint32Array {
    const count = this.#points.length;
    const into = new Int32Array(count).fill(-1);
    const costs = new Float64Array(count);
    const falling: number[] = [];
    for (let point = 0; point < count; point++) {
      if (this.#begins[point] === this.#begins[point + 1]) continue;
      for (const neighbour of this.#ways(point)) {
        const cost = this.#cost(point, neighbour);
        if (cost > limit || (into[point] !== -1 && cost >= costs[point]!)) continue;
        into[point] = neighbour;
        costs[point] = cost;
      }
      if (into[point] !== -1) falling.push(point);
    }
    falling.sort((a, b) => costs[a]! - costs[b]! || a - b);
    const isDone = new Uint8Array(count);
    for (const point of falling) {
      const target = into[point]!;
      if (isDone[point] || isDone[target]) continue;
      const pairs = this.#pairs(point, target);
      if (!pairs || this.#spoils(point, target, shift)) continue;
      for (const [from, to] of pairs) this.#became[from] = to;
      for (let k = 0; k < QUADRIC; k++) {
        this.#quadrics[target * QUADRIC + k]! += this.#quadrics[point * QUADRIC + k]!;
      }
      isDone[point] = 1;
      isDone[target] = 1;
    }
    const next = this.#corners.map((vertex) => this.#became[vertex]!);
    return withoutSlivers(next, this.#points);
  }

  #next(corner: number): number {
    return this.#corners[corner % 3 === 2 ? corner - 2 : corner + 1]!;
  }

  #previous(corner: number): number {
    return this.#corners[corner % 3 === 0 ? corner + 2 : corner - 1]!;
  }

  /** Points that one may fall into: all around within a surface, along its edge at one. */
  #ways(point: number): readonly number[] {
    const around: number[] = [];
    const edges: number[] = [];
    const [begin, end] = [this.#begins[point]!, this.#begins[point + 1]!];
    for (let i = begin; i < end; i++) {
      const corner = this.#fans[i]!;
      const vertex = this.#next(corner);
      const neighbour = this.#points[vertex]!;
      if (around.includes(neighbour)) return []; // three triangles at one edge
      around.push(neighbour);
      let isWhole = false;
      for (let k = begin; k < end && !isWhole; k++) {
        const other = this.#fans[k]!;
        isWhole =
          this.#previous(other) === vertex && this.#corners[other] === this.#corners[corner];
      }
      if (!isWhole) edges.push(neighbour);
    }
    for (let i = begin; i < end; i++) {
      const neighbour = this.#points[this.#previous(this.#fans[i]!)]!;
      if (!around.includes(neighbour)) edges.push(neighbour); // a rim, seen from its other end
    }
    if (edges.length === 0) return around;
    return edges.length === 2 ? edges : [];
  }

  /** Each vertex of a point and the one that it becomes in another; none where that is not clear. */
  #pairs(point: number, target: number): Map<number, number> | null {
    const pairs = new Map<number, number>();
    const [begin, end] = [this.#begins[point]!, this.#begins[point + 1]!];
    for (let i = begin; i < end; i++) {
      const corner = this.#fans[i]!;
      const vertex = this.#corners[corner]!;
      for (const other of [this.#next(corner), this.#previous(corner)]) {
        if (this.#points[other] !== target) continue;
        if (this.#became[other] !== other) return null;
        if ((pairs.get(vertex) ?? other) !== other) return null;
        pairs.set(vertex, other);
      }
    }
    for (let i = begin; i < end; i++) if (!pairs.has(this.#corners[this.#fans[i]!]!)) return null;
    for (const [from, to] of pairs) if (this.#likeness(from, to) < LEAST_TURN) return null;
    return pairs;
  }

  #likeness(a: number, b: number): number {
    const n = this.#normals;
    return n[3 * a]! * n[3 * b]! + n[3 * a + 1]! * n[3 * b + 1]! + n[3 * a + 2]! * n[3 * b + 2]!;
  }

  /** Mean of the squared distances from what has fallen into a point, were that to fall into another. */
  #cost(point: number, target: number): number {
    const p = this.#positions;
    const [x, y, z] = [p[3 * target]!, p[3 * target + 1]!, p[3 * target + 2]!];
    const at = point * QUADRIC;
    const q = this.#quadrics;
    const sum =
      x * (q[at]! * x + 2 * (q[at + 1]! * y + q[at + 2]! * z + q[at + 3]!)) +
      y * (q[at + 4]! * y + 2 * (q[at + 5]! * z + q[at + 6]!)) +
      z * (q[at + 7]! * z + 2 * q[at + 8]!) +
      q[at + 9]!;
    return Math.max(sum, 0) / Math.max(q[at + 10]!, 1e-12);
  }

  /** Whether a triangle would turn over, or vanish, or what is painted there shift, beside those that have both points. */
  #spoils(point: number, target: number, shift: number): boolean {
    const p = this.#positions;
    const [fx, fy, fz] = [p[3 * point]!, p[3 * point + 1]!, p[3 * point + 2]!];
    const [tx, ty, tz] = [p[3 * target]!, p[3 * target + 1]!, p[3 * target + 2]!];
    for (let i = this.#begins[point]!; i < this.#begins[point + 1]!; i++) {
      const corner = this.#fans[i]!;
      const second = this.#became[this.#next(corner)]!;
      const third = this.#became[this.#previous(corner)]!;
      const b = this.#points[second]!;
      const c = this.#points[third]!;
      if (b === target || c === target || b === c) continue;
      const [bx, by, bz] = [p[3 * b]!, p[3 * b + 1]!, p[3 * b + 2]!];
      const [cx, cy, cz] = [p[3 * c]!, p[3 * c + 1]!, p[3 * c + 2]!];
      const [ex, ey, ez] = [cx - bx, cy - by, cz - bz];
      // Twice the triangle's area along each axis, before and after.
      const x = (by - fy) * ez - (bz - fz) * ey;
      const y = (bz - fz) * ex - (bx - fx) * ez;
      const z = (bx - fx) * ey - (by - fy) * ex;
      const u = (by - ty) * ez - (bz - tz) * ey;
      const v = (bz - tz) * ex - (bx - tx) * ez;
      const w = (bx - tx) * ey - (by - ty) * ex;
      const whole = u * u + v * v + w * w;
      const along = x * u + y * v + z * w;
      if (along <= LEAST_TURN * Math.sqrt((x * x + y * y + z * z) * whole)) return true;
      // Shares of the corners in the place that is given up.
      const atTarget = along / whole;
      const gx = (cy - fy) * (tz - fz) - (cz - fz) * (ty - fy);
      const gy = (cz - fz) * (tx - fx) - (cx - fx) * (tz - fz);
      const gz = (cx - fx) * (ty - fy) - (cy - fy) * (tx - fx);
      const atSecond = (gx * u + gy * v + gz * w) / whole;
      const atThird = 1 - atTarget - atSecond;
      if (Math.min(atTarget, atSecond, atThird) < -WITHIN) continue;
      const kept = this.#vertexOf(target, this.#corners[corner]!, point);
      if (kept === -1) continue;
      const from = this.#corners[corner]!;
      const mixed = (of: ArrayLike<number>, size: number, k: number) =>
        Math.abs(
          atTarget * of[kept * size + k]! +
            atSecond * of[second * size + k]! +
            atThird * of[third * size + k]! -
            of[from * size + k]!,
        );
      if (this.#uvs && mixed(this.#uvs, 2, 0) + mixed(this.#uvs, 2, 1) > shift) return true;
      if (this.#colors && mixed(this.#colors, 4, 0) > SHADE) return true;
    }
    return false;
  }

  /** The vertex that one of a point becomes in another. */
  #vertexOf(target: number, vertex: number, point: number): number {
    for (let i = this.#begins[point]!; i < this.#begins[point + 1]!; i++) {
      const corner = this.#fans[i]!;
      if (this.#corners[corner] !== vertex) continue;
      const [next, previous] = [this.#next(corner), this.#previous(corner)];
      if (this.#points[next] === target) return next;
      if (this.#points[previous] === target) return previous;
    }
    return -1;
  }
}
