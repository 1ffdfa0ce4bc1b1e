import {
  BufferAttribute,
  BufferGeometry,
  type InstancedMesh,
  type InterleavedBufferAttribute,
  Matrix4,
  type Mesh,
  type SkinnedMesh,
} from "three";
import { Flaw } from "./asset-error.js";
import type { Part } from "./model.js";
import type { PlacedMaterial } from "./read-material.js";
import { anyTangents, replaceBadTangents, splitAtMirrors, tangentsOf } from "./tangents.js";
import { placedUvs } from "./texture-placement.js";
import {
  blendBones,
  transformed,
  type VertexTransforms,
  type Vertices,
} from "./transform-vertices.js";

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Triangles that get a vertex of their own for each corner; beyond, they share smooth normals. */
const MOST_FLAT_TRIANGLES = 300_000;

/** A mesh as plain arrays, in the room's coordinates and its rest pose; null where nothing of it is drawn. */
export function readPart(
  mesh: Mesh,
  name: string,
  { material, placement }: PlacedMaterial,
): Part | null {
  const geometry = withNormals(morphed(mesh, withoutUnused(mesh.geometry)));
  const position = geometry.getAttribute("position");
  const indices = indicesOf(geometry, position.count);
  const moves = matricesOf(mesh, geometry);
  if (indices.length === 0 || moves.all.length === 0) return null;
  const uv = geometry.getAttribute(uvName(placement.uvSet));
  const tangent = geometry.getAttribute("tangent");
  const color = geometry.getAttribute("color");
  const vertices = transformed(
    {
      positions: floats(position),
      normals: floats(geometry.getAttribute("normal")),
      tangents: tangent ? floats(tangent) : null,
      uvs: uv ? placedUvs(floats(uv), placement) : null,
      colors: color ? colorsOf(color) : null,
      indices,
    },
    moves,
  );
  const reducedIndices = reducedOf(mesh, moves, position.count);
  return {
    name,
    material,
    ...finished(vertices, material.normal !== null),
    ...(reducedIndices && { reducedIndices }),
  };
}

/** The triangles of the lower level of detail; null where the vertices are no longer those of the file. */
function reducedOf({ geometry, matrixWorld }: Mesh, moves: VertexTransforms, count: number) {
  const { userData, attributes } = geometry;
  const corners: unknown = userData.reducedIndices;
  const isWhole = attributes.position?.count === count && attributes.normal;
  const isSame = isWhole && moves.all[0] === matrixWorld;
  if (!ArrayBuffer.isView(corners) || !isSame || matrixWorld.determinant() < 0) return null;
  const reduced = Uint32Array.from(corners as Uint16Array);
  for (const vertex of reduced) checkVertex(vertex, count);
  return reduced.subarray(0, reduced.length - (reduced.length % 3));
}

const uvName = (set: number) => (set === 0 ? "uv" : set < 4 ? `uv${set}` : `texcoord_${set}`);

function finished(read: Vertices, hasRelief: boolean) {
  const hasFrames = hasRelief && read.uvs && !read.tangents;
  const vertices = hasFrames ? splitAtMirrors(read, read.uvs) : read;
  const { positions, normals, tangents, uvs, indices } = vertices;
  const count = positions.length / 3;
  const made = () => (hasRelief && uvs ? tangentsOf(vertices, uvs) : anyTangents(normals));
  return {
    ...vertices,
    tangents: tangents ? replaceBadTangents(tangents, normals) : made(),
    uvs: uvs ?? new Float32Array(count * 2),
    indices: count <= 0xffff ? Uint16Array.from(indices) : indices,
  };
}

/** glTF wants flat triangles where the normals are missing: specification, section 3.7.2.1. */
function withNormals(geometry: BufferGeometry): BufferGeometry {
  if (geometry.getAttribute("normal")) return geometry;
  const corners = geometry.index?.count ?? 0;
  const isShared = corners > 0 && corners / 3 <= MOST_FLAT_TRIANGLES;
  if (isShared) indicesOf(geometry, geometry.getAttribute("position").count);
  const flat = isShared ? geometry.toNonIndexed() : geometry.clone();
  flat.deleteAttribute("tangent"); // valid for the removed normals only
  flat.computeVertexNormals();
  return flat;
}

function indicesOf({ index }: BufferGeometry, count: number): Uint32Array {
  const corners = index?.count ?? count;
  const indices = new Uint32Array(corners - (corners % 3));
  for (let i = 0; i < indices.length; i++) {
    const vertex = index ? index.getX(i) : i;
    checkVertex(vertex, count);
    indices[i] = vertex;
  }
  return indices;
}

function checkVertex(vertex: number, count: number): void {
  if (vertex >= count) throw new Flaw(`is broken: a triangle has vertex ${vertex} of ${count}`);
}

function floats(attribute: Attribute): Float32Array {
  const { count, itemSize } = attribute;
  const isPlain =
    attribute.array instanceof Float32Array && attribute.array.length === count * itemSize;
  if (isPlain) return attribute.array as Float32Array;
  const values = new Float32Array(count * itemSize);
  for (let i = 0; i < count; i++) {
    for (let k = 0; k < itemSize; k++) values[i * itemSize + k] = attribute.getComponent(i, k);
  }
  return values;
}

/** Vertex colours, RGB or RGBA. Some exporters omit the flag `normalized`. */
function colorsOf(attribute: Attribute): Float32Array {
  const values = floats(attribute);
  const { itemSize, normalized, array } = attribute;
  const isCount = !normalized && !(array instanceof Float32Array);
  const whole = !isCount ? 1 : array.BYTES_PER_ELEMENT === 1 ? 0xff : 0xffff;
  const colors = new Float32Array(attribute.count * 4).fill(1);
  for (let i = 0; i < attribute.count; i++) {
    for (let k = 0; k < itemSize; k++) {
      const value = (values[i * itemSize + k] ?? 0) / whole;
      colors[i * 4 + k] = value > 0 ? Math.min(value, 1) : 0;
    }
  }
  return colors;
}

/** The geometry in its rest pose. */
function morphed(mesh: Mesh, geometry: BufferGeometry): BufferGeometry {
  const { position: positions = [], normal: normals = [] } = geometry.morphAttributes;
  if (positions.length === 0) return geometry;
  const posed = geometry.clone();
  for (const [name, targets] of Object.entries({ position: positions, normal: normals })) {
    if (targets.length === 0) continue;
    const values = floats(geometry.getAttribute(name)).slice();
    for (const [t, target] of targets.entries()) {
      const weight = mesh.morphTargetInfluences?.[t] ?? 0;
      if (weight === 0) continue;
      for (const [i, offset] of floats(target).entries())
        values[i] = (values[i] ?? 0) + weight * offset;
    }
    posed.setAttribute(name, new BufferAttribute(values, 3));
  }
  return posed;
}

/** Numbers of vertices from 1, and 0 between two meshes: an array for each mesh takes long where many share vertices. */
const numbersOf = new WeakMap<Attribute, Uint32Array>();

/** A geometry of the vertices that its triangles use: many may share the vertices of one accessor. */
function withoutUnused(geometry: BufferGeometry): BufferGeometry {
  const { index, userData } = geometry;
  const position = geometry.getAttribute("position");
  const { count } = position;
  // Lower levels of detail come from our own tools, which leave nothing unused.
  const isOurs = userData.reducedIndices !== undefined && count <= (index?.count ?? 0);
  if (!index || isOurs) return geometry;
  const indices = indicesOf(geometry, count);
  const numbers = numbersOf.get(position) ?? new Uint32Array(count);
  numbersOf.set(position, numbers);
  const used: number[] = [];
  for (const [i, vertex] of indices.entries()) {
    numbers[vertex] ||= used.push(vertex);
    indices[i] = (numbers[vertex] ?? 0) - 1;
  }
  for (const vertex of used) numbers[vertex] = 0;
  if (used.length === count) return geometry;
  const pick = ({ array, itemSize, normalized }: Attribute) => {
    const values = array.slice(0, used.length * itemSize);
    for (const [i, vertex] of used.entries()) {
      for (let k = 0; k < itemSize; k++)
        values[i * itemSize + k] = array[vertex * itemSize + k] ?? 0;
    }
    return new BufferAttribute(values, itemSize, normalized);
  };
  const compact = new BufferGeometry().setIndex(new BufferAttribute(indices, 1));
  for (const [name, attribute] of Object.entries(geometry.attributes)) {
    compact.setAttribute(name, pick(attribute));
  }
  for (const name of ["position", "normal"] as const) {
    const targets = geometry.morphAttributes[name];
    if (targets) compact.morphAttributes[name] = targets.map(pick);
  }
  return compact;
}

/** Where a mesh stands: for each of its instances, or for each of its vertices if it has bones. */
function matricesOf(mesh: Mesh, geometry: BufferGeometry): VertexTransforms {
  if (isSkinned(mesh)) return { each: "vertex", all: skinMatrices(mesh, geometry) };
  if (!isInstanced(mesh)) return { each: "instance", all: [mesh.matrixWorld] };
  const all = Array.from({ length: mesh.count }, (_, i) => {
    const instance = new Matrix4();
    mesh.getMatrixAt(i, instance);
    return instance.premultiply(mesh.matrixWorld);
  });
  return { each: "instance", all };
}

const isSkinned = (mesh: Mesh): mesh is SkinnedMesh =>
  "isSkinnedMesh" in mesh && Boolean((mesh as SkinnedMesh).skeleton);

const isInstanced = (mesh: Mesh): mesh is InstancedMesh => "isInstancedMesh" in mesh;

/** Bones replace the transform of the mesh's own node: specification, section 3.7.3.3. */
function skinMatrices({ skeleton }: SkinnedMesh, geometry: BufferGeometry): Matrix4[] {
  const bones = skeleton.bones.map((bone, i) =>
    new Matrix4().multiplyMatrices(bone.matrixWorld, skeleton.boneInverses[i] ?? new Matrix4()),
  );
  const joints = floats(geometry.getAttribute("skinIndex"));
  const weights = floats(geometry.getAttribute("skinWeight"));
  return Array.from({ length: joints.length / 4 }, (_, i) =>
    blendBones(bones, joints.subarray(i * 4, i * 4 + 4), weights.subarray(i * 4, i * 4 + 4)),
  );
}
