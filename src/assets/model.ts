/** Model: a file's meshes as plain typed arrays in its own coordinates: metres, +Y up. */
export interface Model {
  readonly parts: readonly Part[];
  /** The nodes `spawn` and `moon`, where no meshes are below them, by name. */
  readonly anchors: Readonly<Record<string, Anchor>>;
  /** Wicks, in the file's order. */
  readonly wicks: readonly Wick[];
  /** The box around all positions, metres. */
  readonly bounds: Box;
  /** Sentences about features of the file that are not supported. */
  readonly warnings: readonly string[];
}

export interface Anchor {
  /** Metres. */
  readonly position: readonly [number, number, number];
  /** Where its -Z points on the floor: radians, counter-clockwise from above, 0 along -Z. */
  readonly yaw: number;
  /** Its -Z, of length 1. */
  readonly forward: readonly [number, number, number];
}

/** A node named `wick…`: a candle burns there. Metres. */
export interface Wick {
  readonly name: string;
  /** Root of its flame. */
  readonly position: readonly [number, number, number];
  readonly wickDiameter: number;
}

export interface Box {
  readonly min: readonly [number, number, number];
  readonly max: readonly [number, number, number];
}

/** Triangles of one material, transforms applied; counter-clockwise ones face the camera. */
export interface Part {
  readonly name: string;
  readonly material: Material;
  /** xyz, metres. */
  readonly positions: Float32Array;
  /** xyz of length 1. */
  readonly normals: Float32Array;
  /** xyz of length 1 and the bitangent's sign. */
  readonly tangents: Float32Array;
  /** uv of every map, (0, 0) at the image's top left; zeros where there are none. */
  readonly uvs: Float32Array;
  /** rgba, linear Rec. 709 and opacity, 0 to 1; multiplies the base colour. */
  readonly colors: Float32Array | null;
  /** Three to a triangle. */
  readonly indices: Uint16Array | Uint32Array;
  /** Fewer triangles of the same vertices: the lower level of detail, where the file has one. */
  readonly reducedIndices?: Uint16Array | Uint32Array;
}

/** Rows from the top, red, green, blue and alpha of 8 bits where they are bytes; alpha is not multiplied in. */
export type TextureImage =
  | ImageBitmap
  | { readonly width: number; readonly height: number; readonly data: Uint8Array };

export type Material = Readonly<typeof PLAIN_MATERIAL>;

/** White and rough: what a material is where nothing is said of it. */
export const PLAIN_MATERIAL = {
  name: "",
  /** Linear Rec. 709 and opacity; multiplies the albedo map. */
  baseColor: [1, 1, 1, 1] as readonly [number, number, number, number],
  /** Multiplies the map's green. */
  roughness: 1,
  /** Multiplies the map's blue. */
  metallic: 0,
  /** Multiplies x and y of the normal map. */
  normalScale: 1,
  /** How much of the occlusion counts, 0 to 1; 0 where the material has none, whatever a map's red holds. */
  occlusionStrength: 0,
  /** Whether back faces are drawn, too. */
  isDoubleSided: false,
  /** Whether light that enters it leaves elsewhere, as of wax. */
  isWax: false,
  /** Whether it mirrors what is around it: metal, or smooth somewhere. */
  isGlossy: false,
  /** Share of the light that passes through it, as through glass, 0 to 1. */
  transmission: 0,
  /** Opacity: ignored, all or nothing at `alphaCutoff`, or mixed. */
  alphaMode: "opaque" as "opaque" | "mask" | "blend",
  /** Opacity below which a mask leaves a hole. */
  alphaCutoff: 0.5,
  /** Opacity of the albedo map: its mean where it is mixed, that of its most opaque part under a mask; else 1. */
  mapOpacity: 1,
  /** sRGB and opacity. */
  albedo: null as TextureImage | null,
  /** Tangent space, +Y up in the image, as glTF has it. */
  normal: null as TextureImage | null,
  /** Red: occlusion, green: roughness, blue: metallic. */
  occlusionRoughnessMetallic: null as TextureImage | null,
};

/** Whether a surface mirrors what is around it: the limits of `shaders/opaque/forward.frag`. */
export function isGlossy(roughness: number, metallic: number): boolean {
  return roughness - 0.25 * metallic < 0.3;
}

/** Values of an image as in the file: they may be normals. */
export const AS_STORED = { premultiplyAlpha: "none", colorSpaceConversion: "none" } as const;

/** Frees the images. The model is of no use afterwards. */
export function closeModel({ parts }: Model): void {
  for (const { material } of parts) {
    const { albedo, normal, occlusionRoughnessMetallic } = material;
    for (const image of [albedo, normal, occlusionRoughnessMetallic]) {
      if (image) closeImage(image);
    }
  }
}

export function closeImage(image: TextureImage): void {
  if ("close" in image) image.close();
}
