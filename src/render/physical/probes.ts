import type { Model, Part } from "../../assets/model.js";
import type { Bounds, Vec3 } from "../../world/bounds.js";
import type { Hit, Solid } from "../../world/solid.js";

/** A grid of probes over a room, and how much of it each sees. */
export interface ProbeDetail {
  /** Probes along x, y, z. */
  readonly probes: readonly [number, number, number];
  /** Rays along an edge of the octahedral map of all directions. */
  readonly rays: number;
}

/**
 * What the probes see, for the shaders that include `physical/volume.glsl`.
 *
 * Every probe is a tile: those of one plane of constant z side by side along x, row by row along y.
 */
export interface Sights {
  /** (x, y, z, 1) of each probe, metres; the last is 0 where there was no place in the open. */
  readonly places: Float32Array;
  /** What each ray meets: normal on the ray's side; distance, metres, 0 for nothing that sends light. */
  readonly hits: Float32Array;
  /** Mean and deviation of the distance in each direction, metres. Tiles of `SIGHT` texels. */
  readonly distances: Float32Array;
  /** Texel and place on the material's maps of each hit: x, y, u, v. Those of one part follow another. */
  readonly hues: Float32Array;
  /** Numbers of hues, for each part of the model. */
  readonly runs: readonly {
    readonly part: number;
    readonly first: number;
    readonly count: number;
  }[];
}

/** Edge of a probe's map of distances: eight texels, and a seam of one that repeats what lies across. */
export const SIGHT = 10;
/** Edge of its map of irradiance, the seam counted. */
export const LIT = 8;
/** Texels of its coefficients, side by side. */
export const TILE = 3;
/** As far as a probe tells distances apart, metres. */
const FARTHEST = 60;
/** Sharpness of the lobe that distances are averaged over: a power of the cosine. */
const LOBE = 80;
/** Rays that tell whether a place is inside of something, along an edge of their map. */
const FEELERS = 4;
/** A place is buried if this share of what it sees turns its back. */
const BURIED = 0.2;
/** Where a buried probe looks for the open, in cells from its own place, nearest first. */
const NEARBY: readonly Vec3[] = nearby();

const known = new WeakMap<Solid, Map<string, Sights>>();

/** Looks around from every probe. The room remembers, for the next renderer that asks. */
export function lookAround(solid: Solid, model: Model, detail: ProbeDetail): Sights {
  const memory = known.get(solid) ?? new Map<string, Sights>();
  known.set(solid, memory);
  const key = JSON.stringify(detail);
  const before = memory.get(key);
  if (before) return before;
  const sights = new Survey(solid, model, detail).sights();
  memory.set(key, sights);
  return sights;
}

class Survey {
  readonly #solid: Solid;
  readonly #parts: readonly Part[];
  /** Number of the first triangle of each part. */
  readonly #firsts: readonly number[];
  readonly #detail: ProbeDetail;
  readonly #bounds: Bounds;
  readonly #hit: Hit = { distance: 0, triangle: 0, normal: [0, 0, 0] };

  constructor(solid: Solid, { parts, bounds }: Model, detail: ProbeDetail) {
    this.#solid = solid;
    this.#parts = parts;
    this.#detail = detail;
    this.#bounds = { min: [...bounds.min], max: [...bounds.max] };
    let first = 0;
    this.#firsts = parts.map(({ indices }) => {
      first += Math.floor(indices.length / 3);
      return first - Math.floor(indices.length / 3);
    });
  }

  sights(): Sights {
    const { probes, rays } = this.#detail;
    const [columns, rows, planes] = probes;
    const directions = octahedral(rays, rays, 0);
    const count = columns * rows * planes;
    const width = columns * planes * rays;
    const places = new Float32Array(count * 4);
    const hits = new Float32Array(count * directions.length * 4);
    const distances = new Float32Array(count * SIGHT * SIGHT * 2);
    const hues: number[][] = this.#parts.map(() => []);
    const lobes = lobesOf(directions);
    const seen = new Float32Array(directions.length);
    for (let tile = 0; tile < count; tile++) {
      const column = tile % (columns * planes);
      const row = Math.floor(tile / (columns * planes));
      const place = this.#open(column % columns, row, Math.floor(column / columns));
      places.set(place ? [...place, 1] : [0, 0, 0, 0], tile * 4);
      if (!place) continue;
      for (const [ray, direction] of directions.entries()) {
        const x = column * rays + (ray % rays);
        const y = row * rays + Math.floor(ray / rays);
        const hit = this.#solid.raycast(place, direction, Infinity, this.#hit);
        seen[ray] = Math.min(hit?.distance ?? FARTHEST, FARTHEST);
        if (!hit) continue;
        this.#note(hit, place, direction, hits, (y * width + x) * 4, hues, x, y);
      }
      average(seen, lobes, distances, column, row, columns * planes);
    }
    const runs: { part: number; first: number; count: number }[] = [];
    let first = 0;
    for (const [part, { length }] of hues.entries()) {
      if (length > 0) runs.push({ part, first, count: length / 4 });
      first += length / 4;
    }
    return { places, hits, distances, hues: Float32Array.from(hues.flat()), runs };
  }

  /** The place of a probe, or one near by that is inside of nothing. */
  #open(i: number, j: number, k: number): Vec3 | null {
    const { min, max } = this.#bounds;
    const cell = [i, j, k] as const;
    const feelers = octahedral(FEELERS, FEELERS, 0);
    for (const step of NEARBY) {
      const place = [0, 1, 2].map((axis) => {
        const low = min[axis] ?? 0;
        const size = ((max[axis] ?? 0) - low) / (this.#detail.probes[axis] ?? 1);
        return low + ((cell[axis] ?? 0) + 0.5 + (step[axis] ?? 0)) * size;
      }) as Vec3;
      let backs = 0;
      for (const direction of feelers) {
        const hit = this.#solid.raycast(place, direction, Infinity, this.#hit);
        if (hit && this.#isBack(hit, direction)) backs++;
      }
      if (backs < BURIED * feelers.length) return place;
    }
    return null;
  }

  #partOf(triangle: number): number {
    let part = this.#firsts.length - 1;
    while (part > 0 && (this.#firsts[part] ?? 0) > triangle) part--;
    return part;
  }

  /** Whether a ray met the back of something that has no other side. */
  #isBack({ triangle }: Hit, [dx, dy, dz]: Vec3): boolean {
    const number = this.#partOf(triangle);
    const part = this.#parts[number];
    if (!part || part.material.isDoubleSided) return false;
    const corner = (n: number) =>
      (part.indices[(triangle - (this.#firsts[number] ?? 0)) * 3 + n] ?? 0) * 3;
    const [a, b, c] = [corner(0), corner(1), corner(2)];
    const p = part.positions;
    const ex = p[b]! - p[a]!;
    const ey = p[b + 1]! - p[a + 1]!;
    const ez = p[b + 2]! - p[a + 2]!;
    const fx = p[c]! - p[a]!;
    const fy = p[c + 1]! - p[a + 1]!;
    const fz = p[c + 2]! - p[a + 2]!;
    return (ey * fz - ez * fy) * dx + (ez * fx - ex * fz) * dy + (ex * fy - ey * fx) * dz > 0;
  }

  #note(
    hit: Hit,
    place: Vec3,
    direction: Vec3,
    hits: Float32Array,
    to: number,
    hues: number[][],
    x: number,
    y: number,
  ): void {
    if (this.#isBack(hit, direction)) return;
    hits.set(hit.normal, to);
    hits[to + 3] = hit.distance;
    const number = this.#partOf(hit.triangle);
    const part = this.#parts[number];
    if (!part) return;
    const { positions: p, uvs, indices } = part;
    const first = (hit.triangle - (this.#firsts[number] ?? 0)) * 3;
    const corners = [
      indices[first] ?? 0,
      indices[first + 1] ?? 0,
      indices[first + 2] ?? 0,
    ] as const;
    const at = [0, 1, 2].map(
      (axis) => (place[axis] ?? 0) + hit.distance * (direction[axis] ?? 0),
    ) as Vec3;
    const shares = barycentric(p, corners, at);
    let u = 0;
    let v = 0;
    for (const [n, corner] of corners.entries()) {
      u += (shares[n] ?? 0) * (uvs[corner * 2] ?? 0);
      v += (shares[n] ?? 0) * (uvs[corner * 2 + 1] ?? 0);
    }
    hues[number]?.push(x, y, u, v);
  }
}

/** Shares of three corners in a point between them. */
function barycentric(
  p: Float32Array,
  [a, b, c]: readonly [number, number, number],
  at: Vec3,
): Vec3 {
  const edge = (from: number, axis: number) => (p[from * 3 + axis] ?? 0) - (p[a * 3 + axis] ?? 0);
  let ee = 0;
  let ef = 0;
  let ff = 0;
  let de = 0;
  let df = 0;
  for (const axis of [0, 1, 2] as const) {
    const e = edge(b, axis);
    const f = edge(c, axis);
    const d = at[axis] - (p[a * 3 + axis] ?? 0);
    ee += e * e;
    ef += e * f;
    ff += f * f;
    de += d * e;
    df += d * f;
  }
  const scale = 1 / Math.max(ee * ff - ef * ef, 1e-30);
  const v = (ff * de - ef * df) * scale;
  const w = (ee * df - ef * de) * scale;
  return [1 - v - w, v, w];
}

/**
 * Directions of an octahedral map's texels (Cigolle et al. 2014, "A Survey of Efficient Representations
 * for Independent Unit Vectors"), row by row; with `seam` texels more on each side, that go on across it.
 */
export function octahedral(width: number, size: number, seam: number): Vec3[] {
  return Array.from({ length: width * width }, (_, n) => {
    let u = (((n % width) + 0.5 - seam) / size) * 2 - 1;
    let v = ((Math.floor(n / width) + 0.5 - seam) / size) * 2 - 1;
    if (Math.abs(u) > 1) [u, v] = [Math.sign(u) * 2 - u, -v];
    if (Math.abs(v) > 1) [u, v] = [-u, Math.sign(v) * 2 - v];
    const y = 1 - Math.abs(u) - Math.abs(v);
    const x = y < 0 ? (1 - Math.abs(v)) * (u < 0 ? -1 : 1) : u;
    const z = y < 0 ? (1 - Math.abs(u)) * (v < 0 ? -1 : 1) : v;
    const length = Math.hypot(x, y, z);
    return [x / length, y / length, z / length];
  });
}

/** For each texel of a map of distances the rays that count there, and how much. */
type Lobes = readonly { readonly rays: Uint16Array; readonly shares: Float32Array }[];

function lobesOf(directions: readonly Vec3[]): Lobes {
  return octahedral(SIGHT, SIGHT - 2, 1).map(([x, y, z]) => {
    const shares = directions.map(([dx, dy, dz]) => Math.max(x * dx + y * dy + z * dz, 0) ** LOBE);
    const sum = shares.reduce((total, share) => total + share, 0);
    const rays = [...shares.keys()].filter((ray) => (shares[ray] ?? 0) > 1e-3 * sum);
    const kept = rays.reduce((total, ray) => total + (shares[ray] ?? 0), 0);
    return {
      rays: Uint16Array.from(rays),
      shares: Float32Array.from(rays, (ray) => (shares[ray] ?? 0) / kept),
    };
  });
}

function average(
  seen: Float32Array,
  lobes: Lobes,
  distances: Float32Array,
  column: number,
  row: number,
  tiles: number,
): void {
  for (const [texel, { rays, shares }] of lobes.entries()) {
    let mean = 0;
    let square = 0;
    for (let i = 0; i < rays.length; i++) {
      const distance = seen[rays[i]!]!;
      mean += shares[i]! * distance;
      square += shares[i]! * distance * distance;
    }
    const x = column * SIGHT + (texel % SIGHT);
    const y = row * SIGHT + Math.floor(texel / SIGHT);
    const to = (y * tiles * SIGHT + x) * 2;
    distances[to] = mean;
    distances[to + 1] = Math.sqrt(Math.max(square - mean * mean, 0));
  }
}

function nearby(): Vec3[] {
  const steps = [-0.45, -0.25, 0, 0.25, 0.45];
  const all = steps.flatMap((x) => steps.flatMap((y) => steps.map((z): Vec3 => [x, y, z])));
  return all.sort((a, b) => Math.hypot(...a) - Math.hypot(...b));
}
