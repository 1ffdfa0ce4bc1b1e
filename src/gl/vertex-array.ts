import type { Buffer } from "./buffer.js";
import { created, type GpuContext, GpuObject } from "./gpu-object.js";

/** One attribute: `size` floats from `offset` in each `stride` of a buffer (bytes; 0 = tightly packed). */
interface Attribute {
  readonly buffer: Buffer;
  readonly size: 1 | 2 | 3 | 4;
  readonly stride?: number;
  readonly offset?: number;
}

export interface VertexArrayOptions {
  /** By location, as the shaders' `layout(location = n)` say. */
  readonly attributes: Readonly<Record<number, Attribute>>;
  readonly indices?: { readonly buffer: Buffer; readonly type: "uint16" | "uint32" };
  /** Vertices, or indices where there are any. */
  readonly count: number;
}

/** How buffers feed a vertex shader. It does not own the buffers. */
export class VertexArray extends GpuObject {
  readonly bytes = 0;
  readonly handle: WebGLVertexArrayObject;
  readonly count: number;
  readonly indexType: "uint16" | "uint32" | undefined;

  constructor(
    context: GpuContext,
    label: string,
    { attributes, indices, count }: VertexArrayOptions,
  ) {
    super(context, label);
    const { gl } = context;
    this.count = count;
    this.indexType = indices?.type;
    this.handle = created(gl, gl.createVertexArray(), label);
    gl.bindVertexArray(this.handle);
    for (const [location, { buffer, size, stride = 0, offset = 0 }] of Object.entries(attributes)) {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer.handle);
      gl.enableVertexAttribArray(Number(location));
      gl.vertexAttribPointer(Number(location), size, gl.FLOAT, false, stride, offset);
    }
    if (indices) gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices.buffer.handle);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, null);
  }

  protected free(): void {
    this.gl.deleteVertexArray(this.handle);
  }
}
