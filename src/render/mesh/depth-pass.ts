import depthFrag from "../../../shaders/mesh/depth.frag";
import meshVert from "../../../shaders/mesh/mesh.vert";
import type { Draw, Gpu, Program, UniformBlock, VertexArray } from "../../gl/gpu.js";
import type { ModelInstance } from "../frame-input.js";
import type { Mesh } from "./mesh.js";

/** Of the depth, 0 to 1: 0.2 mm at 3 m. */
const DEPTH_BIAS = 1e-6;

/** What of a model is drawn at once, and what is apart. */
interface Merged {
  readonly oneSided: VertexArray;
  readonly doubleSided: VertexArray;
  readonly cutOut: readonly Mesh[];
}

/**
 * Depth prepass: depth of models alone, in a draw or two each and one for each mesh with holes. It lies a little behind
 * theirs, so that they pass the test against it.
 */
export class DepthPass {
  readonly #gpu: Gpu;
  readonly #frame: UniformBlock;
  readonly #program: Program;
  /** Of meshes with holes, once there are any. */
  #cutOutProgram: Program | null = null;
  readonly #merged = new Map<readonly Mesh[], Merged>();

  /** @param frame block `Frame` of a program with the same vertex shader */
  constructor(gpu: Gpu, frame: UniformBlock) {
    this.#gpu = gpu;
    this.#frame = frame;
    this.#program = this.#programOf({});
  }

  #programOf(kind: { readonly CUTOUT?: 1 }): Program {
    const defines = { DEPTH_BIAS, ...kind };
    return this.#gpu.program("mesh/depth", meshVert, depthFrag, { defines });
  }

  /** Asks for the programs that models will be drawn with, so that they are compiled by then. */
  prepare(instances: readonly ModelInstance[]): void {
    if (this.#cutOutProgram) return;
    if (!instances.some(({ meshes }) => meshes.some(({ isCutOut }) => isCutOut))) return;
    this.#cutOutProgram = this.#programOf({ CUTOUT: 1 });
  }

  draw(instances: readonly ModelInstance[], target: Draw["target"]): void {
    this.prepare(instances);
    for (const { meshes, placement } of instances) {
      const { oneSided, doubleSided, cutOut } = this.#mergedOf(meshes);
      const draw = (call: Pick<Draw, "program" | "cull" | "textures"> & Partial<Draw>) =>
        this.#gpu.draw({
          ...call,
          target,
          uniforms: { ...call.uniforms, uPlacement: placement },
          blocks: { Frame: this.#frame },
          depth: "test-and-write",
          writesColor: false,
        });
      const program = this.#program;
      if (oneSided.count > 0) draw({ program, vertexArray: oneSided, cull: "back" });
      if (doubleSided.count > 0) draw({ program, vertexArray: doubleSided, cull: "none" });
      for (const { vertexArray, textures, uniforms, isDoubleSided } of cutOut) {
        const cull = isDoubleSided ? "none" : "back";
        draw({ program: this.#cutOutProgram!, vertexArray, textures, uniforms, cull });
      }
    }
  }

  #mergedOf(meshes: readonly Mesh[]): Merged {
    const known = this.#merged.get(meshes);
    if (known) return known;
    const whole = (isTwoSided: boolean) =>
      meshes.filter((mesh) => !mesh.isCutOut && mesh.isDoubleSided === isTwoSided);
    const merged = {
      oneSided: mergedTriangles(this.#gpu, whole(false)),
      doubleSided: mergedTriangles(this.#gpu, whole(true)),
      cutOut: meshes.filter(({ isCutOut }) => isCutOut),
    };
    this.#merged.set(meshes, merged);
    return merged;
  }
}

function mergedTriangles(gpu: Gpu, meshes: readonly Mesh[]): VertexArray {
  const sum = (of: (mesh: Mesh) => number) => meshes.reduce((sum, mesh) => sum + of(mesh), 0);
  const positions = new Float32Array(sum(({ part }) => part.positions.length));
  const indices = new Uint32Array(sum(({ part }) => part.indices.length));
  let [vertex, index] = [0, 0];
  for (const { part } of meshes) {
    positions.set(part.positions, 3 * vertex);
    for (const corner of part.indices) indices[index++] = corner + vertex;
    vertex += part.positions.length / 3;
  }
  return gpu.vertexArray("mesh/depth", {
    attributes: { 0: { buffer: gpu.buffer("mesh/depth positions", positions), size: 3 } },
    indices: { buffer: gpu.buffer("mesh/depth indices", indices, "index"), type: "uint32" },
    count: indices.length,
  });
}
