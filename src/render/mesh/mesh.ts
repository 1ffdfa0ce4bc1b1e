import type { Material, Model, Part, TextureImage } from "../../assets/model.js";
import type { Gpu, Texture, TextureFormat, VertexArray } from "../../gl/gpu.js";
import type { Cluster, Grouped } from "./clusters.js";

/** Anisotropic filtering of material textures, for floors and walls at grazing angles. */
const ANISOTROPIC = {
  uAlbedo: { anisotropy: 8 },
  uNormal: { anisotropy: 8 },
  uOcclusionRoughness: { anisotropy: 8 },
} as const;

/** Sampling of material textures at a tier. */
export function surfaceSampling({ anisotropy }: { readonly anisotropy: boolean }) {
  return anisotropy ? ANISOTROPIC : {};
}

/** A mesh on the GPU: a part of a model, of one material. */
export interface Mesh {
  readonly part: Part;
  readonly vertexArray: VertexArray;
  /** Its triangles by place; empty if they were not grouped. */
  readonly clusters: readonly Cluster[];
  /** Of all triangles, m²; 0 if they were not grouped. */
  readonly area: number;
  readonly isDoubleSided: boolean;
  readonly isGlossy: boolean;
  readonly isCutOut: boolean;
  readonly isUntextured: boolean;
  readonly isWax: boolean;
  readonly isWick: boolean;
  /** Whether it is glass before the dark. */
  readonly isPane: boolean;
  /** Of `lib/material.glsl`, as the textures. */
  readonly uniforms: {
    readonly uBaseColor: readonly [number, number, number, number];
    readonly uOcclusionStrength: number;
    /** Roughness, metallic, normal scale, alpha cutoff. */
    readonly uSurface: readonly [number, number, number, number];
  };
  readonly textures: {
    readonly uAlbedo: Texture;
    readonly uNormal: Texture;
    readonly uOcclusionRoughness: Texture;
  };
}

/**
 * Uploads a model: each image once, and each model once for all renderers.
 *
 * @param group sorts the triangles of a part by place
 */
export function uploadModel(
  gpu: Gpu,
  model: Model,
  group?: (part: Part) => Grouped,
): readonly Mesh[] {
  return gpu.share(model, () => model.parts.map((part) => uploadPart(gpu, part, group)));
}

/** Meshes from the smallest to the largest: walls and floor are behind all else, so early depth tests hide them. */
export function sortedByArea(surfaces: readonly Mesh[]): readonly Mesh[] {
  return surfaces.toSorted((a, b) => a.area - b.area);
}

function isWick(name: string): boolean {
  return /^wick(?![a-z])/.test(name);
}

/** Texels of the textures of materials that have none. */
const WHITE = Uint8Array.of(255, 255, 255, 255);
const FLAT_NORMAL = Uint8Array.of(128, 128, 255, 255);

/** What all models on a context share. */
export function plainTextures(gpu: Gpu) {
  const texel = (label: string, data: Uint8Array) =>
    gpu.texture({ label, format: "RGBA8", source: { width: 1, height: 1, data } });
  return gpu.share(WHITE, () => ({
    white: texel("white", WHITE),
    flatNormal: texel("flat normal", FLAT_NORMAL),
  }));
}

/** Uploads a part of a model, once for all renderers. */
export function uploadPart(gpu: Gpu, part: Part, group?: (part: Part) => Grouped): Mesh {
  return gpu.share(part, () => {
    const { material } = part;
    const { albedo, normal, packed } = imagesOf(material);
    const { white, flatNormal } = plainTextures(gpu);
    const { indices, clusters, area } = group?.(part) ?? { ...part, clusters: [], area: 0 };
    return {
      part,
      vertexArray: uploadTriangles(gpu, { ...part, indices }),
      clusters,
      area,
      isDoubleSided: material.isDoubleSided,
      ...kindOf(material),
      isUntextured: !albedo.source && !normal.source && !packed.source,
      isWax: material.name === "wax" || material.name === "pool",
      isWick: isWick(material.name) || isWick(part.name),
      isPane: material.name === "pane",
      uniforms: {
        uBaseColor: material.baseColor,
        uOcclusionStrength: material.occlusionStrength,
        uSurface: [material.roughness, material.metallic, material.normalScale, cutoffOf(material)],
      },
      textures: {
        uAlbedo: textureOf(gpu, albedo) ?? white,
        uNormal: textureOf(gpu, normal) ?? flatNormal,
        uOcclusionRoughness: textureOf(gpu, packed) ?? white,
      },
    };
  });
}

/** An image of a material, and its format on the GPU. */
interface Mapped {
  readonly label: string;
  readonly format: TextureFormat;
  readonly source: TextureImage | null;
}

export function imagesOf(material: Material): Record<"albedo" | "normal" | "packed", Mapped> {
  const { name, albedo, normal, occlusionRoughnessMetallic: packed, metallic } = material;
  return {
    albedo: { label: `${name}/albedo`, format: "SRGB8_ALPHA8", source: albedo },
    // Two channels: the third of a unit vector follows from them.
    normal: { label: `${name}/normal`, format: channels(normal, "RG8"), source: normal },
    // Metallic is the third channel.
    packed: {
      label: `${name}/occlusion`,
      format: channels(packed, metallic > 0 ? "RGBA8" : "RG8"),
      source: packed,
    },
  };
}

/** The texture of an image, made once. */
function textureOf(gpu: Gpu, mapped: Mapped): Texture | null {
  const texture = mapped.source && shareTexture(gpu, mapped, mapped.source);
  if (texture?.needsMipmaps) texture.updateMipmaps();
  return texture;
}

/** The same, perhaps without its mipmaps. */
export function shareTexture(gpu: Gpu, mapped: Mapped, source: TextureImage): Texture {
  return gpu.share(textureKey(gpu, mapped), () =>
    gpu.texture({ ...mapped, source, mipmaps: true, wrap: "repeat" }),
  );
}

/** Stands for an image in a format: of two materials that share one, one may read its metallic channel alone. */
export function textureKey(
  gpu: Gpu,
  { source, format }: Pick<Mapped, "source" | "format">,
): object {
  const keys = gpu.share(source, (): Partial<Record<TextureFormat, object>> => ({}));
  keys[format] ??= {};
  return keys[format];
}

// Images decoded by a script have four channels, which WebGL does not repack.
function channels(image: TextureImage | null, format: TextureFormat): TextureFormat {
  return image && "data" in image ? "RGBA8" : format;
}

/** What of a material chooses the program of forward shading. */
export function kindOf({ isGlossy, alphaMode }: Material): Pick<Mesh, "isGlossy" | "isCutOut"> {
  return { isGlossy, isCutOut: alphaMode !== "opaque" };
}

/** Opacity below which nothing is drawn. */
export function cutoffOf({ alphaMode, alphaCutoff }: Material): number {
  return alphaMode === "opaque" ? 0 : alphaMode === "mask" ? alphaCutoff : 0.5;
}

/** Whether nothing or little of a part is drawn, as of glass. */
export function isMostlyClear({ material }: Pick<Part, "material">): boolean {
  const { alphaMode, baseColor, mapOpacity } = material;
  return alphaMode !== "opaque" && baseColor[3] * mapOpacity < cutoffOf(material);
}

/** Vertices and triangles of a part, in the layout of mesh/mesh.vert. */
export function uploadTriangles(gpu: Gpu, part: Part): VertexArray {
  const { name, positions, normals, tangents, uvs, indices } = part;
  const colors = part.colors ?? new Float32Array((positions.length / 3) * 4).fill(1);
  return gpu.vertexArray(name, {
    attributes: {
      0: { buffer: gpu.buffer(`${name}/positions`, positions), size: 3 },
      1: { buffer: gpu.buffer(`${name}/normals`, normals), size: 3 },
      2: { buffer: gpu.buffer(`${name}/tangents`, tangents), size: 4 },
      3: { buffer: gpu.buffer(`${name}/uvs`, uvs), size: 2 },
      4: { buffer: gpu.buffer(`${name}/colors`, colors), size: 4 },
    },
    indices: {
      buffer: gpu.buffer(`${name}/indices`, indices, "index"),
      type: indices instanceof Uint16Array ? "uint16" : "uint32",
    },
    count: indices.length,
  });
}
