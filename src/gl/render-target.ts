import { created, type GpuObject } from "./gpu-object.js";

export interface RenderTargetOptions {
  readonly label: string;
  readonly width: number;
  readonly height: number;
  /** Samples per pixel, as many as the device has at most. */
  readonly samples: number;
}

/** A multisampled 8-bit colour and depth surface, to be resolved to the canvas. */
export class RenderTarget implements GpuObject {
  readonly label: string;
  readonly bytes: number;
  readonly width: number;
  readonly height: number;
  readonly samples: number;
  readonly framebuffer: WebGLFramebuffer;
  readonly #renderbuffers: WebGLRenderbuffer[] = [];
  readonly #gl: WebGL2RenderingContext;
  readonly #forget: (object: GpuObject) => void;

  constructor(
    gl: WebGL2RenderingContext,
    { label, width, height, samples }: RenderTargetOptions,
    forget: (object: GpuObject) => void,
  ) {
    this.#gl = gl;
    this.#forget = forget;
    this.label = label;
    this.width = width;
    this.height = height;
    this.samples = Math.min(samples, gl.getParameter(gl.MAX_SAMPLES) as number);
    this.bytes = width * height * this.samples * 8;
    this.framebuffer = created(gl, gl.createFramebuffer(), label);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    for (const [format, attachment] of [
      [gl.RGBA8, gl.COLOR_ATTACHMENT0],
      [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
    ] as const) {
      const renderbuffer = created(gl, gl.createRenderbuffer(), label);
      gl.bindRenderbuffer(gl.RENDERBUFFER, renderbuffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, this.samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, renderbuffer);
      this.#renderbuffers.push(renderbuffer);
    }
    const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    if (status !== gl.FRAMEBUFFER_COMPLETE && !gl.isContextLost()) {
      this.dispose();
      throw new Error(`${label}: framebuffer incomplete (0x${status.toString(16)})`);
    }
  }

  dispose(): void {
    for (const renderbuffer of this.#renderbuffers) this.#gl.deleteRenderbuffer(renderbuffer);
    this.#gl.deleteFramebuffer(this.framebuffer);
    this.#forget(this);
  }
}
