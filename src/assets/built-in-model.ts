import type { GLTF } from "@gltf-transform/core";
import { assetError, Flaw } from "./asset-error.js";
import { fetchBytes } from "./fetch-bytes.js";
import { openContainer } from "./glb.js";
import {
  AS_STORED,
  closeImage,
  isGlossy,
  type Material,
  type Model,
  type Part,
  PLAIN_MATERIAL,
  type TextureImage,
} from "./model.js";

const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 } as const;
/** Of the components that our own files have. */
const TYPES: Partial<Record<number, typeof Uint8Array | typeof Uint16Array | typeof Float32Array>> =
  { 5121: Uint8Array, 5123: Uint16Array, 5126: Float32Array };
/** Share of the progress that the file takes; its images take the rest. */
const FILE_SHARE = 0.6;

/**
 * Reads a model that our own tools have made: packed, baked, one binary chunk, images beside it.
 *
 * It needs nothing of three.js, which reads visitors' models.
 */
export async function readBuiltInModel(
  url: URL,
  signal: AbortSignal,
  onProgress: (progress: number) => void,
): Promise<Model> {
  const images: Promise<TextureImage>[] = [];
  try {
    const bytes = await fetchBytes(url, {
      signal,
      onProgress: (progress) => onProgress(progress * FILE_SHARE),
    });
    const { json, binary } = openContainer(bytes);
    if (!binary) throw new Flaw("has no binary chunk");
    const document = json as GLTF.IGLTF;
    const image = (index: number) => {
      images[index] ??= readImage(document, index, url, signal);
      return images[index];
    };
    const materials = await Promise.all(
      document.materials?.map((material) => readMaterial(material, image)) ?? [],
    );
    onProgress(1);
    return modelOf(document, binary, materials);
  } catch (error) {
    images.forEach((image) => void image.then(closeImage, () => {}));
    signal.throwIfAborted();
    throw assetError(nameOf(url), error);
  }
}

const nameOf = ({ pathname }: URL) => pathname.split("/").at(-1) ?? "";

async function readImage(
  { textures, images }: GLTF.IGLTF,
  index: number,
  base: URL,
  signal: AbortSignal,
): Promise<TextureImage> {
  const texture = textures?.[index];
  const avif = texture?.extensions?.EXT_texture_avif as GLTF.ITexture | undefined;
  const uri = images?.[avif?.source ?? texture?.source ?? -1]?.uri ?? "";
  try {
    const bytes = await fetchBytes(new URL(uri, base), { signal, isForeign: () => false });
    return await createImageBitmap(new Blob([bytes]), AS_STORED);
  } catch (cause) {
    throw assetError(`The texture ${uri} of ${nameOf(base)}`, cause);
  }
}

async function readMaterial(
  { name = "", pbrMetallicRoughness: pbr = {}, normalTexture }: GLTF.IMaterial,
  image: (index: number) => Promise<TextureImage>,
): Promise<Material> {
  const maps = [pbr.baseColorTexture, pbr.metallicRoughnessTexture, normalTexture];
  const [albedo = null, packed = null, normal = null] = await Promise.all(
    maps.map((map) => map && image(map.index)),
  );
  return {
    ...PLAIN_MATERIAL,
    name,
    baseColor: (pbr.baseColorFactor ?? PLAIN_MATERIAL.baseColor) as Material["baseColor"],
    roughness: pbr.roughnessFactor ?? 1,
    metallic: pbr.metallicFactor ?? 1,
    occlusionStrength: packed ? 1 : 0,
    isWax: name === "wax" || name === "pool",
    // Our maps of all but metals are rough.
    isGlossy: pbr.metallicFactor !== 0 || isGlossy(pbr.roughnessFactor ?? 1, 0),
    albedo,
    normal,
    occlusionRoughnessMetallic: packed,
  };
}

function modelOf(
  { accessors, bufferViews, scenes, nodes, meshes }: GLTF.IGLTF,
  binary: Uint8Array<ArrayBuffer>,
  materials: readonly Material[],
): Model {
  const read = (index: number | undefined) => {
    const accessor = accessors?.[index ?? -1];
    const view = bufferViews?.[accessor?.bufferView ?? -1];
    const Type = TYPES[accessor?.componentType ?? -1];
    if (!accessor || !view || !Type) throw new Flaw("lacks an accessor");
    const count = accessor.count * SIZES[accessor.type];
    const begin = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    // A copy is aligned, and does not keep the file's buffer alive.
    const end = begin + count * Type.BYTES_PER_ELEMENT;
    return new Type(binary.slice(begin, end).buffer);
  };
  const floats = (index: number | undefined) => {
    const values = read(index);
    return values instanceof Uint8Array
      ? Float32Array.from(values, (value) => value / 255)
      : Float32Array.from(values);
  };
  // Nodes beside the scene are lower levels of detail, which nothing here draws.
  const drawn = (scenes ?? []).flatMap((scene) => scene.nodes ?? []);
  const seen = drawn.flatMap((node) => meshes?.[nodes?.[node]?.mesh ?? -1] ?? []);
  const parts = seen.flatMap(({ name = "", primitives }) =>
    primitives.map(({ attributes, indices, material, extras }): Part => {
      const worn = materials[material ?? -1];
      if (!worn) throw new Flaw("lacks a material");
      return {
        name,
        material: worn,
        positions: floats(attributes.POSITION),
        normals: floats(attributes.NORMAL),
        tangents: floats(attributes.TANGENT),
        uvs: floats(attributes.TEXCOORD_0),
        colors: floats(attributes.COLOR_0),
        indices: Uint16Array.from(read(indices)),
        reducedIndices: Uint16Array.from(read(extras?.reducedIndices as number)),
      };
    }),
  );
  const bounds = { min: [0, 0, 0], max: [0, 0, 0] } as const;
  return { parts, anchors: {}, wicks: [], bounds, warnings: [] };
}
