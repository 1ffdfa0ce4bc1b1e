import fullscreenVert from "../../shaders/post/fullscreen.vert";
import { Buffer } from "./buffer.js";
import { type Box, type Draw, DrawCommands, type Surface } from "./draw-commands.js";
import { type FrameCounts, noCounts } from "./frame-counts.js";
import { created, type GpuContext, type GpuObject, incomplete, outOfMemory } from "./gpu-object.js";
import { GpuTimer } from "./gpu-timer.js";
import { laterTask, nextTask } from "./next-task.js";
import { Program, type ProgramOptions, type ShaderSource, type UniformValue } from "./program.js";
import { RenderTarget, type RenderTargetOptions } from "./render-target.js";
import { rendererName } from "./renderer-name.js";
import { Texture, type TextureFormat, type TextureOptions } from "./texture.js";
import { TextureView, type TextureViewOptions } from "./texture-view.js";
import { UniformBlock } from "./uniform-block.js";
import { VertexArray, type VertexArrayOptions } from "./vertex-array.js";

export type {
  Box,
  Buffer,
  Draw,
  Program,
  ProgramOptions,
  RenderTarget,
  ShaderSource,
  Surface,
  Texture,
  TextureFormat,
  TextureView,
  UniformBlock,
  UniformValue,
  VertexArray,
};

/** WebGL2 is missing, or refused. */
export class WebGLUnavailableError extends Error {
  override readonly name = "WebGLUnavailableError";
}

/** A WebGL2 context: it draws, and creates all objects, so it can count and free them. */
export class Gpu extends DrawCommands {
  /** The driver's name of the renderer, for reports. */
  readonly renderer: string;
  /** Pixels of the longest side that canvas and targets can have. */
  readonly longestSide: number;
  readonly drawsToFloats: boolean;
  /** Whether targets can be of half floats, with or without all others. */
  readonly drawsToHalfFloats: boolean;
  /** Whether textures of full floats can be read between their texels; those of half floats always can. */
  readonly filtersFloats: boolean;
  readonly #timer: GpuTimer;
  readonly #context: GpuContext;
  readonly #alive = new Set<GpuObject>();
  readonly #sources = new Map<ShaderSource, number>();
  /** Objects that one renderer leaves to the next, by what they were made from. */
  readonly #shared = new Map<unknown, unknown>();
  readonly #sharedObjects = new Set<GpuObject>();
  #isSharing = false;
  /** Whether what is made now is the next renderer's; what was, until that takes over or is given up. */
  isAhead = false;
  ahead = new Set<GpuObject>();
  /** Programs that anything was drawn with. */
  readonly used = new Set<unknown>();
  /** Of them, those that no renderer has asked for since all else was cleared. */
  #idle = new Set<unknown>();
  readonly #mostSamples: number;
  /** Programs that the driver has not been sent. */
  readonly #unsent = new Set<Program>();
  /** Targets whose completeness has not been queried. */
  readonly #toCheck = new Set<RenderTarget | TextureView>();

  /** @param alpha of the canvas. Without it the browser blends nothing: 4 ms fewer for 1280 x 720 pixels without a GPU */
  constructor(canvas: HTMLCanvasElement, alpha = false) {
    // Multisampling of the default framebuffer is up to the browser; ours is in render targets.
    const gl = canvas.getContext("webgl2", {
      alpha,
      antialias: false,
      depth: false,
      powerPreference: "high-performance",
    });
    if (!gl) throw new WebGLUnavailableError("This browser or graphics driver offers no WebGL 2.");
    super(gl, canvas);
    this.#context = { gl, forget: (object) => this.#forget(object) };
    // Here, because extensions are lost with the context (KhronosGroup/WebGL #2942).
    const has = (extension: string) => gl.getExtension(extension) !== null;
    this.drawsToFloats = has("EXT_color_buffer_float");
    this.drawsToHalfFloats = has("EXT_color_buffer_half_float") || this.drawsToFloats;
    this.filtersFloats = has("OES_texture_float_linear");
    // Blending into full floats, which Firefox allows with a warning unless it is asked for.
    has("EXT_float_blend");
    this.renderer = rendererName(gl);
    this.#mostSamples = gl.getParameter(gl.MAX_SAMPLES) as number;
    this.longestSide = Math.min(
      gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number,
      gl.getParameter(gl.MAX_TEXTURE_SIZE) as number,
      ...created<Int32Array>(gl, gl.getParameter(gl.MAX_VIEWPORT_DIMS), "canvas"),
    );
    this.#timer = new GpuTimer(gl);
  }

  /** Sets the colour space of the canvas. Returns the one that it has: the browser may know sRGB alone. */
  setColorSpace(gamut: PredefinedColorSpace): PredefinedColorSpace {
    const gl = this.gl;
    if (gl.drawingBufferColorSpace === undefined) return "srgb"; // Safari before 16.4
    if (gl.drawingBufferColorSpace !== gamut) gl.drawingBufferColorSpace = gamut;
    return gl.drawingBufferColorSpace;
  }

  /** Of the objects alive, without programs that were kept for a later renderer. */
  get objectCount(): number {
    return this.#alive.size - this.#idle.size;
  }

  /** Memory of the objects alive and of the canvas, in bytes. */
  get bytes(): number {
    const canvas = this.canvas.width * this.canvas.height * 4;
    return [...this.#alive].reduce((sum, { bytes }) => sum + bytes, canvas);
  }

  get isLost(): boolean {
    return this.gl.isContextLost();
  }

  #forget(object: GpuObject): void {
    this.#alive.delete(object);
    this.#unsent.delete(object as Program);
    this.used.delete(object);
    this.#toCheck.delete(object as RenderTarget | TextureView);
    this.ahead.delete(object);
    if (!this.#sharedObjects.delete(object)) return;
    for (const [key, made] of this.#shared) if (made === object) this.#shared.delete(key);
  }

  #keep<T extends GpuObject>(object: T): T {
    this.#alive.add(object);
    if (this.#isSharing) this.#sharedObjects.add(object);
    else if (this.isAhead) this.ahead.add(object);
    return object;
  }

  isShared(key: unknown): boolean {
    return this.#shared.has(key);
  }

  /** An object that successive renderers share: made for the first, kept until `clearObjects` frees it. */
  share<T>(key: unknown, make: () => T): T {
    const wasSharing = this.#isSharing;
    this.#isSharing = true;
    try {
      if (!this.#shared.has(key)) this.#shared.set(key, make());
    } finally {
      this.#isSharing = wasSharing;
    }
    return this.#shared.get(key) as T;
  }

  /** What `make` makes, and how to free it with all that it has shared; others on this context keep theirs. */
  scoped<T>(make: () => T): { readonly made: T; readonly release: () => void } {
    const [before, keys] = [new Set(this.#alive), new Set(this.#shared.keys())];
    const made = make();
    const objects = [...this.#alive].filter((o) => !(o instanceof Program || before.has(o)));
    const added = [...this.#shared].filter(([k, o]) => !(o instanceof Program || keys.has(k)));
    const release = () => {
      for (const object of objects) object.dispose();
      for (const [key] of added) this.#shared.delete(key);
    };
    return { made, release };
  }

  /** Stands for a source in keys, which would be as long. */
  #numberOf(source: ShaderSource): number {
    const number = this.#sources.get(source) ?? this.#sources.size;
    this.#sources.set(source, number);
    return number;
  }

  /** Equal programs are compiled once: when drawn with, in `whenCompiled`, or one after each frame. */
  program(
    label: string,
    vertex: ShaderSource,
    fragment: ShaderSource,
    options: ProgramOptions = {},
  ): Program {
    const key = JSON.stringify([label, this.#numberOf(vertex), this.#numberOf(fragment), options]);
    const program = this.share(key, () => {
      const program = new Program(this.#context, label, vertex, fragment, options);
      this.#unsent.add(program);
      return this.#keep(program);
    });
    this.#idle.delete(program);
    return program;
  }

  /** A program that draws to the whole of a target, without a vertex array. */
  pass(label: string, fragment: ShaderSource, options?: ProgramOptions): Program {
    return this.program(label, fullscreenVert, fragment, options);
  }

  #startPrograms(most = Infinity): void {
    for (const program of [...this.#unsent].slice(0, most)) {
      this.#unsent.delete(program);
      program.start();
    }
  }

  /**
   * Resolves when the driver has compiled all programs, as far as it tells. Each is started in a task of its own, since
   * some drivers compile while one waits; without a timer, which a test may have stopped.
   *
   * @param idles how often the GPU is waited for then: a query of a program blocks until all earlier work is done, and
   * ANGLE goes on with a program for some frames
   */
  async whenCompiled(idles = 1): Promise<void> {
    while (this.isCompiling) await (this.#unsent.size > 0 ? nextTask() : laterTask());
    for (let idle = 0; idle < idles; idle++) await this.whenIdle();
  }

  /** Whether a program is not compiled yet, as far as the driver tells. Starts the next one. */
  get isCompiling(): boolean {
    this.#startPrograms(1);
    const isPending = (object: GpuObject) => object instanceof Program && !object.isCompiled;
    return this.#unsent.size > 0 || [...this.#alive].some(isPending);
  }

  /** Waits for all programs. Throws if any is refused; each is refused once. */
  finishPrograms(): void {
    this.#startPrograms();
    const refusals = Array.from(this.#alive, (o) => o instanceof Program && o.refusal());
    const refusal = refusals.find(Boolean);
    if (refusal) throw refusal;
  }

  /** Throws if since this was last asked the driver refused a target or ran out of memory. Waits for it. */
  check(label: string): void {
    const gl = this.gl;
    const targets = [...this.#toCheck];
    this.#toCheck.clear();
    this.forgetTarget();
    for (const target of targets) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
      const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
      if (gl.isContextLost()) return;
      if (status !== gl.FRAMEBUFFER_COMPLETE) throw incomplete(target.label, status);
    }
    for (let error = gl.getError(); error !== gl.NO_ERROR; error = gl.getError()) {
      if (error === gl.OUT_OF_MEMORY) throw outOfMemory(label);
      if (error === gl.CONTEXT_LOST_WEBGL) return;
    }
  }

  /** @param contents data, or a size in bytes of a buffer of zeros. */
  buffer(
    label: string,
    contents: ArrayBufferView | number,
    usage: "static" | "dynamic" | "index" = "static",
  ): Buffer {
    return this.#keep(new Buffer(this.#context, label, contents, usage));
  }

  vertexArray(label: string, options: VertexArrayOptions): VertexArray {
    return this.#keep(new VertexArray(this.#context, label, options));
  }

  texture(options: TextureOptions): Texture {
    return this.#keep(new Texture(this.#context, options));
  }

  renderTarget(options: RenderTargetOptions): RenderTarget {
    this.forgetTarget();
    return this.#unchecked(new RenderTarget(this.#context, options, this.#mostSamples));
  }

  textureView(options: TextureViewOptions): TextureView {
    this.forgetTarget();
    return this.#unchecked(new TextureView(this.#context, options));
  }

  #unchecked<T extends RenderTarget | TextureView>(target: T): T {
    this.#toCheck.add(target);
    return this.#keep(target);
  }

  /** A std140 block laid out as `program` declares it. */
  uniformBlock(program: Program, name: string): UniformBlock {
    return this.#keep(new UniformBlock(this.#context, program, name));
  }

  /**
   * Resolves when all commands so far have completed, or the context is lost.
   *
   * @param questions to be asked before there is a pause between two: a GPU answers within a millisecond or two
   */
  async whenIdle(questions = 16): Promise<void> {
    const gl = this.gl;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    if (!fence) return;
    // The answer changes from task to task only.
    let asked = 0;
    while (gl.clientWaitSync(fence, gl.SYNC_FLUSH_COMMANDS_BIT, 0) === gl.TIMEOUT_EXPIRED) {
      await (asked++ < questions ? nextTask() : laterTask());
    }
    gl.deleteSync(fence);
  }

  beginFrame(counts: FrameCounts): void {
    counts.drawCalls = counts.triangles = 0;
    this.counts = counts;
    this.#timer.begin(counts);
  }

  endFrame(): void {
    this.#timer.end();
    this.counts = noCounts();
    this.#startPrograms(1);
  }

  protected override beforeUse(program: Program): void {
    this.#unsent.delete(program);
    this.used.add(program);
  }

  /** Frees every object, and keeps the context for others, with the programs that it has drawn with. */
  clearObjects(): void {
    for (const object of this.#alive) if (!this.used.has(object)) object.dispose();
    for (const [key, made] of this.#shared) if (!this.used.has(made)) this.#shared.delete(key);
    this.#idle = new Set(this.used);
    this.clearUnshared(); // of which none is left
  }

  /** Frees what is not shared and was made ahead, or was not: the next renderer on this context takes the rest over. */
  clearUnshared(isAhead = false): void {
    for (const object of this.#alive)
      if (this.ahead.has(object) === isAhead && !this.#sharedObjects.has(object)) object.dispose();
    this.ahead = new Set();
    this.isAhead = false;
  }

  /** Frees everything and gives the context back, so that the page's next one does not evict another. */
  override dispose(): void {
    this.used.clear();
    this.clearObjects();
    this.#timer.dispose();
    super.dispose();
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
