import type { Model } from "../../assets/model.js";
import type { Buffer } from "../../gl/buffer.js";
import type { Draw, Gpu } from "../../gl/gpu.js";
import type { Texture } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { type Clusters, clusterTriangles, runsOf, VERTEX_SIZE } from "../mesh/clusters.js";
import type { Mesh } from "../mesh/mesh.js";
import { isInCubeFace } from "./cube-map.js";

/** Culled triangles that cost less than another draw: they are drawn to merge the runs on both sides. */
const MERGED_TRIANGLES = 200;
/** Bytes of a float. */
const FLOAT = 4;

/** Clusters of each model by level of detail, shared by all contexts. */
const cache = new WeakMap<Model, Map<number, Clusters>>();

function clustersOf(model: Model, detail: number): Clusters {
  const levels = cache.get(model) ?? new Map<number, Clusters>();
  cache.set(model, levels);
  const clusters = levels.get(detail) ?? clusterTriangles(model.parts, detail);
  levels.set(detail, clusters);
  return clusters;
}

/** The room's clusters of triangles, culled by face of a cube: casters of shadows and of indirect light. */
export class ShadowCasters {
  readonly #gpu: Gpu;
  readonly #clusters: Clusters;
  readonly #surfaces: readonly Mesh[];
  readonly #vertexArray: VertexArray;

  /**
   * @param surfaces of the same model, in the order of its parts
   * @param detail size of the largest feature that may be simplified away, metres
   */
  constructor(gpu: Gpu, model: Model, surfaces: readonly Mesh[], detail: number) {
    this.#gpu = gpu;
    this.#surfaces = surfaces;
    this.#clusters = clustersOf(model, detail);
    const { vertices, indices } = this.#clusters;
    const buffer: Buffer = gpu.buffer("casters/vertices", vertices);
    const stride = VERTEX_SIZE * FLOAT;
    this.#vertexArray = gpu.vertexArray("casters", {
      attributes: {
        0: { buffer, size: 3, stride },
        3: { buffer, size: 2, stride, offset: 3 * FLOAT },
      },
      indices: { buffer: gpu.buffer("casters/indices", indices, "index"), type: "uint32" },
      count: indices.length,
    });
  }

  /**
   * Draws clusters of triangles.
   *
   * @param isVisible whether what lies in a box is drawn
   */
  draw(pass: Omit<Draw, "vertexArray">, isVisible: (box: Bounds) => boolean): void {
    for (const { first, count } of this.#runs(isVisible, false)) {
      this.#gpu.draw({ ...pass, vertexArray: this.#vertexArray, first, count });
    }
  }

  /**
   * Draws the clusters that touch one face of a cube around `origin` (metres), with each part's `uAlbedo`,
   * `uBaseColor`, `uNormal` and `uNormalScale`.
   */
  drawWithAlbedo(face: number, origin: Vec3, pass: Omit<Draw, "vertexArray" | "textures">): void {
    for (const { part, first, count } of this.#runs(
      (box) => isInCubeFace(face, origin, box),
      true,
    )) {
      const surface = this.#surfaces[part];
      if (!surface) continue;
      const { uAlbedo, uNormal } = surface.textures;
      const textures: Record<string, Texture> = { uAlbedo, uNormal };
      const uniforms = {
        ...pass.uniforms,
        uBaseColor: surface.baseColor,
        uNormalScale: surface.parameters[2],
      };
      this.#gpu.draw({ ...pass, vertexArray: this.#vertexArray, first, count, textures, uniforms });
    }
  }

  #runs(isVisible: (box: Bounds) => boolean, isByPart: boolean) {
    return runsOf(this.#clusters.clusters, isVisible, isByPart, 3 * MERGED_TRIANGLES);
  }
}
