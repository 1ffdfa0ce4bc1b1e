import type { Model, Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";
import type { CollisionMesh, RayHit } from "../../world/room/collision-mesh.js";
import type { Steps } from "../../world/steps.js";
import { partsOfTriangles } from "../mesh/triangles.js";
import { type Task, type Tasks, taskOf } from "../task.js";
import { type InteriorBounds, interiorBounds, turned } from "./interior-bounds.js";
import { lightRays } from "./light-rays.js";
import { octahedral, rayDirections } from "./ray-directions.js";

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
  /** Whether a step of a capture draws a band of a pass, not all of it. A face of the surfel cube is a step in both. */
  readonly isBanded: boolean;
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
/**
 * Exponent of the cosine lobe that depths are averaged over: 7 degrees to half of its height. In narrower ones a depth
 * comes from a ray or two, and the visibility of a probe past an edge changes within centimetres of a wall.
 */
const LOBE_EXPONENT = 86;
/** Edge of the map of rays that test whether a point is inside a solid. */
const INSIDE_TEST_RAYS = 4;
/** A point is inside a solid if this share of those rays hits back faces. */
const INSIDE_SHARE = 0.2;
/** Offsets tried for a probe inside a solid, in cells, nearest first. */
const RELOCATIONS: readonly Vec3[] = relocations();

/** Corners of a cell of the grid, by the parity of x, y and z. */
const CORNERS = [...Array(8).keys()];

const traces: Tasks<CollisionMesh, ProbeRays> = new WeakMap();

/** Ray tracing from the probes, a probe in each step: once for each room and resolution. */
export function probeTraceOf(
  collision: CollisionMesh,
  model: Model,
  { probes, inset, rays }: ProbeDetail,
): Task<ProbeRays> {
  const detail = { probes, inset, rays };
  return taskOf(traces, collision, detail, () => trace(collision, model, detail));
}

function* trace(collision: CollisionMesh, model: Model, detail: ProbeDetail): Steps<ProbeRays> {
  const { probes, rays } = detail;
  const { isInside, partOf, uvOf } = hitsOn(model.parts);
  const bounds = interiorBounds(collision, model);
  const light = lightRays(collision, model.parts);
  const insideTestDirections = octahedral(INSIDE_TEST_RAYS, INSIDE_TEST_RAYS, 0);
  const isOutside = (position: Vec3) => {
    let backFaces = 0;
    for (const direction of insideTestDirections) {
      const hit = light.raycast(position, direction, Infinity);
      if (hit && isInside(hit)) backFaces++;
    }
    return backFaces < INSIDE_SHARE * insideTestDirections.length;
  };
  const bundles = CORNERS.map((corner) => {
    const directions = rayDirections(rays, corner);
    return { directions, lobes: lobesOf(directions) };
  });
  const [columns, rows, planes] = probes;
  const count = columns * rows * planes;
  const positions = new Float32Array(count * 4);
  const hits = new Float32Array(count * rays ** 2 * 4);
  const depths = new Float32Array(count * PROBE_DEPTH_EDGE ** 2 * 2);
  const uvsOfParts = model.parts.map((): number[] => []);
  for (let tile = 0; tile < count; tile++) {
    if (tile > 0) yield;
    const column = tile % columns;
    const row = Math.floor(tile / columns);
    const plane = Math.floor(row / rows);
    const place = (offset: Vec3) => placeOf([column, row % rows, plane], offset, bounds, detail);
    const offset = RELOCATIONS.find((offset) => isOutside(place(offset)));
    if (!offset) continue;
    const position = place(offset);
    const corner = (column & 1) + 2 * ((row % rows) & 1) + 4 * (plane & 1);
    const { directions, lobes } = bundles[corner]!;
    positions.set([...position, 1], tile * 4);
    const rayDepths = new Float32Array(directions.length);
    for (const [ray, direction] of directions.entries()) {
      const hit = light.raycast(position, direction, Infinity);
      rayDepths[ray] = hit ? Math.min(hit.distance, FARTHEST) : FARTHEST;
      if (!hit || isInside(hit)) continue;
      const x = column * rays + (ray % rays);
      const y = row * rays + Math.floor(ray / rays);
      hits.set([...hit.normal, hit.distance], (y * columns * rays + x) * 4);
      uvsOfParts[partOf(hit)]!.push(x, y, ...uvOf(hit));
    }
    averageDepths(rayDepths, lobes, depths, column, row, columns);
  }
  const hitUvs = new Float32Array(uvsOfParts.reduce((sum, { length }) => sum + length, 0));
  const runs: { part: number; first: number; count: number }[] = [];
  let first = 0;
  for (const [part, uvs] of uvsOfParts.entries()) {
    if (uvs.length > 0) runs.push({ part, first: first / 4, count: uvs.length / 4 });
    hitUvs.set(uvs, first);
    first += uvs.length;
  }
  return { positions, hits, depths, hitUvs, runs };
}

/** Place of a probe in the grid, moved by an offset in cells. */
function placeOf(
  cell: Vec3,
  offset: Vec3,
  { min, max, yaw }: InteriorBounds,
  detail: ProbeDetail,
): Vec3 {
  const margin = 0.05;
  const inRoom = [0, 1, 2].map((axis) => {
    const low = min[axis]!;
    const cells = detail.probes[axis]! - 1 + 2 * detail.inset;
    const place = cell[axis]! + detail.inset + offset[axis]!;
    const within = Math.min(Math.max(place, margin), cells - margin);
    return low + (within * (max[axis]! - low)) / cells;
  }) as Vec3;
  return turned(inRoom, yaw);
}

/** Attributes of hits of the parts' triangles, which are numbered one part after the other. */
function hitsOn(parts: readonly Part[]) {
  const numbers = partsOfTriangles(parts);
  let count = 0;
  const firsts = parts.map(({ indices }) => {
    count += Math.floor(indices.length / 3);
    return count - Math.floor(indices.length / 3);
  });
  const partOf = ({ triangle }: RayHit) => numbers[triangle]!;
  const isInside = (hit: RayHit) => hit.isBack && !parts[partOf(hit)]!.material.isDoubleSided;
  const uvOf = (hit: RayHit) => {
    const part = partOf(hit);
    const { indices, uvs } = parts[part]!;
    const first = (hit.triangle - firsts[part]!) * 3;
    const [a, b, c] = [indices[first]!, indices[first + 1]!, indices[first + 2]!];
    const mix = (axis: 0 | 1) =>
      (1 - hit.u - hit.v) * uvs[a * 2 + axis]! +
      hit.u * uvs[b * 2 + axis]! +
      hit.v * uvs[c * 2 + axis]!;
    return [mix(0), mix(1)] as const;
  };
  return { partOf, isInside, uvOf };
}

/** For each texel of a depth map the rays in its lobe, and their weights. */
type Lobes = readonly { readonly rays: Uint16Array; readonly weights: Float32Array }[];

function lobesOf(directions: readonly Vec3[]): Lobes {
  // Of rays beyond, a thousandth of the lobe at most.
  const leastCosine = 1e-4 ** (1 / LOBE_EXPONENT);
  return octahedral(PROBE_DEPTH_EDGE, PROBE_DEPTH_EDGE - 2, 1).map((texel) => {
    const rays: number[] = [];
    const weights: number[] = [];
    let sum = 0;
    for (let ray = 0; ray < directions.length; ray++) {
      const direction = directions[ray]!;
      const cosine = texel[0] * direction[0] + texel[1] * direction[1] + texel[2] * direction[2];
      if (cosine < leastCosine) continue;
      const weight = cosine ** LOBE_EXPONENT;
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
