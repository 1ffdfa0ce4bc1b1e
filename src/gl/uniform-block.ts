import { created, type GpuObject } from "./gpu-object.js";
import type { Program } from "./program.js";

/**
 * A std140 uniform block, written by member name.
 *
 * Offsets are asked of the driver, never computed: std140 lets a float sit in the fourth slot of a
 * vec3, and tables written by hand get that wrong.
 */
export class UniformBlock implements GpuObject {
  readonly label: string;
  readonly bytes: number;
  readonly handle: WebGLBuffer;
  readonly #floats: Float32Array;
  readonly #offsets = new Map<string, number>();
  readonly #gl: WebGL2RenderingContext;
  readonly #forget: (object: GpuObject) => void;

  constructor(
    gl: WebGL2RenderingContext,
    program: Program,
    name: string,
    forget: (object: GpuObject) => void,
  ) {
    this.#gl = gl;
    this.#forget = forget;
    this.label = `block ${name}`;
    const index = gl.getUniformBlockIndex(program.handle, name);
    if (index === gl.INVALID_INDEX) throw new Error(`${program.label} has no block ${name}.`);
    this.bytes = gl.getActiveUniformBlockParameter(
      program.handle,
      index,
      gl.UNIFORM_BLOCK_DATA_SIZE,
    ) as number;
    const members = gl.getActiveUniformBlockParameter(
      program.handle,
      index,
      gl.UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES,
    ) as Uint32Array;
    const offsets = gl.getActiveUniforms(program.handle, members, gl.UNIFORM_OFFSET) as number[];
    members.forEach((member, i) => {
      const qualified = gl.getActiveUniform(program.handle, member)!.name;
      this.#offsets.set(qualified.slice(qualified.indexOf(".") + 1), offsets[i]! / 4);
    });
    this.#floats = new Float32Array(this.bytes / 4);
    this.handle = created(gl, gl.createBuffer(), this.label);
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.handle);
    gl.bufferData(gl.UNIFORM_BUFFER, this.bytes, gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.UNIFORM_BUFFER, null);
  }

  /** Writes the members given and sends the block to the GPU. An unknown member throws. */
  update(members: Readonly<Record<string, number | ArrayLike<number>>>): void {
    for (const name in members) {
      const offset = this.#offsets.get(name);
      if (offset === undefined) {
        throw new Error(
          `${this.label} has no ${name}; it has ${[...this.#offsets.keys()].join(", ")}.`,
        );
      }
      const value = members[name]!;
      if (typeof value === "number") this.#floats[offset] = value;
      else this.#floats.set(value, offset);
    }
    const gl = this.#gl;
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.handle);
    gl.bufferSubData(gl.UNIFORM_BUFFER, 0, this.#floats);
    gl.bindBuffer(gl.UNIFORM_BUFFER, null);
  }

  dispose(): void {
    this.#gl.deleteBuffer(this.handle);
    this.#forget(this);
  }
}
