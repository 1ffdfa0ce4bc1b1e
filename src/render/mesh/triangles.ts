import { vec3 } from "gl-matrix";
import type { Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";

type Triangles = Pick<Part, "positions" | "indices">;

export function vertexAt({ positions, indices }: Triangles, index: number): Vec3 {
  const at = indices[index]! * 3;
  return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
}

export function verticesOf(part: Triangles, triangle: number): [Vec3, Vec3, Vec3] {
  const first = 3 * triangle;
  return [vertexAt(part, first), vertexAt(part, first + 1), vertexAt(part, first + 2)];
}

/** Along the normal of a triangle, as long as twice its area. */
export function crossOf([a, b, c]: readonly [Vec3, Vec3, Vec3]): Vec3 {
  const edges = [vec3.subtract([0, 0, 0], b, a), vec3.subtract([0, 0, 0], c, a)] as const;
  return vec3.cross([0, 0, 0], ...edges) as Vec3;
}

/** Number of the part of each triangle; these are numbered one part after the other. */
export function partsOfTriangles(parts: readonly Triangles[]): Uint32Array {
  const counts = parts.map(({ indices }) => Math.floor(indices.length / 3));
  const numbers = new Uint32Array(counts.reduce((sum, count) => sum + count, 0));
  let first = 0;
  for (const [i, count] of counts.entries()) {
    numbers.fill(i, first, first + count);
    first += count;
  }
  return numbers;
}
