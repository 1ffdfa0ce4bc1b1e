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
  /** By the surfaces of one model, as far as they are made. */
  readonly #merged = new Map<readonly Mesh[], Mesh[]>();

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
  }

  /** All of a model, those of one material in one draw; the model as it is until all of that is made. */
  merged(surfaces: readonly Mesh[]): readonly Mesh[] {
    const merged = this.#merged.get(surfaces) ?? [];
    return merged.length === materialsOf(surfaces).length ? merged : surfaces;
  }

  /** Merges the surfaces of the next material. True when all are merged. */
  mergeIncrementally(surfaces: readonly Mesh[]): boolean {
    const merged = this.#merged.get(surfaces) ?? [];
    this.#merged.set(surfaces, merged);
    const material = hasLods(surfaces) ? materialsOf(surfaces)[merged.length] : undefined;
    if (!material) return true;
    merged.push(this.#merge(surfaces.filter(({ part }) => part.material === material)));
    return false;
  }

  #merge(surfaces: readonly Mesh[]): Mesh {
    const part = reducedPart(surfaces.map((surface) => surface.part));
    const { indices, clusters } = groupTriangles(part);
    // Again, with the vertices in the order of their first use now: neighbours stay in a vertex cache.
    const inOrder = reducedPart([{ ...part, reducedIndices: Uint32Array.from(indices) }]);
    const name = `${part.name}/lod`;
    const vertexArray = uploadTriangles(this.#gpu, { ...inOrder, name });
    return { ...surfaces[0]!, part, vertexArray, clusters };
  }
}

const materialsOf = (surfaces: readonly Mesh[]) => [
  ...new Set(surfaces.map(({ part }) => part.material)),
];

/** Whether a model brings a lower level of detail along. */
export const hasLods = (surfaces: readonly { readonly part: Part }[]) =>
  surfaces.some(({ part }) => part.reducedIndices !== undefined);

/** The reduced triangles of parts of one material, and the vertices that they use, as one part. */
export function reducedPart(parts: readonly Part[]): Part {
  const used: { readonly part: Part; readonly vertices: readonly number[] }[] = [];
  const indices: number[] = [];
  let count = 0;
  for (const part of parts) {
    const numbers = new Int32Array(part.positions.length / 3).fill(-1);
    const vertices: number[] = [];
    for (const vertex of part.reducedIndices ?? part.indices) {
      if (numbers[vertex] === -1) numbers[vertex] = count + vertices.push(vertex) - 1;
      indices.push(numbers[vertex]!);
    }
    used.push({ part, vertices });
    count += vertices.length;
  }
  const pick = (size: number, attributeOf: (part: Part) => Float32Array | null) => {
    const values = new Float32Array(count * size).fill(1); // white, where there are no colours
    let to = 0;
    for (const { part, vertices } of used) {
      const from = attributeOf(part);
      for (const vertex of vertices) {
        for (let k = 0; from && k < size; k++) values[to + k] = from[vertex * size + k]!;
        to += size;
      }
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
