import { vec3 } from "gl-matrix";
import type { Part } from "../../assets/model.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import type { Steps } from "../../world/steps.js";
import { crossOf, verticesOf } from "./triangles.js";

/** Triangles of a cluster: few enough for culling, enough to be worth a draw. */
const CLUSTER = 160;
/** Cells along each axis of the Morton code. */
const GRID = 1024;

/** Floats of a vertex: position (metres), uv, number of the part. */
export const VERTEX_SIZE = 6;

/** Consecutive indices. */
export interface Run {
  readonly first: number;
  readonly count: number;
}

/** Neighbouring triangles of one part, and their bounds. */
export interface Cluster extends Bounds, Run {}

/** All triangles of a model in one mesh, by place, for culling. */
export interface Clusters {
  /** `VERTEX_SIZE` numbers each. */
  readonly vertices: Float32Array;
  readonly indices: Uint32Array;
  /** Those of parts with holes are the last. */
  readonly clusters: readonly Cluster[];
  /** How many are of parts without holes. */
  readonly wholeCount: number;
}

/**
 * Merges a model's parts into clusters of triangles, simplified by vertex clustering; a part in each step.
 *
 * Rossignac and Borrel 1993, "Multi-resolution 3D approximations for rendering complex scenes": vertices
 * within one cell become their mean, and degenerate triangles are dropped. Each part is simplified by itself, so
 * that a thing on a table does not merge with it.
 *
 * @param detail edge of the cells whose vertices become one, metres; 0 keeps all
 * @param levelOf a part at the level of detail to begin with. Default: the part itself
 */
export function* clusterSteps(
  parts: readonly Part[],
  detail: number,
  levelOf = (part: Part) => part,
): Steps<Clusters> {
  const vertices: number[] = [];
  const indices: number[] = [];
  const clusters: Cluster[] = [];
  let wholeCount = 0;
  const order = [...parts.keys()].sort(
    (a, b) => Number(hasHoles(parts[a]!)) - Number(hasHoles(parts[b]!)),
  );
  for (const i of order) {
    const source = levelOf(parts[i]!);
    const mesh = detail > 0 ? clusterVertices(source, detail) : source;
    appendInOrder(mesh, i, { vertices, indices, clusters });
    if (!hasHoles(parts[i]!)) wholeCount = clusters.length;
    yield;
  }
  const sorted = [clusters.slice(0, wholeCount), clusters.slice(wholeCount)].flatMap(byPlace);
  return { vertices: Float32Array.from(vertices), wholeCount, ...inSequence(indices, sorted) };
}

/** Whether some of a part may be cut out by its opacity. */
function hasHoles({ material }: Part): boolean {
  return material.alphaMode !== "opaque";
}

/** Clusters in Morton order, so that those of one side of a room are few runs. */
function byPlace(clusters: readonly Cluster[]): Cluster[] {
  const centers = clusters.flatMap(({ min, max }) => [
    (min[0] + max[0]) / 2,
    (min[1] + max[1]) / 2,
    (min[2] + max[2]) / 2,
  ]);
  // A triangle of one corner stands for a cluster.
  const corners = Uint32Array.from({ length: 3 * clusters.length }, (_, i) => Math.floor(i / 3));
  const order = orderByPlace({ positions: centers, uvs: [], indices: corners });
  return [...order].map((i) => clusters[i]!);
}

/** Clusters with their indices one after another. */
function inSequence(
  indices: readonly number[],
  clusters: readonly Cluster[],
): Pick<Clusters, "indices" | "clusters"> {
  const sorted: Cluster[] = [];
  const out = new Uint32Array(indices.length);
  let first = 0;
  for (const cluster of clusters) {
    for (let k = 0; k < cluster.count; k++) out[first + k] = indices[cluster.first + k] ?? 0;
    sorted.push({ ...cluster, first });
    first += cluster.count;
  }
  return { indices: out, clusters: sorted };
}

type Mesh = {
  readonly positions: ArrayLike<number>;
  readonly uvs: ArrayLike<number>;
  /** Three to a triangle. */
  readonly indices: ArrayLike<number>;
};

function clusterVertices({ positions, uvs, indices }: Mesh, detail: number): Mesh {
  const known = new Map<number, number>();
  const members: number[] = [];
  const mean: { positions: number[]; uvs: number[] } = { positions: [], uvs: [] };
  const vertexOf = new Uint32Array(positions.length / 3);
  const add = (to: number[], vertex: number, from: ArrayLike<number>, i: number, size: number) => {
    for (let k = 0; k < size; k++) {
      const before = to[vertex * size + k] ?? 0;
      const x = from[i * size + k] ?? 0;
      to[vertex * size + k] = before + (x - before) / (members[vertex] ?? 1);
    }
  };
  for (let i = 0; i < vertexOf.length; i++) {
    let key = 0;
    // 17 bits for each axis; cells beyond wrap around.
    for (let axis = 0; axis < 3; axis++) {
      key = key * 0x20000 + (Math.floor((positions[i * 3 + axis] ?? 0) / detail) & 0x1ffff);
    }
    const vertex = known.get(key) ?? members.length;
    known.set(key, vertex);
    members[vertex] = (members[vertex] ?? 0) + 1;
    add(mean.positions, vertex, positions, i, 3);
    add(mean.uvs, vertex, uvs, i, 2);
    vertexOf[i] = vertex;
  }
  const corners: number[] = [];
  /** The largest corners of the triangles at a side of the two others. */
  const unique = new Map<number, number[]>();
  for (let i = 0; i < indices.length; i += 3) {
    const a = vertexOf[indices[i] ?? 0] ?? 0;
    const b = vertexOf[indices[i + 1] ?? 0] ?? 0;
    const c = vertexOf[indices[i + 2] ?? 0] ?? 0;
    if (a === b || b === c || c === a) continue;
    // Two sides of a board that have merged are one triangle.
    const low = Math.min(a, b, c);
    const high = Math.max(a, b, c);
    const side = low * members.length + (a + b + c - low - high);
    const thirds = unique.get(side) ?? [];
    if (thirds.includes(high)) continue;
    thirds.push(high);
    unique.set(side, thirds);
    corners.push(a, b, c);
  }
  return { ...mean, indices: corners };
}

/** Triangles in the order of their Morton code, which keeps neighbours together (Morton 1966). */
function orderByPlace({ positions, indices }: Mesh): Uint32Array {
  const low = [0, 0, 0];
  let longest = 1e-6;
  for (let axis = 0; axis < 3; axis++) {
    let [least, most] = [Infinity, -Infinity];
    for (let i = axis; i < positions.length; i += 3) {
      least = Math.min(least, positions[i] ?? 0);
      most = Math.max(most, positions[i] ?? 0);
    }
    low[axis] = least;
    longest = Math.max(longest, most - least);
  }
  // The number below the code in one key: sorted natively.
  const count = Math.floor(indices.length / 3);
  const keys = new Float64Array(count);
  for (let triangle = 0; triangle < count; triangle++) {
    let code = 0;
    for (let axis = 0; axis < 3; axis++) {
      let sum = 0;
      for (let k = 0; k < 3; k++)
        sum += positions[(indices[triangle * 3 + k] ?? 0) * 3 + axis] ?? 0;
      const share = (sum / 3 - (low[axis] ?? 0)) / longest;
      code |= spread(Math.min(GRID - 1, Math.floor(share * GRID))) << axis;
    }
    keys[triangle] = code * count + triangle;
  }
  return Uint32Array.from(keys.sort(), (key) => key % count);
}

/** Ten bits, interleaved with two zeros each. */
function spread(bits: number): number {
  let x = bits;
  x = (x | (x << 16)) & 0x030000ff;
  x = (x | (x << 8)) & 0x0300f00f;
  x = (x | (x << 4)) & 0x030c30c3;
  return (x | (x << 2)) & 0x09249249;
}

/** Indices by Morton order, and the clusters of them. */
function inOrder(mesh: Mesh): { corners: Uint32Array; clusters: Cluster[] } {
  const { positions, indices } = mesh;
  const order = orderByPlace(mesh);
  const corners = new Uint32Array(order.length * 3);
  const clusters: Cluster[] = [];
  for (let begin = 0; begin < order.length; begin += CLUSTER) {
    const end = Math.min(begin + CLUSTER, order.length);
    const min: Vec3 = [Infinity, Infinity, Infinity];
    const max: Vec3 = [-Infinity, -Infinity, -Infinity];
    for (let i = begin * 3; i < end * 3; i++) {
      const corner = indices[(order[Math.floor(i / 3)] ?? 0) * 3 + (i % 3)] ?? 0;
      corners[i] = corner;
      for (const axis of [0, 1, 2] as const) {
        const x = positions[corner * 3 + axis] ?? 0;
        min[axis] = Math.min(min[axis], x);
        max[axis] = Math.max(max[axis], x);
      }
    }
    clusters.push({ min, max, first: begin * 3, count: (end - begin) * 3 });
  }
  return { corners, clusters };
}

/** Triangles of a part, sorted for culling. */
export interface Grouped {
  readonly indices: Uint16Array | Uint32Array;
  readonly clusters: readonly Cluster[];
  /** Of all triangles, m². */
  readonly area: number;
}

/** Sorts a part's triangles; the vertices stay. */
export function groupTriangles(part: Part): Grouped {
  const { corners, clusters } = inOrder(part);
  const indices = part.indices instanceof Uint16Array ? Uint16Array.from(corners) : corners;
  return { indices, clusters, area: areaOf(part) };
}

function areaOf(part: Part): number {
  let sum = 0;
  for (let triangle = 0; triangle < Math.floor(part.indices.length / 3); triangle++) {
    sum += vec3.length(crossOf(verticesOf(part, triangle))) / 2;
  }
  return sum;
}

/** Vertices are renumbered in the order of their first use, for the vertex cache. */
function appendInOrder(
  mesh: Mesh,
  part: number,
  to: { vertices: number[]; indices: number[]; clusters: Cluster[] },
): void {
  const { positions, uvs } = mesh;
  const { corners, clusters } = inOrder(mesh);
  const renamed = new Int32Array(positions.length / 3).fill(-1);
  const before = to.indices.length;
  for (const corner of corners) {
    if (renamed[corner] === -1) {
      renamed[corner] = to.vertices.length / VERTEX_SIZE;
      for (let k = 0; k < 3; k++) to.vertices.push(positions[corner * 3 + k] ?? 0);
      for (let k = 0; k < 2; k++) to.vertices.push(uvs[corner * 2 + k] ?? 0);
      to.vertices.push(part);
    }
    to.indices.push(renamed[corner] ?? 0);
  }
  for (const cluster of clusters) {
    to.clusters.push({ ...cluster, first: cluster.first + before });
  }
}

/**
 * Visible clusters as runs of indices, consecutive ones merged.
 *
 * @param most runs; to have no more, hidden clusters between the nearest ones are drawn too
 */
export function runsOf(
  clusters: readonly Cluster[],
  isVisible: (box: Bounds) => boolean,
  most = Infinity,
): Run[] {
  const runs: { first: number; count: number }[] = [];
  for (const cluster of clusters) {
    if (!isVisible(cluster)) continue;
    const { first, count } = cluster;
    const last = runs.at(-1);
    if (last && first === last.first + last.count) last.count += count;
    else runs.push({ first, count });
  }
  const gap = (i: number) => runs[i]!.first - runs[i - 1]!.first - runs[i - 1]!.count;
  while (runs.length > most) {
    let least = 1;
    for (let i = 2; i < runs.length; i++) if (gap(i) < gap(least)) least = i;
    const [next] = runs.splice(least, 1);
    const before = runs[least - 1]!;
    before.count = next!.first + next!.count - before.first;
  }
  return runs;
}
