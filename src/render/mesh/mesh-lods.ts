import type { Part } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import { groupTriangles } from "./clusters.js";
import { type Mesh, uploadTriangles } from "./mesh.js";

/**
 * The lower level of detail of models, for frames in motion: the reduced triangles that a model brings along,
 * one draw for each material. A model without them is drawn as it is.
 */
export class MeshLods {
  readonly #gpu: Gpu;
  /** By the surfaces of one model. */
  readonly #merged = new Map<readonly Mesh[], readonly Mesh[]>();

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
  }

  /** All of a model, those of one material in one draw. */
  merged(surfaces: readonly Mesh[]): readonly Mesh[] {
    const merged = this.#merged.get(surfaces) ?? this.#merge(surfaces);
    this.#merged.set(surfaces, merged);
    return merged;
  }

  /** The parts of a model at its lower level; null where it has none. */
  partsOf(surfaces: readonly Mesh[]): readonly Part[] | null {
    return hasLods(surfaces) ? surfaces.map(({ part }) => reduced([part])) : null;
  }

  #merge(surfaces: readonly Mesh[]): readonly Mesh[] {
    if (!hasLods(surfaces)) return surfaces;
    const materials = new Set(surfaces.map(({ part }) => part.material));
    return Array.from(materials, (material) => {
      const group = surfaces.filter((surface) => surface.part.material === material);
      const part = reduced(group.map((surface) => surface.part));
      const { indices, clusters } = groupTriangles(part);
      // Again, with the vertices in the order of their first use now: neighbours stay in a vertex cache.
      const inOrder = reduced([{ ...part, reducedIndices: Uint32Array.from(indices) }]);
      const name = `${part.name}/lod`;
      const vertexArray = uploadTriangles(this.#gpu, { ...inOrder, name });
      return { ...group[0]!, part, vertexArray, clusters };
    });
  }
}

const hasLods = (surfaces: readonly Mesh[]) =>
  surfaces.some(({ part }) => part.reducedIndices !== undefined);

/** The reduced triangles of parts of one material, and the vertices that they use, as one part. */
function reduced(parts: readonly Part[]): Part {
  const vertices: (readonly [Part, number])[] = [];
  const indices: number[] = [];
  for (const part of parts) {
    const numbers = new Map<number, number>();
    for (const vertex of part.reducedIndices ?? part.indices) {
      const number = numbers.get(vertex) ?? vertices.push([part, vertex]) - 1;
      numbers.set(vertex, number);
      indices.push(number);
    }
  }
  const pick = (size: number, attributeOf: (part: Part) => Float32Array | null) => {
    const values = new Float32Array(vertices.length * size).fill(1); // white, where there are no colours
    for (const [i, [part, vertex]] of vertices.entries()) {
      const from = attributeOf(part);
      if (from) values.set(from.subarray(vertex * size, (vertex + 1) * size), i * size);
    }
    return values;
  };
  return {
    ...parts[0]!,
    positions: pick(3, ({ positions }) => positions),
    normals: pick(3, ({ normals }) => normals),
    tangents: pick(4, ({ tangents }) => tangents),
    uvs: pick(2, ({ uvs }) => uvs),
    colors: pick(4, ({ colors }) => colors),
    indices: Uint32Array.from(indices),
  };
}
