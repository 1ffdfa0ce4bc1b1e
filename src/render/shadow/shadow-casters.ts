import cubeFaceVert from "../../../shaders/shadow/cube-face.vert";
import shadowFrag from "../../../shaders/shadow/shadow.frag";
import type { Model, Part } from "../../assets/model.js";
import type { Buffer, Draw, Gpu, Program, VertexArray } from "../../gl/gpu.js";
import type { Bounds } from "../../world/geometry.js";
import { finish, type Steps } from "../../world/steps.js";
import { type Clusters, clusterSteps, runsOf, VERTEX_SIZE } from "../mesh/clusters.js";
import { isMostlyClear, type Mesh } from "../mesh/mesh.js";
import { reducedPart } from "../mesh/mesh-lods.js";
import { type Task, type Tasks, taskOf } from "../task.js";
import { casterAlbedoOf } from "./caster-albedo.js";

/** Most draws for a cube face: a further draw call costs more than the triangles that it would cull. */
const MOST_DRAWS = 3;
const FLOAT = 4;

export interface CasterDetail {
  /** Size of the largest feature that may be simplified away, metres. */
  readonly error: number;
  /** Whether they are of the reduced triangles that a model brings along. */
  readonly isReduced?: boolean;
}

/** Shared by all contexts. */
const tasks: Tasks<Model, Clusters> = new WeakMap();

/** Clusters of a model for the casters to come, a part in each step: once for each level of detail. */
export function clustersOf(
  model: Model,
  { error, isReduced = false }: CasterDetail,
): Task<Clusters> {
  const levelOf = (part: Part) => {
    if (isMostlyClear(part)) return { ...part, positions: NONE, indices: new Uint16Array() };
    return isReduced ? reducedPart([part]) : part;
  };
  return taskOf(tasks, model, { error, isReduced }, () =>
    clusterSteps(model.parts, error, levelOf),
  );
}

const NONE = new Float32Array();

/** Where depth is drawn, and by which projection. By default both faces of triangles cast shadows. */
export interface DepthDraw extends Pick<Draw, "target" | "viewport" | "writesColor" | "cull"> {
  readonly uClipFromWorld: Float32Array;
}

/** What casts shadows. */
export interface Casters {
  /** Draws the depth of what is in visible boxes. */
  drawDepth(draw: DepthDraw, isVisible: (box: Bounds) => boolean): void;
}

const DEPTH = { depth: "test-and-write", cull: "none" } as const;
const ANYWHERE = () => true;

/** Program of the casters' depth. */
function depthProgram(gpu: Gpu, isCutOut: boolean): Program {
  const defines = isCutOut ? { CUTOUT: 1 } : {};
  return gpu.program("shadow/shadow", cubeFaceVert, shadowFrag, { defines });
}

/** Meshes as casters, each by its own triangles. */
export class MeshCasters implements Casters {
  readonly #gpu: Gpu;
  readonly #meshes: readonly Mesh[];

  constructor(gpu: Gpu, meshes: readonly Mesh[]) {
    this.#gpu = gpu;
    this.#meshes = meshes;
    for (const { isCutOut } of meshes) depthProgram(gpu, isCutOut); // to be compiled before it is drawn with
  }

  drawDepth(
    { uClipFromWorld, ...pass }: DepthDraw,
    isVisible: (box: Bounds) => boolean = ANYWHERE,
  ): void {
    for (const { clusters, vertexArray, textures, isCutOut, ...mesh } of this.#meshes) {
      if (clusters.length > 0 && !clusters.some(isVisible)) continue;
      this.#gpu.draw({
        ...DEPTH,
        ...pass,
        ...(mesh.isDoubleSided && DEPTH),
        program: depthProgram(this.#gpu, isCutOut),
        vertexArray,
        textures: isCutOut ? textures : {},
        uniforms: { uClipFromWorld, ...(isCutOut && mesh.uniforms) },
      });
    }
  }
}

/** The room's clusters of triangles, culled by face of a cube: casters of shadows and of indirect light. */
export class ShadowCasters implements Casters {
  readonly #gpu: Gpu;
  readonly #clusters: Clusters;
  readonly #surfaces: readonly Mesh[];
  readonly #vertexArray: VertexArray;
  readonly #buffers: readonly Buffer[];
  /** Surfaces with holes, which are drawn by their own triangles. */
  readonly #perforated: MeshCasters;

  /** @param surfaces of the same model, in the order of its parts */
  constructor(gpu: Gpu, model: Model, surfaces: readonly Mesh[], detail: CasterDetail) {
    this.#gpu = gpu;
    this.#surfaces = surfaces;
    this.#clusters = clustersOf(model, detail).finish();
    depthProgram(gpu, false);
    const perforated = surfaces.filter(
      ({ isCutOut }, i) => isCutOut && model.parts[i]!.indices.length > 0,
    );
    this.#perforated = new MeshCasters(gpu, perforated);
    const { vertices, indices } = this.#clusters;
    const buffer = gpu.buffer("casters/vertices", vertices);
    const indexBuffer = gpu.buffer("casters/indices", indices, "index");
    this.#buffers = [buffer, indexBuffer];
    const stride = VERTEX_SIZE * FLOAT;
    this.#vertexArray = gpu.vertexArray("casters", {
      attributes: {
        0: { buffer, size: 3, stride },
        3: { buffer, size: 2, stride, offset: 3 * FLOAT },
        5: { buffer, size: 1, stride, offset: 5 * FLOAT },
      },
      indices: { buffer: indexBuffer, type: "uint32" },
      count: indices.length,
    });
  }

  /** Draws the depth of all, of those with holes without these. By `shadow/cube-face.vert`. */
  drawDepth(draw: DepthDraw, isVisible: (box: Bounds) => boolean): void {
    const { uClipFromWorld, ...pass } = draw;
    const { clusters: all, wholeCount } = this.#clusters;
    const program = depthProgram(this.#gpu, false);
    const vertexArray = this.#vertexArray;
    for (const run of runsOf(all.slice(0, wholeCount), isVisible, MOST_DRAWS)) {
      this.#gpu.draw({
        ...DEPTH,
        ...pass,
        ...run,
        program,
        vertexArray,
        uniforms: { uClipFromWorld },
      });
    }
    this.#perforated.drawDepth(draw, isVisible);
  }

  /** Draws what draws with albedo need, a surface in each step. */
  *prepareAlbedo(): Steps {
    yield* casterAlbedoOf(this.#gpu, this.#surfaces);
  }

  drawWithAlbedo(
    pass: Omit<Draw, "vertexArray" | "textures">,
    isVisible: (box: Bounds) => boolean,
  ): void {
    const textures = { uCasterAlbedo: finish(casterAlbedoOf(this.#gpu, this.#surfaces)) };
    for (const run of runsOf(this.#clusters.clusters, isVisible, MOST_DRAWS)) {
      this.#gpu.draw({ ...pass, ...run, textures, vertexArray: this.#vertexArray });
    }
  }

  dispose(): void {
    for (const object of [this.#vertexArray, ...this.#buffers]) object.dispose();
  }
}
