import type { Model, Part } from "../../assets/model.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import type { CollisionMesh, RayHit } from "../../world/room/collision-mesh.js";

/** A grid of probes over a room, and how much of it each sees. */
export interface ProbeDetail {
  /** Probes along x, y, z. */
  readonly probes: readonly [number, number, number];
  /** Rays along an edge of the octahedral map of all directions. */
  readonly rays: number;
}

/**
 * What the probes see, for the shaders that include `lib/irradiance-volume.glsl`.
 *
 * Every probe is a tile: those of one plane of constant z side by side along x, row by row along y.
 */
export interface ProbeRays {
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

const known = new WeakMap<CollisionMesh, Map<string, ProbeTrace>>();

/** Looks around from every probe. The room remembers, for the next renderer that asks. */
export function traceProbes(
  collision: CollisionMesh,
  model: Model,
  detail: ProbeDetail,
): ProbeRays {
  return probeTraceOf(collision, model, detail).finish();
}

/**
 * The same, a few probes at a time.
 *
 * @returns whether all of them are done
 */
export function traceProbesIncrementally(
  collision: CollisionMesh,
  model: Model,
  detail: ProbeDetail,
  probes: number,
): boolean {
  return probeTraceOf(collision, model, detail).proceed(probes);
}

function probeTraceOf(
  collision: CollisionMesh,
  model: Model,
  { probes, rays }: ProbeDetail,
): ProbeTrace {
  const memory = known.get(collision) ?? new Map<string, ProbeTrace>();
  known.set(collision, memory);
  const key = JSON.stringify([probes, rays]);
  const survey = memory.get(key) ?? new ProbeTrace(collision, model, { probes, rays });
  memory.set(key, survey);
  return survey;
}

class ProbeTrace {
  readonly #collision: CollisionMesh;
  readonly #parts: readonly Part[];
  /** Number of the first triangle of each part. */
  readonly #firsts: readonly number[];
  readonly #detail: ProbeDetail;
  readonly #bounds: Bounds;
  readonly #hit: RayHit = { distance: 0, triangle: 0, normal: [0, 0, 0] };
  readonly #met = new HitAttributes();
  readonly #feelers = octahedral(FEELERS, FEELERS, 0);
  readonly #directions: readonly Vec3[];
  readonly #lobes: Lobes;
  readonly #places: Float32Array;
  readonly #hits: Float32Array;
  readonly #distances: Float32Array;
  readonly #hues: readonly number[][];
  /** Probes that are done. */
  #done = 0;
  #sights: ProbeRays | null = null;

  constructor(collision: CollisionMesh, { parts, bounds }: Model, detail: ProbeDetail) {
    this.#collision = collision;
    this.#parts = parts;
    this.#detail = detail;
    this.#bounds = { min: [...bounds.min], max: [...bounds.max] };
    let first = 0;
    this.#firsts = parts.map(({ indices }) => {
      first += Math.floor(indices.length / 3);
      return first - Math.floor(indices.length / 3);
    });
    const count = this.#count;
    this.#directions = octahedral(detail.rays, detail.rays, 0);
    this.#lobes = lobesOf(this.#directions);
    this.#places = new Float32Array(count * 4);
    this.#hits = new Float32Array(count * this.#directions.length * 4);
    this.#distances = new Float32Array(count * SIGHT * SIGHT * 2);
    this.#hues = parts.map(() => []);
  }

  get #count(): number {
    return this.#detail.probes.reduce((product, along) => product * along, 1);
  }

  proceed(probes: number): boolean {
    const end = Math.min(this.#done + probes, this.#count);
    while (this.#done < end) this.#look(this.#done++);
    return this.#done === this.#count;
  }

  finish(): ProbeRays {
    this.proceed(this.#count);
    this.#sights ??= this.#collect();
    return this.#sights;
  }

  /** From one probe. */
  #look(tile: number): void {
    const { probes, rays } = this.#detail;
    const [columns, , planes] = probes;
    const width = columns * planes * rays;
    const column = tile % (columns * planes);
    const row = Math.floor(tile / (columns * planes));
    const place = this.#open(column % columns, row, Math.floor(column / columns));
    if (!place) return;
    this.#places.set(place, tile * 4);
    this.#places[tile * 4 + 3] = 1;
    const seen = new Float32Array(this.#directions.length);
    for (const [ray, direction] of this.#directions.entries()) {
      const hit = this.#cast(place, direction);
      seen[ray] = hit ? Math.min(hit.distance, FARTHEST) : FARTHEST;
      if (!hit || this.#met.isBack) continue;
      const x = column * rays + (ray % rays);
      const y = row * rays + Math.floor(ray / rays);
      const to = (y * width + x) * 4;
      this.#hits.set(hit.normal, to);
      this.#hits[to + 3] = hit.distance;
      this.#hues[this.#met.part]?.push(x, y, this.#met.u, this.#met.v);
    }
    average(seen, this.#lobes, this.#distances, column, row, columns * planes);
  }

  #collect(): ProbeRays {
    const length = this.#hues.reduce((sum, hue) => sum + hue.length, 0);
    const hues = new Float32Array(length);
    const runs: { part: number; first: number; count: number }[] = [];
    let first = 0;
    for (const [part, hue] of this.#hues.entries()) {
      if (hue.length > 0) runs.push({ part, first: first / 4, count: hue.length / 4 });
      hues.set(hue, first);
      first += hue.length;
    }
    return { places: this.#places, hits: this.#hits, distances: this.#distances, hues, runs };
  }

  /** The place of a probe, or one near by that is inside of nothing. */
  #open(i: number, j: number, k: number): Vec3 | null {
    const { min, max } = this.#bounds;
    const cell = [i, j, k] as const;
    for (const step of NEARBY) {
      const place = [0, 1, 2].map((axis) => {
        const low = min[axis] ?? 0;
        const size = ((max[axis] ?? 0) - low) / (this.#detail.probes[axis] ?? 1);
        return low + ((cell[axis] ?? 0) + 0.5 + (step[axis] ?? 0)) * size;
      }) as Vec3;
      let backs = 0;
      for (const direction of this.#feelers) {
        if (this.#cast(place, direction) && this.#met.isBack) backs++;
      }
      if (backs < BURIED * this.#feelers.length) return place;
    }
    return null;
  }

  /** What is nearest along a ray; `#met` then says more of it. */
  #cast(place: Vec3, direction: Vec3): RayHit | null {
    const hit = this.#collision.raycast(place, direction, Infinity, this.#hit);
    if (!hit) return null;
    let number = this.#firsts.length - 1;
    while (number > 0 && this.#firsts[number]! > hit.triangle) number--;
    this.#met.part = number;
    const first = (hit.triangle - this.#firsts[number]!) * 3;
    this.#met.look(this.#parts[number]!, first, place, direction, hit.distance);
    return hit;
  }
}

/** What a ray has met of a part. One for all rays: there are a hundred thousand of them. */
class HitAttributes {
  /** Which of the model's parts. */
  part = 0;
  /** Whether it is the back of something that has no other side. */
  isBack = false;
  /** Place on the material's maps. */
  u = 0;
  v = 0;

  /** @param first of the triangle's indices */
  look(part: Part, first: number, place: Vec3, direction: Vec3, distance: number): void {
    const { positions: p, uvs, indices, material } = part;
    const cornerA = indices[first]!;
    const cornerB = indices[first + 1]!;
    const cornerC = indices[first + 2]!;
    const a = cornerA * 3;
    const b = cornerB * 3;
    const c = cornerC * 3;
    const ex = p[b]! - p[a]!;
    const ey = p[b + 1]! - p[a + 1]!;
    const ez = p[b + 2]! - p[a + 2]!;
    const fx = p[c]! - p[a]!;
    const fy = p[c + 1]! - p[a + 1]!;
    const fz = p[c + 2]! - p[a + 2]!;
    const nx = ey * fz - ez * fy;
    const ny = ez * fx - ex * fz;
    const nz = ex * fy - ey * fx;
    const turn = nx * direction[0] + ny * direction[1] + nz * direction[2];
    this.isBack = !material.isDoubleSided && turn > 0;
    // Shares of the corners in the point between them.
    const x = place[0] + distance * direction[0] - p[a]!;
    const y = place[1] + distance * direction[1] - p[a + 1]!;
    const z = place[2] + distance * direction[2] - p[a + 2]!;
    const scale = 1 / Math.max(nx * nx + ny * ny + nz * nz, 1e-30);
    const ofB = ((y * fz - z * fy) * nx + (z * fx - x * fz) * ny + (x * fy - y * fx) * nz) * scale;
    const ofC = ((ey * z - ez * y) * nx + (ez * x - ex * z) * ny + (ex * y - ey * x) * nz) * scale;
    const ofA = 1 - ofB - ofC;
    this.u = ofA * uvs[cornerA * 2]! + ofB * uvs[cornerB * 2]! + ofC * uvs[cornerC * 2]!;
    this.v =
      ofA * uvs[cornerA * 2 + 1]! + ofB * uvs[cornerB * 2 + 1]! + ofC * uvs[cornerC * 2 + 1]!;
  }
}

/**
 * Directions of an octahedral map's texels (Cigolle et al. 2014, "A ProbeTrace of Efficient Representations
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
