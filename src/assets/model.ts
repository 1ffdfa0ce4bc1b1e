/** What a model file holds, as plain typed arrays in the model's own coordinates: metres, +Y up. */
export interface Model {
  readonly parts: readonly Part[];
  /** Where named nodes without geometry stand. */
  readonly anchors: Readonly<Record<string, readonly [number, number, number]>>;
}

/** Triangles of one material, transforms applied. */
export interface Part {
  readonly name: string;
  readonly material: Material;
  /** xyz */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** xyz and the bitangent's sign. */
  readonly tangents: Float32Array;
  readonly uvs: Float32Array;
  /** rgba, linear; null where the model has none. */
  readonly colors: Float32Array | null;
  readonly indices: Uint16Array | Uint32Array;
}

export interface Material {
  readonly name: string;
  /** Linear Rec. 709 and opacity; multiplies the albedo map. */
  readonly baseColor: readonly [number, number, number, number];
  readonly roughness: number;
  readonly metallic: number;
  readonly normalScale: number;
  readonly isDoubleSided: boolean;
  readonly alphaMode: "opaque" | "mask" | "blend";
  /** Opacity below which a masked material is not there. */
  readonly alphaCutoff: number;
  readonly albedo: Picture | null;
  readonly normal: Picture | null;
  /** Red: occlusion, green: roughness, blue: metallic. */
  readonly occlusionRoughnessMetallic: Picture | null;
}

/** A decoded picture: the browser's, or RGBA bytes, rows from the top. */
export type Picture =
  | ImageBitmap
  | { readonly width: number; readonly height: number; readonly data: Uint8Array };

/** Frees the pictures. The model is of no use afterwards. */
export function closeModel({ parts }: Model): void {
  for (const { material } of parts) {
    close(material.albedo);
    close(material.normal);
    close(material.occlusionRoughnessMetallic);
  }
}

function close(picture: Picture | null): void {
  if (picture && "close" in picture) picture.close();
}
