import { created, type GpuObject } from "./gpu-object.js";

/** Storage of one texel: GL's internal format, what uploads it, and its size in bytes. */
export const FORMATS = {
  RGBA8: { upload: "RGBA", type: "UNSIGNED_BYTE", bytes: 4 },
  SRGB8_ALPHA8: { upload: "RGBA", type: "UNSIGNED_BYTE", bytes: 4 },
  RGBA16F: { upload: "RGBA", type: "HALF_FLOAT", bytes: 8 },
  RGBA32F: { upload: "RGBA", type: "FLOAT", bytes: 16 },
} as const;
export type TextureFormat = keyof typeof FORMATS;

export interface TextureOptions {
  readonly label: string;
  readonly format: TextureFormat;
  /** Pixels, or a size for a texture that a pass will draw. */
  readonly source:
    | ImageBitmap
    | { readonly width: number; readonly height: number; readonly data?: ArrayBufferView };
  /** Trilinear, with mipmaps made on the GPU. */
  readonly mipmaps?: boolean;
  readonly filter?: "nearest" | "linear";
  readonly wrap?: "clamp" | "repeat";
  /** Most anisotropic taps; 1 is plain trilinear. */
  readonly anisotropy?: number;
}

/** A two-dimensional texture of immutable storage: a new size means a new texture. */
export class Texture implements GpuObject {
  readonly label: string;
  readonly bytes: number;
  readonly width: number;
  readonly height: number;
  readonly handle: WebGLTexture;
  readonly #gl: WebGL2RenderingContext;
  readonly #forget: (object: GpuObject) => void;

  constructor(
    gl: WebGL2RenderingContext,
    {
      label,
      format,
      source,
      mipmaps = false,
      filter = "linear",
      wrap = "clamp",
      anisotropy = 1,
    }: TextureOptions,
    forget: (object: GpuObject) => void,
  ) {
    this.#gl = gl;
    this.#forget = forget;
    this.label = label;
    this.width = source.width;
    this.height = source.height;
    const levels = mipmaps ? Math.floor(Math.log2(Math.max(source.width, source.height))) + 1 : 1;
    const { upload, type, bytes } = FORMATS[format];
    this.bytes = Math.ceil(source.width * source.height * bytes * (mipmaps ? 4 / 3 : 1));
    this.handle = created(gl, gl.createTexture(), label);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.handle);
    gl.texStorage2D(gl.TEXTURE_2D, levels, gl[format], source.width, source.height);
    if ("close" in source) {
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, gl[upload], gl[type], source);
    } else if (source.data) {
      const { width, height, data } = source;
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl[upload], gl[type], data);
    }
    if (mipmaps) gl.generateMipmap(gl.TEXTURE_2D);
    const minification =
      filter === "nearest" ? gl.NEAREST : mipmaps ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, minification);
    gl.texParameteri(
      gl.TEXTURE_2D,
      gl.TEXTURE_MAG_FILTER,
      filter === "nearest" ? gl.NEAREST : gl.LINEAR,
    );
    const edge = wrap === "repeat" ? gl.REPEAT : gl.CLAMP_TO_EDGE;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, edge);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, edge);
    const extension = anisotropy > 1 ? gl.getExtension("EXT_texture_filter_anisotropic") : null;
    if (extension) {
      const most = gl.getParameter(extension.MAX_TEXTURE_MAX_ANISOTROPY_EXT) as number;
      gl.texParameterf(
        gl.TEXTURE_2D,
        extension.TEXTURE_MAX_ANISOTROPY_EXT,
        Math.min(anisotropy, most),
      );
    }
    gl.bindTexture(gl.TEXTURE_2D, null);
  }

  dispose(): void {
    this.#gl.deleteTexture(this.handle);
    this.#forget(this);
  }
}
