import {
  type BufferAttribute,
  DoubleSide,
  type InterleavedBufferAttribute,
  LoadingManager,
  type Mesh,
  MeshStandardMaterial,
  type Object3D,
  type Texture,
  type Material as ThreeMaterial,
  Vector3,
} from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import type { Material, Model, Part } from "./model.js";

/** A model or texture that could not be had. The message is a sentence for the visitor. */
export class AssetError extends Error {
  override readonly name = "AssetError";
}

export interface LoadOptions {
  readonly signal: AbortSignal;
  /** Called with the share done, 0 to 1. */
  readonly onProgress: (share: number) => void;
}

/** Bytes of the model file count for this share of the progress, its pictures for the rest. */
const FILE_SHARE = 0.3;

/** Fetches and decodes a glTF file and its pictures. Rejects with an `AssetError` that names the file. */
export async function loadModel(url: string, { signal, onProgress }: LoadOptions): Promise<Model> {
  const bytes = await fetchBytes(url, signal, (share) => onProgress(share * FILE_SHARE));
  const missing: string[] = [];
  const manager = new LoadingManager();
  manager.onProgress = (_, loaded, total) => {
    onProgress(FILE_SHARE + (1 - FILE_SHARE) * (loaded / Math.max(total, 1)));
  };
  manager.onError = (failed) => missing.push(failed);
  const gltf = await new GLTFLoader(manager)
    .parseAsync(bytes, new URL(".", url).href)
    .catch((cause: unknown) => {
      throw new AssetError(`${url} is not a model that can be read.`, { cause });
    });
  const model = readScene(gltf.scene);
  if (missing.length > 0) throw new AssetError(`The texture ${missing[0]} could not be loaded.`);
  if (model.parts.length === 0) throw new AssetError(`${url} holds no geometry.`);
  signal.throwIfAborted();
  onProgress(1);
  return model;
}

async function fetchBytes(
  url: string,
  signal: AbortSignal,
  onProgress: (share: number) => void,
): Promise<ArrayBuffer> {
  const response = await fetch(url, { signal }).catch((cause: unknown) => {
    signal.throwIfAborted();
    throw new AssetError(`${url} could not be fetched.`, { cause });
  });
  if (!response.ok) throw new AssetError(`${url} could not be fetched: ${response.status}.`);
  const total = Number(response.headers.get("content-length") ?? 0);
  if (!response.body) return response.arrayBuffer();
  const chunks: Uint8Array[] = [];
  let received = 0;
  const reader = response.body.getReader();
  for (let read = await reader.read(); !read.done; read = await reader.read()) {
    chunks.push(read.value);
    received += read.value.byteLength;
    // With compression on the way the length counts other bytes than we do.
    if (total > 0) onProgress(Math.min(1, received / total));
  }
  return new Blob(chunks as BlobPart[]).arrayBuffer();
}

function readScene(scene: Object3D): Model {
  const parts: Part[] = [];
  const anchors: Record<string, [number, number, number]> = {};
  const materials = new Map<ThreeMaterial, Material>();
  scene.updateMatrixWorld(true);
  scene.traverse((node) => {
    if ("isMesh" in node) {
      parts.push(readMesh(node as Mesh, materials));
    } else if (node.name !== "" && node.children.length === 0) {
      anchors[node.name] = new Vector3().setFromMatrixPosition(node.matrixWorld).toArray();
    }
  });
  return { parts, anchors };
}

function readMesh(mesh: Mesh, materials: Map<ThreeMaterial, Material>): Part {
  const { geometry, matrixWorld } = mesh;
  const three = mesh.material as ThreeMaterial; // glTF has one material a mesh
  const material = materials.get(three) ?? readMaterial(three);
  materials.set(three, material);
  geometry.applyMatrix4(matrixWorld);
  if (!geometry.getAttribute("normal")) geometry.computeVertexNormals();
  const count = geometry.getAttribute("position").count;
  const tangents = geometry.getAttribute("tangent");
  return {
    name: mesh.name,
    material,
    positions: floats(geometry.getAttribute("position")),
    normals: floats(geometry.getAttribute("normal")),
    tangents: tangents ? floats(tangents) : anyTangents(floats(geometry.getAttribute("normal"))),
    uvs: geometry.getAttribute("uv")
      ? floats(geometry.getAttribute("uv"))
      : new Float32Array(count * 2),
    colors: null,
    indices: indicesOf(geometry.index, count),
  };
}

function floats(attribute: BufferAttribute | InterleavedBufferAttribute): Float32Array {
  const size = attribute.itemSize;
  const out = new Float32Array(attribute.count * size);
  for (let i = 0; i < attribute.count; i++) {
    for (let k = 0; k < size; k++) out[i * size + k] = attribute.getComponent(i, k);
  }
  return out;
}

/** Some direction across each normal, for surfaces without texture coordinates to follow. */
function anyTangents(normals: Float32Array): Float32Array {
  const tangents = new Float32Array((normals.length / 3) * 4);
  const normal = new Vector3();
  for (let i = 0; i < normals.length / 3; i++) {
    normal.fromArray(normals, i * 3);
    const across = new Vector3(
      Math.abs(normal.x) < 0.9 ? 1 : 0,
      Math.abs(normal.x) < 0.9 ? 0 : 1,
      0,
    );
    across
      .cross(normal)
      .normalize()
      .toArray(tangents, i * 4);
    tangents[i * 4 + 3] = 1;
  }
  return tangents;
}

function indicesOf(index: BufferAttribute | null, count: number): Uint16Array | Uint32Array {
  const array = index?.array;
  if (array instanceof Uint16Array || array instanceof Uint32Array) return array;
  if (array) return Uint16Array.from(array);
  return Uint32Array.from({ length: count }, (_, i) => i);
}

function readMaterial(three: ThreeMaterial): Material {
  const material = three instanceof MeshStandardMaterial ? three : new MeshStandardMaterial();
  const { r, g, b } = material.color;
  return {
    name: three.name,
    baseColor: [r, g, b, three.opacity],
    roughness: material.roughness,
    metallic: material.metalness,
    normalScale: material.normalScale.x,
    isDoubleSided: three.side === DoubleSide,
    alphaMode: three.alphaTest > 0 ? "mask" : three.transparent ? "blend" : "opaque",
    alphaCutoff: three.alphaTest,
    albedo: bitmapOf(material.map),
    normal: bitmapOf(material.normalMap),
    occlusionRoughnessMetallic: bitmapOf(material.roughnessMap ?? material.aoMap),
  };
}

function bitmapOf(texture: Texture | null): ImageBitmap | null {
  const image: unknown = texture?.image;
  return image instanceof ImageBitmap ? image : null;
}
