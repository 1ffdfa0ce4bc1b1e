import { created, type GpuContext, GpuObject } from "./gpu-object.js";

/** Texture formats: the upload format and type, and bytes per texel. Keys are GL's internal formats. */
export const FORMATS = {
  R8: { upload: "RED", type: "UNSIGNED_BYTE", bytes: 1 },
  RG8: { upload: "RG", type: "UNSIGNED_BYTE", bytes: 2 },
  RGB8: { upload: "RGB", type: "UNSIGNED_BYTE", bytes: 4 },
  RGBA8: { upload: "RGBA", type: "UNSIGNED_BYTE", bytes: 4 },
  SRGB8_ALPHA8: { upload: "RGBA", type: "UNSIGNED_BYTE", bytes: 4 },
  R16F: { upload: "RED", type: "HALF_FLOAT", bytes: 2 },
  RG16F: { upload: "RG", type: "HALF_FLOAT", bytes: 4 },
  RGBA16F: { upload: "RGBA", type: "HALF_FLOAT", bytes: 8 },
  R11F_G11F_B10F: { upload: "RGB", type: "UNSIGNED_INT_10F_11F_11F_REV", bytes: 4 },
  R32F: { upload: "RED", type: "FLOAT", bytes: 4 },
  RG32F: { upload: "RG", type: "FLOAT", bytes: 8 },
  RGBA32F: { upload: "RGBA", type: "FLOAT", bytes: 16 },
  DEPTH_COMPONENT16: { upload: "DEPTH_COMPONENT", type: "UNSIGNED_SHORT", bytes: 2 },
  DEPTH_COMPONENT24: { upload: "DEPTH_COMPONENT", type: "UNSIGNED_INT", bytes: 4 },
} as const;
export type TextureFormat = keyof typeof FORMATS;

/** Pixels, rows from the top as in an image file. */
interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: ArrayBufferView;
}

export interface TextureOptions {
  readonly label: string;
  readonly format: TextureFormat;
  /** Pixels, or a size for a texture that a pass will draw. */
  readonly source: ImageBitmap | Pixels | { readonly width: number; readonly height: number };
  /** A cube has six square faces, and takes only a size. Default: 2D. */
  readonly shape?: "2d" | "cube";
  /** Trilinear, with mipmaps that `updateMipmaps` makes on the GPU. */
  readonly mipmaps?: boolean;
  readonly filter?: "nearest" | "linear";
  readonly wrap?: "clamp" | "repeat";
}

/** A texture of immutable storage: a new size means a new texture. */
export class Texture extends GpuObject {
  readonly #format: TextureFormat;
  readonly bytes: number;
  readonly width: number;
  readonly height: number;
  readonly hasMipmaps: boolean;
  /** Whether its mipmaps were never made. */
  needsMipmaps: boolean;
  readonly handle: WebGLTexture;
  /** GL's binding point. */
  readonly target: GLenum;

  constructor(context: GpuContext, options: TextureOptions) {
    super(context, options.label);
    const { gl } = context;
    const { label, format, source, shape = "2d", mipmaps = false } = options;
    const { width, height } = source;
    this.#format = format;
    this.width = width;
    this.height = height;
    this.hasMipmaps = mipmaps;
    this.needsMipmaps = mipmaps;
    const texels = width * height * (shape === "cube" ? 6 : 1) * (mipmaps ? 4 / 3 : 1);
    this.bytes = Math.ceil(texels * FORMATS[format].bytes);
    this.handle = created(gl, gl.createTexture(), label);
    this.target = shape === "cube" ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_2D;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(this.target, this.handle);
    const levels = mipmaps ? Math.floor(Math.log2(Math.max(width, height))) + 1 : 1;
    gl.texStorage2D(this.target, levels, gl[format], width, height);
    this.#upload(source);
    this.#sample(options);
    gl.bindTexture(this.target, null);
  }

  updateMipmaps(): void {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(this.target, this.handle);
    gl.generateMipmap(this.target);
    gl.bindTexture(this.target, null);
    this.needsMipmaps = false;
  }

  #upload(source: TextureOptions["source"]): void {
    const gl = this.gl;
    const { upload, type: stored } = FORMATS[this.#format];
    const { width, height } = source;
    // The driver makes halves of floats.
    const isFloats = "data" in source && source.data instanceof Float32Array;
    const type = isFloats ? "FLOAT" : stored;
    // Rows of one or two bytes a texel need not end on a multiple of four.
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    if ("close" in source) {
      gl.texSubImage2D(this.target, 0, 0, 0, gl[upload], gl[type], source);
    } else if ("data" in source) {
      gl.texSubImage2D(this.target, 0, 0, 0, width, height, gl[upload], gl[type], source.data);
    }
  }

  /** Replaces the texels of a two-dimensional texture without mipmaps. */
  update(data: ArrayBufferView): void {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(this.target, this.handle);
    this.#upload({ width: this.width, height: this.height, data });
    gl.bindTexture(this.target, null);
  }

  #sample({ mipmaps, filter = "linear", wrap = "clamp" }: TextureOptions): void {
    const gl = this.gl;
    const { target } = this;
    const magnification = filter === "nearest" ? gl.NEAREST : gl.LINEAR;
    const minification = mipmaps ? gl.LINEAR_MIPMAP_LINEAR : magnification;
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, minification);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, magnification);
    const edge = wrap === "repeat" ? gl.REPEAT : gl.CLAMP_TO_EDGE;
    gl.texParameteri(target, gl.TEXTURE_WRAP_S, edge);
    gl.texParameteri(target, gl.TEXTURE_WRAP_T, edge);
  }

  protected free(): void {
    this.gl.deleteTexture(this.handle);
  }
}
