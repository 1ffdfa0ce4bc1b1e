import { created, type GpuContext, GpuObject } from "./gpu-object.js";
import type { Program } from "./program.js";

type Value = number | ArrayLike<number>;

/** A block as the driver laid it out. Offsets in floats, by member. */
interface Layout {
  readonly buffer: WebGLBuffer;
  readonly floats: Float32Array;
  readonly offsets: ReadonlyMap<string, number>;
}

/**
 * A std140 uniform block, written by member name.
 *
 * Offsets are queried, not computed: std140 puts a float in the fourth slot of a vec3, which tables written by hand
 * get wrong. They are queried at the first draw, since the query blocks until the program is linked; earlier writes
 * are kept.
 */
export class UniformBlock extends GpuObject {
  readonly #name: string;
  readonly #program: Program;
  #layout: Layout | null = null;
  #early: Record<string, Value> = {};
  #isStale = true;

  constructor(context: GpuContext, program: Program, name: string) {
    super(context, `block ${name}`);
    this.#program = program;
    this.#name = name;
  }

  get bytes(): number {
    return this.#layout?.floats.byteLength ?? 0;
  }

  /** The buffer, with all that was written. */
  get handle(): WebGLBuffer {
    const { buffer, floats } = this.#laidOut();
    if (this.#isStale) {
      const gl = this.gl;
      gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
      gl.bufferSubData(gl.UNIFORM_BUFFER, 0, floats);
      gl.bindBuffer(gl.UNIFORM_BUFFER, null);
      this.#isStale = false;
    }
    return buffer;
  }

  /** Writes the members given. An unknown member throws, at the next draw at the latest. */
  update(members: Readonly<Record<string, Value>>): void {
    this.#isStale = true;
    if (this.#layout) this.#write(this.#layout, members);
    for (const name in this.#layout ? {} : members) {
      const value = members[name]!;
      this.#early[name] = typeof value === "number" ? value : Array.from(value);
    }
  }

  #write({ floats, offsets }: Layout, members: Readonly<Record<string, Value>>): void {
    for (const name in members) {
      const offset = offsets.get(name);
      if (offset === undefined) {
        throw new Error(`${this.label} has no ${name}; it has ${[...offsets.keys()].join(", ")}.`);
      }
      const value = members[name]!;
      if (typeof value === "number") floats[offset] = value;
      else floats.set(value, offset);
    }
  }

  #laidOut(): Layout {
    if (this.#layout) return this.#layout;
    const gl = this.gl;
    const { handle, label } = this.#program;
    const index = gl.getUniformBlockIndex(handle, this.#name);
    if (index === gl.INVALID_INDEX) throw new Error(`${label} has no block ${this.#name}.`);
    const ask = (what: GLenum) => gl.getActiveUniformBlockParameter(handle, index, what);
    const bytes = ask(gl.UNIFORM_BLOCK_DATA_SIZE) as number;
    const members = ask(gl.UNIFORM_BLOCK_ACTIVE_UNIFORM_INDICES) as Uint32Array;
    const byteOffsets = gl.getActiveUniforms(handle, members, gl.UNIFORM_OFFSET) as number[];
    const offsets = new Map<string, number>();
    members.forEach((member, i) => {
      const qualified = gl.getActiveUniform(handle, member)!.name;
      offsets.set(qualified.slice(qualified.indexOf(".") + 1), byteOffsets[i]! / 4);
    });
    const buffer = created(gl, gl.createBuffer(), this.label);
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
    gl.bufferData(gl.UNIFORM_BUFFER, bytes, gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.UNIFORM_BUFFER, null);
    this.#layout = { buffer, floats: new Float32Array(bytes / 4), offsets };
    this.#write(this.#layout, this.#early);
    this.#early = {};
    return this.#layout;
  }

  protected free(): void {
    if (this.#layout) this.gl.deleteBuffer(this.#layout.buffer);
  }
}
