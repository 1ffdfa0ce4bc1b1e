import type { Model } from "../../assets/model.js";
import type { Buffer } from "../../gl/buffer.js";
import type { Draw, Gpu } from "../../gl/gpu.js";
import type { Texture } from "../../gl/texture.js";
import type { VertexArray } from "../../gl/vertex-array.js";
import type { Bounds, Vec3 } from "../../world/geometry.js";
import { type Clusters, clusterTriangles, runsOf, VERTEX_SIZE } from "../mesh/clusters.js";
import type { Surface } from "../mesh/mesh.js";
import { isInCubeFace } from "./cube-map.js";

/** Unseen triangles that cost less than another draw. */
const SPARED = 200;
/** Bytes of a float. */
const FLOAT = 4;

/** A model keeps its clusters by their detail, for the next GPU that asks as finely. */
const known = new WeakMap<Model, Map<number, Clusters>>();

function clustersOf(model: Model, detail: number): Clusters {
  const details = known.get(model) ?? new Map<number, Clusters>();
  known.set(model, details);
  const clusters = details.get(detail) ?? clusterTriangles(model.parts, detail);
  details.set(detail, clusters);
  return clusters;
}

/** The room as the flame sees it: what throws shadows, and what throws light back. */
export class ShadowCasters {
  readonly #gpu: Gpu;
  readonly #clusters: Clusters;
  readonly #surfaces: readonly Surface[];
  readonly #vertexArray: VertexArray;

  /**
   * @param surfaces of the same model, in the order of its parts
   * @param detail what is smaller, metres, may be left out
   */
  constructor(gpu: Gpu, model: Model, surfaces: readonly Surface[], detail: number) {
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
   * Draws all that may show in one face of a cube around `eye` (metres).
   *
   * @param matters what else is to be true of a box for what is in it to be drawn
   */
  draw(
    face: number,
    eye: Vec3,
    how: Omit<Draw, "vertexArray">,
    matters?: (box: Bounds) => boolean,
  ): void {
    for (const { first, count } of this.#runs(face, eye, false, matters)) {
      this.#gpu.draw({ ...how, vertexArray: this.#vertexArray, first, count });
    }
  }

  /** The same in their own colours: samplers `uAlbedo` times `uBaseColor`, `uNormal` by `uRelief`. */
  drawWithAlbedo(face: number, eye: Vec3, how: Omit<Draw, "vertexArray" | "textures">): void {
    for (const { part, first, count } of this.#runs(face, eye, true)) {
      const surface = this.#surfaces[part];
      if (!surface) continue;
      const { uAlbedo, uNormal } = surface.textures;
      const textures: Record<string, Texture> = { uAlbedo, uNormal };
      const uniforms = {
        ...how.uniforms,
        uBaseColor: surface.baseColor,
        uRelief: surface.parameters[2],
      };
      this.#gpu.draw({ ...how, vertexArray: this.#vertexArray, first, count, textures, uniforms });
    }
  }

  #runs(face: number, eye: Vec3, isByPart: boolean, matters = (_: Bounds) => true) {
    const isSeen = (box: Bounds) => isInCubeFace(face, eye, box) && matters(box);
    return runsOf(this.#clusters.clusters, isSeen, isByPart, 3 * SPARED);
  }
}
