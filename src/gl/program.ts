import { ContextLostError, created, type GpuContext, GpuObject } from "./gpu-object.js";

/** A shader stage after its includes; `files[n]` is what `#line _ n` refers to. */
export interface ShaderSource {
  readonly source: string;
  readonly files: readonly string[];
}

export interface ProgramOptions {
  /** Compile-time variants: `{ SHADOW_TAPS: 12 }` becomes `#define SHADOW_TAPS 12`. */
  readonly defines?: Readonly<Record<string, number>>;
  /** Outputs of the vertex stage that transform feedback captures, interleaved in this order. */
  readonly feedback?: readonly string[];
}

export type UniformValue = number | Float32Array | Int32Array | Uint32Array | readonly number[];

/** Sends a value to one uniform of the program in use. */
type Uniform = (value: UniformValue) => void;

/** A shader that does not compile or link. The message names the shader's own file and line. */
export class ShaderError extends Error {
  override readonly name = "ShaderError";
}

function compile(
  gl: WebGL2RenderingContext,
  type: number,
  { source, files }: ShaderSource,
  defines: Readonly<Record<string, number>>,
): WebGLShader {
  const shader = created(gl, gl.createShader(type), files[0] ?? "shader");
  const lines = Object.entries(defines).map(([name, value]) => `#define ${name} ${value}`);
  const [version = "", ...rest] = source.split("\n");
  gl.shaderSource(shader, [version, ...lines, "#line 2 0", ...rest].join("\n"));
  gl.compileShader(shader);
  return shader;
}

function uniformOf(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  type: number,
): Uniform {
  const list = (value: UniformValue) => (typeof value === "number" ? [value] : value);
  const setters: Readonly<Record<number, Uniform>> = {
    [gl.FLOAT]: (value) =>
      typeof value === "number" ? gl.uniform1f(location, value) : gl.uniform1fv(location, value),
    [gl.FLOAT_VEC2]: (value) => gl.uniform2fv(location, list(value)),
    [gl.FLOAT_VEC3]: (value) => gl.uniform3fv(location, list(value)),
    [gl.FLOAT_VEC4]: (value) => gl.uniform4fv(location, list(value)),
    [gl.FLOAT_MAT3]: (value) => gl.uniformMatrix3fv(location, false, list(value)),
    [gl.FLOAT_MAT4]: (value) => gl.uniformMatrix4fv(location, false, list(value)),
    [gl.INT]: (value) => gl.uniform1iv(location, list(value)),
    [gl.UNSIGNED_INT]: (value) => gl.uniform1uiv(location, list(value)),
  };
  return setters[type]!; // no shader here has another type
}

/** Sends only values that differ from the last: programs keep their uniforms. */
function remembering(send: Uniform): Uniform {
  let single = Number.NaN;
  const list: number[] = [];
  return (value) => {
    if (typeof value === "number") {
      if (value === single) return;
      single = value;
    } else {
      let isSame = value.length === list.length;
      for (let i = 0; i < value.length; i++) {
        const component = value[i]!;
        if (component === list[i]) continue;
        list[i] = component;
        isSame = false;
      }
      if (isSame) return;
    }
    send(value);
  };
}

// ANGLE, Mesa and Apple all write "ERROR: file:line: text".
function explain(log: string, { files }: ShaderSource): string {
  return log.replace(
    /ERROR:\s*(\d+):(\d+):/g,
    (_, file: string, line: string) => `shaders/${files[Number(file)] ?? files[0]}:${line}:`,
  );
}

/** Names of the loose uniforms that a stage declares, whether it uses them or not. */
function declaredUniforms({ source }: ShaderSource): string[] {
  const declarations = source.matchAll(/^\s*uniform\s+(?:(?:low|medium|high)p\s+)?\w+\s+(\w+)/gm);
  return Array.from(declarations, ([, name]) => name ?? "");
}

interface Stage {
  readonly source: ShaderSource;
  readonly shader: WebGLShader;
}

/**
 * A linked program, with its uniforms by name.
 *
 * Some drivers compile at once, others in parallel once all programs are started. The result is queried on first use,
 * since the query blocks.
 */
export class Program extends GpuObject {
  readonly bytes = 0;
  readonly #handle: WebGLProgram;
  /** Starts the compiler; null once that is done. */
  #compile: (() => readonly Stage[]) | null;
  /** From the start until they are linked. */
  #stages: readonly Stage[] = [];
  readonly #uniforms = new Map<string, Uniform>();
  readonly #declared: ReadonlySet<string>;
  /** Texture units and binding points, by name; once it is finished. */
  readonly samplers = new Map<string, number>();
  readonly blocks = new Map<string, number>();

  constructor(
    context: GpuContext,
    label: string,
    vertex: ShaderSource,
    fragment: ShaderSource,
    { defines = {}, feedback = [] }: ProgramOptions,
  ) {
    const variant = Object.entries(defines).map(([name, value]) => `${name}=${value}`);
    super(context, [label, ...variant].join(" "));
    const { gl } = context;
    this.#declared = new Set([vertex, fragment].flatMap(declaredUniforms));
    this.#handle = created(gl, gl.createProgram(), this.label);
    this.#compile = () => {
      const stages = [
        { source: vertex, shader: compile(gl, gl.VERTEX_SHADER, vertex, defines) },
        { source: fragment, shader: compile(gl, gl.FRAGMENT_SHADER, fragment, defines) },
      ];
      for (const { shader } of stages) gl.attachShader(this.#handle, shader);
      if (feedback.length > 0) {
        gl.transformFeedbackVaryings(this.#handle, [...feedback], gl.INTERLEAVED_ATTRIBS);
      }
      gl.linkProgram(this.#handle);
      return stages;
    };
  }

  /** Has the driver compile and link it, unless that has begun. Returns whether it begins now. */
  start(): boolean {
    const compile = this.#compile;
    this.#compile = null;
    if (compile) this.#stages = compile();
    return compile !== null;
  }

  /** Whether a query would not block. Not before it is started. */
  get isCompiled(): boolean {
    if (this.#compile) return false;
    const parallel = this.gl.getExtension("KHR_parallel_shader_compile");
    if (this.#stages.length === 0 || !parallel || this.gl.isContextLost()) return true;
    const status = this.gl.getProgramParameter(this.#handle, parallel.COMPLETION_STATUS_KHR);
    return status !== false;
  }

  /** Waits until it is linked. If it cannot be, it is disposed of, and the compiler's message returned. */
  refusal(): Error | null {
    this.start();
    if (this.#stages.length === 0) return null;
    const gl = this.gl;
    const stages = this.#stages;
    this.#stages = [];
    const linked = gl.getProgramParameter(this.#handle, gl.LINK_STATUS) as boolean;
    const log = linked ? "" : this.#reasonOfFailure(stages);
    for (const { shader } of stages) gl.deleteShader(shader);
    if (!linked) {
      this.dispose();
      if (gl.isContextLost()) return new ContextLostError(`${this.label}: the context is lost.`);
      return new ShaderError(`${this.label}: ${log}`);
    }
    this.#reflect();
    return null;
  }

  /** The same; throws the message. */
  finish(): void {
    const refusal = this.refusal();
    if (refusal) throw refusal;
  }

  get handle(): WebGLProgram {
    this.finish();
    return this.#handle;
  }

  #reasonOfFailure(stages: readonly Stage[]): string {
    const gl = this.gl;
    for (const { source, shader } of stages) {
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
        return explain(gl.getShaderInfoLog(shader) ?? "does not compile", source);
      }
    }
    return gl.getProgramInfoLog(this.#handle) ?? "does not link";
  }

  #reflect(): void {
    const gl = this.gl;
    const samplers: number[] = [gl.SAMPLER_2D, gl.SAMPLER_CUBE];
    gl.useProgram(this.#handle);
    const count = gl.getProgramParameter(this.#handle, gl.ACTIVE_UNIFORMS) as number;
    for (let i = 0; i < count; i++) {
      const active = gl.getActiveUniform(this.#handle, i)!;
      const location = gl.getUniformLocation(this.#handle, active.name);
      if (location === null) continue; // a member of a block
      if (samplers.includes(active.type)) {
        // The first unit is for filling textures.
        const unit = this.samplers.size + 1;
        gl.uniform1i(location, unit);
        this.samplers.set(active.name, unit);
        continue;
      }
      const name = active.name.replace(/\[0\]$/, "");
      this.#uniforms.set(name, remembering(uniformOf(gl, location, active.type)));
    }
    const blocks = gl.getProgramParameter(this.#handle, gl.ACTIVE_UNIFORM_BLOCKS) as number;
    for (let i = 0; i < blocks; i++) {
      gl.uniformBlockBinding(this.#handle, i, i);
      this.blocks.set(gl.getActiveUniformBlockName(this.#handle, i)!, i);
    }
  }

  /**
   * Sets a loose uniform of the program in use.
   *
   * A declared uniform that the linker has removed is ignored. A name that is not declared throws.
   */
  set(name: string, value: UniformValue): void {
    const uniform = this.#uniforms.get(name);
    if (uniform) uniform(value);
    else if (!this.#declared.has(name))
      throw new Error(`${this.label} declares no uniform ${name}.`);
  }

  protected free(): void {
    this.#compile = null;
    for (const { shader } of this.#stages) this.gl.deleteShader(shader);
    this.#stages = [];
    this.gl.deleteProgram(this.#handle);
  }
}
