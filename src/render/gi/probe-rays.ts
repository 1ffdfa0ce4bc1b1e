import type { Model, Part } from "../../assets/model.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import type { CollisionMesh, RayHit } from "../../world/room/collision-mesh.js";
import { interiorBounds } from "./interior-bounds.js";
import { octahedral, rayDirections } from "./ray-directions.js";

/** Resolution of an irradiance volume. */
export interface ProbeDetail {
  /** Probes along x, y, z. */
  readonly probes: readonly [number, number, number];
  /** Distance of the outermost probes from the room's inner surfaces, cells: fitted to a path tracer's rooms. */
  readonly inset: number;
  /** Rays along an edge of the octahedral map of all directions. */
  readonly rays: number;
}

/** Resolution of indirect light. */
export interface IndirectDetail extends ProbeDetail {
  /** Surfels along an edge of the cube around the flame, and as how many of them the probes gather each group. */
  readonly surfels: number;
  readonly surfelGroup: number;
  readonly bounces: number;
  /** Whether surfaces mirror the surfels in motion too. */
  readonly mirrorsInMotion: boolean;
}

/**
 * Probes and the hits of their rays, for the shaders that include `lib/irradiance-volume.glsl`.
 *
 * Every probe is a tile: those of one plane of constant z side by side along x, row by row along y.
 */
export interface ProbeRays {
  /** (x, y, z, 1) of each probe, metres; the last is 0 for a probe inside a solid. */
  readonly positions: Float32Array;
  /** Normal on the ray's side, and distance, metres: 0 for a miss or a back face. */
  readonly hits: Float32Array;
  /** Mean and deviation of the distance in each direction, metres. Tiles of `PROBE_DEPTH_EDGE` texels. */
  readonly depths: Float32Array;
  /** Texel of each hit's ray, and texture coordinates there: x, y, u, v. Sorted by part. */
  readonly hitUvs: Float32Array;
  /** Ranges of `hitUvs`, one for each part of the model. */
  readonly runs: readonly {
    readonly part: number;
    readonly first: number;
    readonly count: number;
  }[];
}

/** Edge of a probe's depth map, texels: sixteen, and a border of one that repeats those across the seam. */
export const PROBE_DEPTH_EDGE = 18;
/** Edge of a probe's irradiance map, texels, from the middle of the first to that of the last. */
export const IRRADIANCE_TEXELS = 7;
/** Largest depth, metres. */
const FARTHEST = 60;
/** Exponent of the cosine lobe that depths are averaged over, for each ray: so wide that it always has several. */
const LOBE_EXPONENT = 1.2;
/** Edge of the map of rays that test whether a point is inside a solid. */
const INSIDE_TEST_RAYS = 4;
/** A point is inside a solid if this share of those rays hits back faces. */
const INSIDE_SHARE = 0.2;
/** Offsets tried for a probe inside a solid, in cells, nearest first. */
const RELOCATIONS: readonly Vec3[] = relocations();

/** Corners of a cell of the grid, by the parity of x, y and z. */
const CORNERS = [...Array(8).keys()];

const traces = new WeakMap<CollisionMesh, Map<string, ProbeTrace>>();

/** What traces the rays of all probes, all at once or a few at a time. Cached by room and resolution. */
export function probeTraceOf(
  collision: CollisionMesh,
  model: Model,
  { probes, inset, rays }: ProbeDetail,
): ProbeTrace {
  const ofMesh = traces.get(collision) ?? new Map<string, ProbeTrace>();
  traces.set(collision, ofMesh);
  const key = JSON.stringify([probes, inset, rays]);
  const trace = ofMesh.get(key) ?? new ProbeTrace(collision, model, { probes, inset, rays });
  ofMesh.set(key, trace);
  return trace;
}

/** Ray tracing from the probes, in progress. */
class ProbeTrace {
  readonly #collision: CollisionMesh;
  readonly #parts: readonly Part[];
  /** Index of the first triangle of each part. */
  readonly #firsts: readonly number[];
  readonly #detail: ProbeDetail;
  readonly #bounds: Bounds;
  readonly #insideTestDirections = octahedral(INSIDE_TEST_RAYS, INSIDE_TEST_RAYS, 0);
  /** Of the rays, by the corner of a cell that the probe is. */
  readonly #bundles: readonly { readonly directions: readonly Vec3[]; readonly lobes: Lobes }[];
  readonly #positions: Float32Array;
  readonly #hits: Float32Array;
  readonly #depths: Float32Array;
  readonly #hitUvs: readonly number[][];
  #traced = 0;
  #result: ProbeRays | null = null;

  constructor(collision: CollisionMesh, model: Model, detail: ProbeDetail) {
    const { parts } = model;
    this.#collision = collision;
    this.#parts = parts;
    this.#detail = detail;
    this.#bounds = interiorBounds(collision, model);
    let first = 0;
    this.#firsts = parts.map(({ indices }) => {
      first += Math.floor(indices.length / 3);
      return first - Math.floor(indices.length / 3);
    });
    const count = this.#count;
    this.#bundles = CORNERS.map((corner) => {
      const directions = rayDirections(detail.rays, corner);
      return { directions, lobes: lobesOf(directions) };
    });
    this.#positions = new Float32Array(count * 4);
    this.#hits = new Float32Array(count * detail.rays ** 2 * 4);
    this.#depths = new Float32Array(count * PROBE_DEPTH_EDGE ** 2 * 2);
    this.#hitUvs = parts.map(() => []);
  }

  get #count(): number {
    return this.#detail.probes.reduce((product, along) => product * along, 1);
  }

  /** Traces the rays of the next few probes. True when all are traced. */
  proceed(probes: number): boolean {
    const end = Math.min(this.#traced + probes, this.#count);
    while (this.#traced < end) this.#trace(this.#traced++);
    return this.#traced === this.#count;
  }

  finish(): ProbeRays {
    this.proceed(this.#count);
    this.#result ??= this.#collect();
    return this.#result;
  }

  #trace(tile: number): void {
    const { probes, rays } = this.#detail;
    const [columns, rows] = probes;
    const width = columns * rays;
    const column = tile % columns;
    const row = Math.floor(tile / columns);
    const plane = Math.floor(row / rows);
    const position = this.#relocate(column, row % rows, plane);
    if (!position) return;
    const corner = (column & 1) + 2 * ((row % rows) & 1) + 4 * (plane & 1);
    const { directions, lobes } = this.#bundles[corner]!;
    this.#positions.set(position, tile * 4);
    this.#positions[tile * 4 + 3] = 1;
    const depths = new Float32Array(directions.length);
    for (const [ray, direction] of directions.entries()) {
      const hit = this.#collision.raycast(position, direction, Infinity);
      depths[ray] = hit ? Math.min(hit.distance, FARTHEST) : FARTHEST;
      if (!hit || this.#isInside(hit)) continue;
      const x = column * rays + (ray % rays);
      const y = row * rays + Math.floor(ray / rays);
      const to = (y * width + x) * 4;
      this.#hits.set(hit.normal, to);
      this.#hits[to + 3] = hit.distance;
      const part = this.#partOf(hit.triangle);
      this.#hitUvs[part]?.push(x, y, ...this.#uvOf(hit, part));
    }
    averageDepths(depths, lobes, this.#depths, column, row, columns);
  }

  #collect(): ProbeRays {
    const hitUvs = new Float32Array(this.#hitUvs.reduce((sum, { length }) => sum + length, 0));
    const runs: { part: number; first: number; count: number }[] = [];
    let first = 0;
    for (const [part, uvs] of this.#hitUvs.entries()) {
      if (uvs.length > 0) runs.push({ part, first: first / 4, count: uvs.length / 4 });
      hitUvs.set(uvs, first);
      first += uvs.length;
    }
    const [positions, hits, depths] = [this.#positions, this.#hits, this.#depths];
    return { positions, hits, depths, hitUvs, runs };
  }

  /** Position of a probe: its place in the grid, or the nearest point tried that is outside all solids. */
  #relocate(i: number, j: number, k: number): Vec3 | null {
    const { min, max } = this.#bounds;
    const { probes, inset } = this.#detail;
    const cell = [i, j, k] as const;
    for (const offset of RELOCATIONS) {
      const position = [0, 1, 2].map((axis) => {
        const low = min[axis] ?? 0;
        const cells = (probes[axis] ?? 1) - 1 + 2 * inset;
        const place = (cell[axis] ?? 0) + inset + (offset[axis] ?? 0);
        const margin = 0.05;
        const within = Math.min(Math.max(place, margin), cells - margin);
        return low + (within * ((max[axis] ?? 0) - low)) / cells;
      }) as Vec3;
      let backFaces = 0;
      for (const direction of this.#insideTestDirections) {
        const hit = this.#collision.raycast(position, direction, Infinity);
        if (hit && this.#isInside(hit)) backFaces++;
      }
      if (backFaces < INSIDE_SHARE * this.#insideTestDirections.length) return position;
    }
    return null;
  }

  /** Index of the part that a triangle of the room belongs to. */
  #partOf(triangle: number): number {
    let part = this.#firsts.length - 1;
    while (part > 0 && this.#firsts[part]! > triangle) part--;
    return part;
  }

  /** Whether a ray has met the inside of a solid. */
  #isInside({ triangle, isBack }: RayHit): boolean {
    return isBack && !this.#parts[this.#partOf(triangle)]!.material.isDoubleSided;
  }

  /** Texture coordinates of a hit. */
  #uvOf({ triangle, u, v }: RayHit, part: number): [number, number] {
    const { indices, uvs } = this.#parts[part]!;
    const first = (triangle - this.#firsts[part]!) * 3;
    const [a, b, c] = [indices[first]!, indices[first + 1]!, indices[first + 2]!];
    const mix = (axis: 0 | 1) =>
      (1 - u - v) * uvs[a * 2 + axis]! + u * uvs[b * 2 + axis]! + v * uvs[c * 2 + axis]!;
    return [mix(0), mix(1)];
  }
}

/** For each texel of a depth map the rays in its lobe, and their weights. */
type Lobes = readonly { readonly rays: Uint16Array; readonly weights: Float32Array }[];

function lobesOf(directions: readonly Vec3[]): Lobes {
  const exponent = LOBE_EXPONENT * directions.length;
  // Of rays beyond, a thousandth of the lobe at most.
  const leastCosine = 1e-4 ** (1 / exponent);
  return octahedral(PROBE_DEPTH_EDGE, PROBE_DEPTH_EDGE - 2, 1).map((texel) => {
    const rays: number[] = [];
    const weights: number[] = [];
    let sum = 0;
    for (let ray = 0; ray < directions.length; ray++) {
      const direction = directions[ray]!;
      const cosine = texel[0] * direction[0] + texel[1] * direction[1] + texel[2] * direction[2];
      if (cosine < leastCosine) continue;
      const weight = cosine ** exponent;
      rays.push(ray);
      weights.push(weight);
      sum += weight;
    }
    return {
      rays: Uint16Array.from(rays),
      weights: Float32Array.from(weights, (weight) => weight / sum),
    };
  });
}

function averageDepths(
  rayDepths: Float32Array,
  lobes: Lobes,
  depths: Float32Array,
  column: number,
  row: number,
  tiles: number,
): void {
  for (const [texel, { rays, weights }] of lobes.entries()) {
    let mean = 0;
    let square = 0;
    for (let i = 0; i < rays.length; i++) {
      const depth = rayDepths[rays[i]!]!;
      mean += weights[i]! * depth;
      square += weights[i]! * depth * depth;
    }
    const x = column * PROBE_DEPTH_EDGE + (texel % PROBE_DEPTH_EDGE);
    const y = row * PROBE_DEPTH_EDGE + Math.floor(texel / PROBE_DEPTH_EDGE);
    const to = (y * tiles * PROBE_DEPTH_EDGE + x) * 2;
    depths[to] = mean;
    depths[to + 1] = Math.sqrt(Math.max(square - mean * mean, 0));
  }
}

function relocations(): Vec3[] {
  const steps = [-0.45, -0.25, 0, 0.25, 0.45];
  const all = steps.flatMap((x) => steps.flatMap((y) => steps.map((z): Vec3 => [x, y, z])));
  return all.sort((a, b) => Math.hypot(...a) - Math.hypot(...b));
}
