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
  readonly indices: Uint16Array | Uint32Array;
}

export interface Material {
  readonly name: string;
  /** Linear Rec. 709 and opacity; multiplies the albedo map. */
  readonly baseColor: readonly [number, number, number, number];
  readonly roughness: number;
  readonly metallic: number;
  readonly albedo: ImageBitmap | null;
  readonly normal: ImageBitmap | null;
  /** Red: occlusion, green: roughness, blue: metallic. */
  readonly occlusionRoughnessMetallic: ImageBitmap | null;
}

/** Frees the pictures. The model is of no use afterwards. */
export function closeModel({ parts }: Model): void {
  for (const { material } of parts) {
    material.albedo?.close();
    material.normal?.close();
    material.occlusionRoughnessMetallic?.close();
  }
}
