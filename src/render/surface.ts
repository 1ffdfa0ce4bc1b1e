import type { Material, Model, Part } from "../assets/model.js";
import type { Gpu } from "../gl/gpu.js";
import type { Texture } from "../gl/texture.js";
import type { VertexArray } from "../gl/vertex-array.js";

/** Taps of anisotropic filtering: floors and walls are mostly seen at grazing angles. */
const ANISOTROPY = 8;

/** A part of a model on the GPU. */
export interface Surface {
  readonly name: string;
  readonly vertexArray: VertexArray;
  readonly baseColor: readonly [number, number, number, number];
  readonly textures: {
    readonly uAlbedo: Texture;
    readonly uNormal: Texture;
    readonly uOcclusionRoughness: Texture;
  };
}

/** Sends a model to the GPU, each picture once. */
export function uploadModel(
  gpu: Gpu,
  model: Model,
  { anisotropy }: { anisotropy: boolean },
): Surface[] {
  const textures = new Map<ImageBitmap, Texture>();
  const plain = (label: string, texel: readonly [number, number, number]) =>
    gpu.texture({
      label,
      format: "RGBA8",
      source: { width: 1, height: 1, data: Uint8Array.of(...texel, 255) },
    });
  const white = plain("white", [255, 255, 255]);
  const flat = plain("flat normal", [128, 128, 255]);
  const picture = (label: string, format: "RGBA8" | "SRGB8_ALPHA8", source: ImageBitmap) => {
    const known = textures.get(source);
    if (known) return known;
    const texture = gpu.texture({
      label,
      format,
      source,
      mipmaps: true,
      wrap: "repeat",
      anisotropy: anisotropy ? ANISOTROPY : 1,
    });
    textures.set(source, texture);
    return texture;
  };
  const upload = ({ name, material, ...part }: Part): Surface => ({
    name,
    vertexArray: uploadTriangles(gpu, name, part),
    baseColor: material.baseColor,
    textures: {
      uAlbedo: pictureOr(white, material, "albedo", "SRGB8_ALPHA8"),
      uNormal: pictureOr(flat, material, "normal", "RGBA8"),
      uOcclusionRoughness: pictureOr(white, material, "occlusionRoughnessMetallic", "RGBA8"),
    },
  });
  const pictureOr = (
    stand_in: Texture,
    material: Material,
    map: "albedo" | "normal" | "occlusionRoughnessMetallic",
    format: "RGBA8" | "SRGB8_ALPHA8",
  ) => {
    const source = material[map];
    return source ? picture(`${material.name}/${map}`, format, source) : stand_in;
  };
  return model.parts.map(upload);
}

function uploadTriangles(
  gpu: Gpu,
  name: string,
  part: Pick<Part, "positions" | "normals" | "tangents" | "uvs" | "indices">,
): VertexArray {
  return gpu.vertexArray(name, {
    attributes: {
      0: { buffer: gpu.buffer(`${name}/positions`, part.positions), size: 3 },
      1: { buffer: gpu.buffer(`${name}/normals`, part.normals), size: 3 },
      2: { buffer: gpu.buffer(`${name}/tangents`, part.tangents), size: 4 },
      3: { buffer: gpu.buffer(`${name}/uvs`, part.uvs), size: 2 },
    },
    indices: {
      buffer: gpu.buffer(`${name}/indices`, part.indices, "index"),
      type: part.indices instanceof Uint16Array ? "uint16" : "uint32",
    },
    count: part.indices.length,
  });
}
