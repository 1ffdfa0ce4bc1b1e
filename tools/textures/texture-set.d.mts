export interface TextureSet {
  readonly resolution: number;
  readonly albedo: Uint8Array;
  readonly normal: Uint8Array;
  readonly orm: Uint8Array;
}

export function textureSet(name: string, resolution?: number): TextureSet;
