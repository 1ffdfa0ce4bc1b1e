import type { Part } from "../../assets/model.js";
import type { Gpu } from "../../gl/gpu.js";
import { groupTriangles } from "../clusters.js";
import { Simplification } from "../simplify.js";
import type { Surface } from "../surface.js";

/** Corners that may be gone through in a frame: a few milliseconds. */
const PATIENCE = 20_000;

/** Triangles of a surface. */
export type Drawable = Pick<Surface, "vertexArray" | "clusters">;

/** Surfaces of fewer triangles, worked out bit by bit and kept. */
export class CoarseSurfaces {
  readonly #gpu: Gpu;
  readonly #coarse = new Map<Surface, Drawable & { readonly part: Part }>();
  #current: { readonly surface: Surface; readonly work: Simplification } | null = null;

  constructor(gpu: Gpu) {
    this.#gpu = gpu;
  }

  /** A surface with fewer triangles as soon as it is ready, until then as it is. */
  of(surface: Surface): Drawable {
    return this.#coarse.get(surface) ?? surface;
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
        gone += work.indices.length;
      } while (work.proceed());
      this.#keep(surface, work.indices);
      this.#current = null;
    }
  }

  #keep(surface: Surface, corners: Uint32Array): void {
    const { attributes, part } = surface;
    const coarse = { ...part, indices: corners };
    const { indices, clusters } = groupTriangles(coarse);
    const buffer = this.#gpu.buffer(`${part.name}/coarse indices`, indices, "index");
    const vertexArray = this.#gpu.vertexArray(`${part.name}/coarse`, {
      attributes,
      indices: { buffer, type: "uint32" },
      count: indices.length,
    });
    this.#coarse.set(surface, { vertexArray, clusters, part: coarse });
  }
}
