import { created, type GpuContext, GpuObject } from "./gpu-object.js";
import { FORMATS, Texture, type TextureFormat } from "./texture.js";
import { attachTextures } from "./texture-view.js";

export interface RenderTargetOptions {
  readonly label: string;
  readonly width: number;
  readonly height: number;
  /** Formats of the colour attachments, in the order of the shader's outputs. */
  readonly color: readonly TextureFormat[];
  /** `texture` can be sampled afterwards; `buffer` cannot. Default: none. */
  readonly depth?: "none" | "buffer" | "texture";
  /** Samples per pixel, as many as the device has at most. Above 1 it can only be resolved. */
  readonly samples?: number;
  readonly filter?: "nearest" | "linear";
}

/**
 * A surface that passes draw to: textures to read afterwards, or samples to resolve.
 *
 * Its completeness is queried by `Gpu.check`, since the query blocks.
 */
export class RenderTarget extends GpuObject {
  readonly bytes: number;
  readonly width: number;
  readonly height: number;
  readonly framebuffer: WebGLFramebuffer;
  /** One for each colour format; empty where there are several samples per pixel. */
  readonly colors: readonly Texture[];
  readonly depth: Texture | null = null;
  readonly #renderbuffers: WebGLRenderbuffer[] = [];

  constructor(context: GpuContext, options: RenderTargetOptions, mostSamples: number) {
    super(context, options.label);
    const { gl } = context;
    const { label, width, height, color, depth = "none", filter = "linear" } = options;
    this.width = width;
    this.height = height;
    const samples = Math.min(options.samples ?? 1, mostSamples);
    this.framebuffer = created(gl, gl.createFramebuffer(), label);
    const texture = (name: string, format: TextureFormat, how: "nearest" | "linear") =>
      new Texture(
        { gl, forget: () => {} },
        { label: `${label}/${name}`, format, source: { width, height }, filter: how },
      );
    this.colors = samples > 1 ? [] : color.map((format, i) => texture(String(i), format, filter));
    if (depth === "texture" && samples <= 1) {
      this.depth = texture("depth", "DEPTH_COMPONENT24", "nearest");
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    attachTextures(gl, this.colors, this.depth);
    if (samples > 1) {
      for (const [i, format] of color.entries()) {
        this.#renderbuffer(gl.COLOR_ATTACHMENT0 + i, gl[format], samples);
      }
    }
    if (depth !== "none" && !this.depth) {
      this.#renderbuffer(gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24, samples);
    }
    gl.drawBuffers(color.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    const texel = color.reduce((sum, format) => sum + FORMATS[format].bytes, 0);
    this.bytes = width * height * samples * (texel + (depth === "none" ? 0 : 4));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  get color(): Texture {
    const [first] = this.colors;
    if (!first) throw new Error(`${this.label} holds samples: resolve it to read it.`);
    return first;
  }

  #renderbuffer(attachment: GLenum, format: GLenum, samples: number): void {
    const gl = this.gl;
    const renderbuffer = created(gl, gl.createRenderbuffer(), this.label);
    gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
    // 0 samples: an ordinary one.
    const count = samples > 1 ? samples : 0;
    gl.renderbufferStorageMultisample(gl.RENDERBUFFER, count, format, this.width, this.height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, renderbuffer);
    this.#renderbuffers.push(renderbuffer);
  }

  protected free(): void {
    for (const renderbuffer of this.#renderbuffers) this.gl.deleteRenderbuffer(renderbuffer);
    for (const texture of this.colors) texture.dispose();
    this.depth?.dispose();
    this.gl.deleteFramebuffer(this.framebuffer);
  }
}
