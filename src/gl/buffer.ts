import { created, type GpuContext, GpuObject } from "./gpu-object.js";

/** A vertex, index or feedback buffer. */
export class Buffer extends GpuObject {
  readonly bytes: number;
  readonly handle: WebGLBuffer;

  /** @param contents data, or a size in bytes of a buffer of zeros. */
  constructor(
    context: GpuContext,
    label: string,
    contents: ArrayBufferView | number,
    usage: "static" | "dynamic" | "index",
  ) {
    super(context, label);
    const { gl } = context;
    this.handle = created(gl, gl.createBuffer(), label);
    // WebGL forbids one buffer to serve as indices and as anything else.
    const target = usage === "index" ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
    gl.bindVertexArray(null);
    gl.bindBuffer(target, this.handle);
    const hint = usage === "dynamic" ? gl.DYNAMIC_COPY : gl.STATIC_DRAW;
    if (typeof contents === "number") gl.bufferData(target, contents, hint);
    else gl.bufferData(target, contents, hint);
    gl.bindBuffer(target, null);
    this.bytes = typeof contents === "number" ? contents : contents.byteLength;
  }

  /** Copies the contents back: for tests and tools, since it waits for the GPU. */
  read(into: Float32Array): Float32Array {
    const gl = this.gl;
    gl.bindBuffer(gl.COPY_READ_BUFFER, this.handle);
    gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, into);
    gl.bindBuffer(gl.COPY_READ_BUFFER, null);
    return into;
  }

  protected free(): void {
    this.gl.deleteBuffer(this.handle);
  }
}
