import { Matrix3, Matrix4, Vector3 } from "three";
import { Flaw } from "./asset-error.js";
import type { Part } from "./model.js";

/** The arrays of a part while it is made. */
export interface Vertices extends Pick<Part, "positions" | "normals" | "colors"> {
  readonly tangents: Float32Array | null;
  readonly uvs: Float32Array | null;
  readonly indices: Uint32Array;
}

export interface VertexTransforms {
  /** Whether each matrix makes another copy of the whole, or moves one vertex. */
  readonly each: "instance" | "vertex";
  readonly all: readonly Matrix4[];
}

/** The vertices where the matrices put them, a copy for each instance. */
export function transformed(vertices: Vertices, { each, all }: VertexTransforms): Vertices {
  const count = vertices.positions.length / 3;
  const copies = each === "instance" ? all.length : 1;
  const repeated = repeat(vertices, copies, count);
  const { positions, normals, tangents, indices } = repeated;
  const move = new VertexTransform();
  for (let copy = 0; copy < copies; copy++) {
    if (each === "instance") move.set(all[copy] as Matrix4);
    for (let i = 0; i < count; i++) {
      if (each === "vertex") move.set(all[i] as Matrix4);
      const vertex = copy * count + i;
      move.position(positions, vertex);
      move.normal(normals, vertex);
      if (tangents) move.tangent(tangents, vertex);
    }
    const corners = vertices.indices.length;
    // Either all bones of a mesh mirror it or none.
    if (move.isMirror) flipWinding(indices.subarray(copy * corners, (copy + 1) * corners));
  }
  if (!positions.every(Number.isFinite)) throw new Flaw("has positions that are not numbers");
  return repeated;
}

function repeat(vertices: Vertices, copies: number, count: number): Vertices {
  const array = (values: Float32Array) => {
    const all = new Float32Array(values.length * copies);
    for (let copy = 0; copy < copies; copy++) all.set(values, copy * values.length);
    return all;
  };
  const { positions, normals, tangents, uvs, colors, indices } = vertices;
  const all = new Uint32Array(indices.length * copies);
  for (let copy = 0; copy < copies; copy++) {
    all.set(
      indices.map((index) => index + copy * count),
      copy * indices.length,
    );
  }
  return {
    positions: array(positions),
    normals: array(normals),
    tangents: tangents && array(tangents),
    uvs: uvs && array(uvs),
    colors: colors && array(colors),
    indices: all,
  };
}

/** Swaps two corners of each triangle, which restores the winding order after a mirror. */
function flipWinding(indices: Uint32Array): void {
  for (let i = 0; i < indices.length; i += 3) {
    const second = indices[i + 1] as number;
    indices[i + 1] = indices[i + 2] as number;
    indices[i + 2] = second;
  }
}

const UP = new Vector3(0, 1, 0);
const across = new Vector3();
const along = new Vector3();

/** A matrix applied to positions, normals and tangents. */
class VertexTransform {
  isMirror = false;
  readonly #matrix = new Matrix4();
  readonly #normalMatrix = new Matrix3();
  readonly #vector = new Vector3();

  set(matrix: Matrix4): void {
    this.#matrix.copy(matrix);
    this.isMirror = matrix.determinant() < 0;
    // The cofactors: as the inverse's transpose, and also of a matrix with one axis of scale 0.
    const sign = this.isMirror ? -1 : 1;
    for (let i = 0; i < 3; i++) {
      across.setFromMatrixColumn(matrix, (i + 1) % 3);
      across.cross(along.setFromMatrixColumn(matrix, (i + 2) % 3)).multiplyScalar(sign);
      across.toArray(this.#normalMatrix.elements, i * 3);
    }
  }

  position(positions: Float32Array, vertex: number): void {
    this.#vector
      .fromArray(positions, vertex * 3)
      .applyMatrix4(this.#matrix)
      .toArray(positions, vertex * 3);
  }

  normal(normals: Float32Array, vertex: number): void {
    const normal = this.#vector.fromArray(normals, vertex * 3).applyMatrix3(this.#normalMatrix);
    direction(normal, UP).toArray(normals, vertex * 3);
  }

  tangent(tangents: Float32Array, vertex: number): void {
    // As a difference of two positions: no inverse, and no translation.
    const tangent = this.#vector.fromArray(tangents, vertex * 4);
    tangent.applyMatrix3(linear.setFromMatrix4(this.#matrix));
    direction(tangent, ACROSS).toArray(tangents, vertex * 4);
    const sign = (tangents[vertex * 4 + 3] ?? 1) < 0 ? -1 : 1;
    tangents[vertex * 4 + 3] = this.isMirror ? -sign : sign;
  }
}

const ACROSS = new Vector3(1, 0, 0);
const linear = new Matrix3();

/** Normalized, or `otherwise` for a zero or invalid vector. */
function direction(vector: Vector3, otherwise: Vector3): Vector3 {
  const length = vector.length();
  return length > 0 && Number.isFinite(length)
    ? vector.divideScalar(length)
    : vector.copy(otherwise);
}

/** Linear blend skinning: the mean of the bones' matrices. */
export function blendBones(
  bones: readonly Matrix4[],
  joints: Float32Array,
  weights: Float32Array,
): Matrix4 {
  const sum = new Array<number>(16).fill(0);
  for (const [k, weight] of weights.entries()) {
    if (weight === 0) continue;
    const bone = bones[joints[k] ?? -1];
    if (!bone) throw new Flaw(`is broken: a vertex hangs on joint ${joints[k]} of ${bones.length}`);
    for (const [i, element] of bone.elements.entries()) sum[i] = (sum[i] ?? 0) + weight * element;
  }
  return new Matrix4().fromArray(sum);
}
