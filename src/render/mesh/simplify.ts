import { Quadrics } from "./quadrics.js";
import { thicknessesOf } from "./thickness.js";

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

/** Triangles of vertices that are where one vertex of a mesh is, and look as another. */
export interface Simplified {
  /** For each vertex the one whose place it has, and the one that it is else. */
  readonly places: Uint32Array;
  readonly looks: Uint32Array;
  readonly indices: Uint32Array;
}

/** Corners of triangles, three to each: their points, and the vertices that they look as. */
interface Corners {
  readonly points: Uint32Array;
  readonly looks: Uint32Array;
}

const MOST_ROUNDS = 16;
/** A round that leaves out less than this share of the corners is the last. */
const WORTHWHILE = 0.01;
/** Least cosine between a triangle before and after; and between the normals of vertices that become one. */
const LEAST_TURN = 0.3;
/** Both sides of a cloth keep apart: most that a surface moves, as a share of how thick a thing is. */
const SHARE_OF_THICKNESS = 0.5;
/** How far out of a triangle a place still counts as within, as a share of it. */
const WITHIN = 0.02;
/** Most that a picture is shifted on its surface, in errors of the surface; and a colour, 0 to 1. */
const SHIFT = 3;
const SHADE = 0.2;

/**
 * Makes fewer triangles, nowhere much farther than `error` (metres) from where they were, in rounds that
 * can be spread over frames.
 *
 * Points fall into a neighbour, those first that change least: Garland and Heckbert 1997, "Surface
 * Simplification Using Quadric Error Metrics"; each once in a round, as meshoptimizer does (Kapoulkine
 * 2016). All that is at a point falls with it, so that no edge or seam opens. What has nothing like itself
 * there keeps its own look, as the faces of a box do whose bevel is left out.
 */
export class Simplification {
  readonly #mesh: Simplifiable;
  /** Of each point, metres. */
  readonly #errors: Float64Array;
  /** Lengths of the pictures, as a share of them, along a metre. */
  readonly #pictures: number;
  readonly #quadrics: Quadrics;
  #corners: Corners;
  #rounds = 0;

  constructor(mesh: Simplifiable, error: number) {
    this.#mesh = mesh;
    this.#pictures = picturesPerMetre(mesh);
    const points = pointsOf(mesh.positions);
    const looks = Uint32Array.from(mesh.indices);
    this.#corners = withoutSlivers({ points: looks.map((vertex) => points[vertex]!), looks });
    this.#quadrics = new Quadrics(mesh.positions, this.#corners.points);
    this.#errors = thicknessesOf(mesh.positions, this.#corners.points).map((thickness) =>
      Math.min(error, thickness * SHARE_OF_THICKNESS),
    );
  }

  /** Corners of the triangles so far. */
  get length(): number {
    return this.#corners.points.length;
  }

  /** Does one round. Whether there is more to do. */
  proceed(): boolean {
    const before = this.length;
    const round = new Round(this.#mesh, this.#quadrics, this.#corners);
    this.#corners = withoutSlivers(round.collapse(this.#errors, this.#pictures));
    this.#rounds++;
    return this.#rounds < MOST_ROUNDS && this.length <= before * (1 - WORTHWHILE);
  }

  /** What it has come to. */
  get result(): Simplified {
    const { points, looks } = this.#corners;
    const known = new Map<number, number>();
    const first: number[] = [];
    const indices = points.map((point, corner) => {
      const key = point * 2 ** 26 + looks[corner]!;
      const vertex = known.get(key) ?? first.length;
      if (vertex === first.length) first.push(corner);
      known.set(key, vertex);
      return vertex;
    });
    const of = (what: Uint32Array) => Uint32Array.from(first, (corner) => what[corner]!);
    return { places: of(points), looks: of(looks), indices };
  }
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

function withoutSlivers({ points, looks }: Corners): Corners {
  let length = 0;
  const [toPoints, toLooks] = [points.slice(), looks.slice()];
  for (let i = 0; i < points.length; i += 3) {
    const [a, b, c] = [points[i], points[i + 1], points[i + 2]];
    if (a === b || b === c || c === a) continue;
    for (let k = 0; k < 3; k++, length++) {
      toPoints[length] = points[i + k]!;
      toLooks[length] = looks[i + k]!;
    }
  }
  return { points: toPoints.slice(0, length), looks: toLooks.slice(0, length) };
}

const next = (corner: number) => (corner % 3 === 2 ? corner - 2 : corner + 1);
const previous = (corner: number) => (corner % 3 === 0 ? corner + 2 : corner - 1);

/** Each point falls once, or is fallen into. */
class Round {
  readonly #mesh: Simplifiable;
  readonly #quadrics: Quadrics;
  /** Written to as points fall. */
  readonly #points: Uint32Array;
  readonly #looks: Uint32Array;
  /** Corners at each point, one list after another. */
  readonly #begins: Uint32Array;
  readonly #fans: Uint32Array;

  constructor(mesh: Simplifiable, quadrics: Quadrics, { points, looks }: Corners) {
    this.#mesh = mesh;
    this.#quadrics = quadrics;
    this.#points = points.slice();
    this.#looks = looks.slice();
    const begins = new Uint32Array(mesh.positions.length / 3 + 1);
    for (const point of points) begins[point + 1]!++;
    for (let point = 1; point < begins.length; point++) begins[point]! += begins[point - 1]!;
    const ends = begins.slice();
    this.#fans = new Uint32Array(points.length);
    for (const [corner, point] of points.entries()) this.#fans[ends[point]!++] = corner;
    this.#begins = begins;
  }

  /**
   * @param errors of each point, metres
   * @param pictures lengths of them along a metre
   */
  collapse(errors: Float64Array, pictures: number): Corners {
    const count = this.#begins.length - 1;
    const into = new Int32Array(count).fill(-1);
    const costs = new Float64Array(count);
    const falling: number[] = [];
    for (let point = 0; point < count; point++) {
      for (const neighbour of this.#ways(point)) {
        const cost = this.#quadrics.cost(point, neighbour);
        if (cost > errors[point]! ** 2 || (into[point] !== -1 && cost >= costs[point]!)) continue;
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
      const heirs = this.#heirsOf(point, target);
      if (this.#spoils(point, target, heirs, SHIFT * errors[point]!, pictures)) continue;
      for (const corner of this.#at(point)) {
        this.#points[corner] = target;
        this.#looks[corner] = heirs.get(this.#looks[corner]!) ?? this.#looks[corner]!;
      }
      this.#quadrics.move(point, target);
      isDone[point] = 1;
      isDone[target] = 1;
    }
    return { points: this.#points, looks: this.#looks };
  }

  #at(point: number): Uint32Array {
    return this.#fans.subarray(this.#begins[point], this.#begins[point + 1]);
  }

  /** Points that one may fall into: all around within a surface, along its rim at one. */
  #ways(point: number): readonly number[] {
    const after: number[] = [];
    const before: number[] = [];
    for (const corner of this.#at(point)) {
      after.push(this.#points[next(corner)]!);
      before.push(this.#points[previous(corner)]!);
    }
    const isTwice = (points: readonly number[]) => new Set(points).size < points.length;
    if (isTwice(after) || isTwice(before)) return []; // three triangles at one edge
    const rim = [
      ...after.filter((neighbour) => !before.includes(neighbour)),
      ...before.filter((neighbour) => !after.includes(neighbour)),
    ];
    if (rim.length === 0) return after;
    return rim.length === 2 ? rim : [];
  }

  /** The vertices at a point that are one with a vertex of a neighbour, and that one. */
  #heirsOf(point: number, target: number): Map<number, number> {
    const heirs = new Map<number, number>();
    for (const corner of this.#at(point)) {
      const look = this.#looks[corner]!;
      for (const other of [next(corner), previous(corner)]) {
        if (this.#points[other] !== target) continue;
        const heir = this.#looks[other]!;
        if (this.#likeness(look, heir) > LEAST_TURN) heirs.set(look, heir);
      }
    }
    return heirs;
  }

  #likeness(a: number, b: number): number {
    const n = this.#mesh.normals;
    return n[3 * a]! * n[3 * b]! + n[3 * a + 1]! * n[3 * b + 1]! + n[3 * a + 2]! * n[3 * b + 2]!;
  }

  #apart(a: number, b: number): number {
    const p = this.#mesh.positions;
    return Math.hypot(
      p[3 * a]! - p[3 * b]!,
      p[3 * a + 1]! - p[3 * b + 1]!,
      p[3 * a + 2]! - p[3 * b + 2]!,
    );
  }

  /** Whether a triangle would turn over, or vanish, or what is painted there shift, beside those that have both points. */
  #spoils(
    point: number,
    target: number,
    heirs: ReadonlyMap<number, number>,
    way: number,
    pictures: number,
  ): boolean {
    const { positions: p, uvs, colors } = this.#mesh;
    const [fx, fy, fz] = [p[3 * point]!, p[3 * point + 1]!, p[3 * point + 2]!];
    const [tx, ty, tz] = [p[3 * target]!, p[3 * target + 1]!, p[3 * target + 2]!];
    for (const corner of this.#at(point)) {
      const [second, third] = [next(corner), previous(corner)];
      const [b, c] = [this.#points[second]!, this.#points[third]!];
      if (b === target || c === target || b === c) continue;
      const from = this.#looks[corner]!;
      const kept = heirs.get(from);
      if (kept === undefined && this.#apart(from, target) > way) return true;
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
      if (kept === undefined) continue;
      // Shares of the corners in the place that is given up.
      const atTarget = along / whole;
      const gx = (cy - fy) * (tz - fz) - (cz - fz) * (ty - fy);
      const gy = (cz - fz) * (tx - fx) - (cx - fx) * (tz - fz);
      const gz = (cx - fx) * (ty - fy) - (cy - fy) * (tx - fx);
      const atSecond = (gx * u + gy * v + gz * w) / whole;
      const atThird = 1 - atTarget - atSecond;
      if (Math.min(atTarget, atSecond, atThird) < -WITHIN) continue;
      const [lookB, lookC] = [this.#looks[second]!, this.#looks[third]!];
      const mixed = (of: ArrayLike<number>, size: number, k: number) =>
        Math.abs(
          atTarget * of[kept * size + k]! +
            atSecond * of[lookB * size + k]! +
            atThird * of[lookC * size + k]! -
            of[from * size + k]!,
        );
      if (uvs && mixed(uvs, 2, 0) + mixed(uvs, 2, 1) > way * pictures) return true;
      if (colors && mixed(colors, 4, 0) > SHADE) return true;
    }
    return false;
  }
}
