import type { Part } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import { groupTriangles } from "./clusters.js";
import { type Surface, uploadTriangles } from "./mesh.js";
import { Simplification, type Simplified } from "./simplify.js";

/** Corners that may be gone through in a frame: a few milliseconds. */
const PATIENCE = 20_000;

/** Triangles of a surface. */
export type Drawable = Pick<Surface, "vertexArray" | "clusters">;

/** Surfaces of fewer triangles, worked out bit by bit and kept. */
export class MeshLods {
  readonly #gpu: Gpu;
  readonly #coarse = new Map<Surface, Drawable & { readonly part: Part }>();
  /** Those of one model, by material. */
  readonly #merged = new Map<readonly Surface[], readonly Surface[]>();
  #current: { readonly surface: Surface; readonly work: Simplification } | null = null;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
  }

  /** A surface with fewer triangles as soon as it is ready, until then as it is. */
  of(surface: Surface): Drawable {
    return this.#coarse.get(surface) ?? surface;
  }

  /** All of a model, those of one material in one draw; as they are before all of them are ready. */
  merged(surfaces: readonly Surface[]): readonly Surface[] {
    const known = this.#merged.get(surfaces);
    const parts = known ? null : this.partsOf(surfaces);
    if (!parts) return known ?? surfaces;
    const materials = new Set(surfaces.map(({ part }) => part.material));
    const merged = Array.from(materials, (material) => {
      const group = surfaces.filter((surface) => surface.part.material === material);
      const first = group[0]!;
      if (group.length === 1) return first;
      const part = together(group.flatMap((surface) => this.#coarse.get(surface)?.part ?? []));
      return { ...first, part, ...this.#upload(part) };
    });
    this.#merged.set(surfaces, merged);
    return merged;
  }

  /** The parts of a model's surfaces with fewer triangles; null before all are ready. */
  partsOf(surfaces: readonly Surface[]): readonly Part[] | null {
    const parts = surfaces.flatMap((surface) => this.#coarse.get(surface)?.part ?? []);
    return parts.length === surfaces.length ? parts : null;
  }

  /**
   * Goes on for a frame's share of time.
   *
   * @param surfaces and how far each may be from where it was, metres
   */
  proceed(surfaces: Iterable<readonly [Surface, number]>): void {
    let gone = 0;
    for (const [surface, error] of surfaces) {
      if (this.#coarse.has(surface)) continue;
      if (this.#current?.surface !== surface) {
        this.#current = { surface, work: new Simplification(surface.part, error) };
        gone += surface.part.indices.length;
      }
      const { work } = this.#current;
      do {
        if (gone > PATIENCE) return;
        gone += work.length;
      } while (work.proceed());
      this.#keep(surface, work.result);
      this.#current = null;
    }
  }

  #keep(surface: Surface, simplified: Simplified): void {
    const part = partOf(surface.part, simplified);
    this.#coarse.set(surface, { ...this.#upload(part), part });
  }

  #upload(part: Part): Drawable {
    const { indices, clusters } = groupTriangles(part);
    const name = `${part.name}/coarse`;
    return { vertexArray: uploadTriangles(this.#gpu, { ...part, name, indices }), clusters };
  }
}

/** Triangles of a part that may stand elsewhere than they did. */
function partOf(part: Part, { places, looks, indices }: Simplified): Part {
  const pick = (from: Float32Array, size: number, vertices: Uint32Array) => {
    const to = new Float32Array(vertices.length * size);
    for (const [vertex, old] of vertices.entries()) {
      for (let k = 0; k < size; k++) to[vertex * size + k] = from[old * size + k]!;
    }
    return to;
  };
  return {
    ...part,
    positions: pick(part.positions, 3, places),
    normals: pick(part.normals, 3, looks),
    tangents: pick(part.tangents, 4, looks),
    uvs: pick(part.uvs, 2, looks),
    colors: part.colors && pick(part.colors, 4, looks),
    indices,
  };
}

/** Parts of one material as one. */
function together(parts: readonly Part[]): Part {
  const [first] = parts;
  if (!first) throw new Error("There is nothing to put together.");
  const join = (of: (part: Part) => Float32Array) => {
    const arrays = parts.map(of);
    const joined = new Float32Array(arrays.reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const array of arrays) {
      joined.set(array, at);
      at += array.length;
    }
    return joined;
  };
  const white = ({ positions }: Part) => new Float32Array((positions.length / 3) * 4).fill(1);
  let before = 0;
  const indices = parts.flatMap((part) => {
    const from = before;
    before += part.positions.length / 3;
    return Array.from(part.indices, (index) => from + index);
  });
  return {
    ...first,
    positions: join(({ positions }) => positions),
    normals: join(({ normals }) => normals),
    tangents: join(({ tangents }) => tangents),
    uvs: join(({ uvs }) => uvs),
    colors: join((part) => part.colors ?? white(part)),
    indices: Uint32Array.from(indices),
  };
}
