import { Vector3 } from "three";
import type { Vertices } from "./transform-vertices.js";

/** The vertices, with copies where triangles that mirror the images meet others: MikkTSpace splits there, too. */
export function splitAtMirrors<Split extends Vertices>(vertices: Split, uvs: Float32Array): Split {
  const count = vertices.positions.length / 3;
  const turns = new Int8Array(count);
  const sources: number[] = [];
  const copies = new Map<number, number>();
  const indices = vertices.indices.slice();
  for (let i = 0; i < indices.length; i += 3) {
    const corners = vertices.indices.subarray(i, i + 3);
    const turn = turnOf(edgesOf(uvs, corners));
    for (const [k, vertex] of corners.entries()) {
      turns[vertex] ||= turn;
      if (turn === 0 || turns[vertex] === turn) continue;
      const copy = copies.get(vertex) ?? count + sources.push(vertex) - 1;
      copies.set(vertex, copy);
      indices[i + k] = copy;
    }
  }
  if (sources.length === 0) return vertices;
  const grown = (values: Float32Array) => {
    const size = values.length / count;
    const all = new Float32Array(values.length + sources.length * size);
    all.set(values);
    for (const [i, source] of sources.entries()) {
      all.set(values.subarray(source * size, (source + 1) * size), (count + i) * size);
    }
    return all;
  };
  const { positions, normals, colors } = vertices;
  return {
    ...vertices,
    positions: grown(positions),
    normals: grown(normals),
    uvs: grown(uvs),
    colors: colors && grown(colors),
    indices,
  };
}

/**
 * Tangents along u, with the sign of the bitangent, which glTF has point up in the image (towards
 * smaller v). Lengyel 2001, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh".
 */
export function tangentsOf(
  { positions, normals, indices }: Vertices,
  uvs: Float32Array,
): Float32Array {
  const count = positions.length / 3;
  const alongU = new Float32Array(count * 3);
  const alongV = new Float32Array(count * 3);
  for (let i = 0; i < indices.length; i += 3) {
    const corners = indices.subarray(i, i + 3);
    const slopes = slopesOf(positions, uvs, corners);
    if (!slopes) continue;
    for (const corner of corners) {
      add(alongU, corner, slopes.u);
      add(alongV, corner, slopes.v);
    }
  }
  const tangents = anyTangents(normals);
  const normal = new Vector3();
  const tangent = new Vector3();
  const down = new Vector3();
  for (let i = 0; i < count; i++) {
    normal.fromArray(normals, i * 3);
    tangent.fromArray(alongU, i * 3);
    tangent.addScaledVector(normal, -normal.dot(tangent));
    if (!(tangent.lengthSq() > 0)) continue;
    tangent.normalize().toArray(tangents, i * 4);
    down.fromArray(alongV, i * 3);
    tangents[i * 4 + 3] = normal.cross(tangent).dot(down) > 0 ? -1 : 1;
  }
  return tangents;
}

const vectors = Array.from({ length: 5 }, () => new Vector3());

/** Directions of u and v in a triangle, with its doubled area as their length. */
function slopesOf(positions: Float32Array, uvs: Float32Array, corners: Uint32Array) {
  const [a = 0, b = 0, c = 0] = corners;
  const [origin, edge1, edge2, u, v] = vectors as [Vector3, Vector3, Vector3, Vector3, Vector3];
  origin.fromArray(positions, a * 3);
  edge1.fromArray(positions, b * 3).sub(origin);
  edge2.fromArray(positions, c * 3).sub(origin);
  const edges = edgesOf(uvs, corners);
  const [u1, v1, u2, v2] = edges;
  const turn = turnOf(edges);
  if (turn === 0) return null;
  const area = origin.crossVectors(edge1, edge2).length();
  u.copy(edge1).multiplyScalar(v2).addScaledVector(edge2, -v1).multiplyScalar(turn);
  v.copy(edge2).multiplyScalar(u1).addScaledVector(edge1, -u2).multiplyScalar(turn);
  return { u: u.setLength(area), v: v.setLength(area) };
}

type Edges = readonly [u1: number, v1: number, u2: number, v2: number];

function edgesOf(uvs: Float32Array, [a = 0, b = 0, c = 0]: Uint32Array): Edges {
  const edge = (to: number, k: number) => (uvs[to * 2 + k] ?? 0) - (uvs[a * 2 + k] ?? 0);
  return [edge(b, 0), edge(b, 1), edge(c, 0), edge(c, 1)];
}

/** Sense in which a triangle shows the images: 1, -1 where it mirrors them, 0 where it shows none. */
function turnOf([u1, v1, u2, v2]: Edges): number {
  return Math.sign(u1 * v2 - u2 * v1);
}

function add(sums: Float32Array, vertex: number, { x, y, z }: Vector3): void {
  for (const [k, value] of [x, y, z].entries()) {
    sums[vertex * 3 + k] = (sums[vertex * 3 + k] ?? 0) + value;
  }
}

/** Replaces tangents that no frame can be made of: none across the normal is left of them. */
export function replaceBadTangents(tangents: Float32Array, normals: Float32Array): Float32Array {
  const normal = new Vector3();
  const tangent = new Vector3();
  let any: Float32Array | null = null;
  for (let i = 0; i < normals.length / 3; i++) {
    normal.fromArray(normals, i * 3);
    tangent.fromArray(tangents, i * 4);
    tangent.addScaledVector(normal, -normal.dot(tangent));
    if (tangent.lengthSq() >= 1e-8) continue;
    any ??= anyTangents(normals);
    tangents.set(any.subarray(i * 4, i * 4 + 3), i * 4);
  }
  return tangents;
}

/** Arbitrary tangents, for surfaces without texture coordinates. */
export function anyTangents(normals: Float32Array): Float32Array {
  const count = normals.length / 3;
  const tangents = new Float32Array(count * 4);
  const normal = new Vector3();
  const across = new Vector3();
  for (let i = 0; i < count; i++) {
    normal.fromArray(normals, i * 3);
    const isAlongX = Math.abs(normal.x) >= 0.9;
    across.set(isAlongX ? 0 : 1, isAlongX ? 1 : 0, 0).cross(normal);
    across.normalize().toArray(tangents, i * 4);
    tangents[i * 4 + 3] = 1;
  }
  return tangents;
}
