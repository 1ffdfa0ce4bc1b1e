import type { Buffer } from "./buffer.js";
import { noCounts } from "./frame-counts.js";
import type { Program, UniformValue } from "./program.js";
import type { RenderTarget } from "./render-target.js";
import { Samplers, type Sampling } from "./samplers.js";
import type { Texture } from "./texture.js";
import type { TextureView } from "./texture-view.js";
import type { UniformBlock } from "./uniform-block.js";
import type { VertexArray } from "./vertex-array.js";

/** Destination of a draw: textures of ours, or the canvas. */
export type Surface = RenderTarget | TextureView | "canvas";

/** Part of a surface, in its pixels: x, y, width, height. */
export type Box = readonly [number, number, number, number];

/** A draw call and all the state it depends on. Members left out have their default, whatever ran before. */
export interface Draw {
  readonly program: Program;
  /** Null: nothing is rasterized. */
  readonly target: Surface | null;
  /** Default: none, for a shader that makes its vertices; by default those of a triangle over the whole target. */
  readonly vertexArray?: VertexArray;
  readonly uniforms?: Readonly<Record<string, UniformValue>>;
  readonly textures?: Readonly<Record<string, Texture>>;
  /** How textures are read, by uniform. Default: with mipmaps trilinear, without as they were made. */
  readonly sampling?: Readonly<Record<string, Sampling>>;
  readonly blocks?: Readonly<Record<string, UniformBlock>>;
  /** Default: triangles. */
  readonly primitive?: "triangles" | "strip" | "points";
  /** Vertices or indices drawn. Default: all. */
  readonly count?: number;
  /** Index that they begin at. Default: 0. */
  readonly first?: number;
  /** Default: replace. `premultiplied`: alpha 0 adds, alpha 1 covers. */
  readonly blend?: "replace" | "premultiplied";
  /** Default: none. */
  readonly depth?: "none" | "test" | "test-and-write";
  /** Whether colours are written. Default: they are. */
  readonly writesColor?: boolean;
  /** Part of the target, in its pixels: x, y, width, height. Default: all of it. */
  readonly viewport?: Box;
  /** Part of the target outside of which nothing is drawn: x, y, width, height. Default: all of it. */
  readonly scissor?: Box | undefined;
  /** Faces not drawn. Default: back. */
  readonly cull?: "none" | "back";
  /** Takes the outputs of the vertex shader that the program captures. Points without indices only. */
  readonly into?: Buffer | undefined;
}

const MODES = { triangles: "TRIANGLES", strip: "TRIANGLE_STRIP", points: "POINTS" } as const;

/** Draw calls of a context, and the GL state between them: it alone touches that, and sets only what differs. */
export class DrawCommands {
  /** Of the frame that is drawn. */
  counts = noCounts();
  readonly canvas: HTMLCanvasElement;
  protected readonly gl: WebGL2RenderingContext;
  readonly #samplers: Samplers;
  /** What is switched on in GL: each call saved is a microsecond of the page's own thread. */
  readonly #enabled = new Set<GLenum>();
  #writesDepth = true;
  #writesColor = true;
  /** What draws have bound: textures by unit, uniform buffers by binding point. */
  readonly #textures: WebGLTexture[] = [];
  readonly #uniformBuffers: WebGLBuffer[] = [];
  /** Target and viewport of the last draw; null once something else has bound a framebuffer. */
  #target: Surface | null = null;
  #viewport: Box = [0, 0, 0, 0];

  constructor(gl: WebGL2RenderingContext, canvas: HTMLCanvasElement) {
    this.gl = gl;
    this.canvas = canvas;
    this.#samplers = new Samplers(gl);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /**
   * @param scissor the part to clear. Default: all of it.
   * @param keepsDepth whether colours alone are cleared
   */
  clear(
    target: Surface,
    color: readonly [number, number, number, number],
    scissor?: Box,
    keepsDepth?: boolean,
  ): void {
    const gl = this.gl;
    this.#bind(target);
    this.#switch(gl.RASTERIZER_DISCARD, false);
    this.#writeDepth(true);
    this.#writeColor(true);
    this.#switch(gl.SCISSOR_TEST, scissor !== undefined);
    if (scissor) gl.scissor(...scissor);
    gl.clearColor(...color);
    gl.clear(gl.COLOR_BUFFER_BIT | (keepsDepth ? 0 : gl.DEPTH_BUFFER_BIT));
  }

  draw(call: Draw): void {
    const gl = this.gl;
    const { target, vertexArray, primitive = "triangles", viewport, scissor, into } = call;
    const { count = vertexArray?.count ?? 3, first = 0 } = call;
    const { blend = "replace", depth = "none", cull = "back", writesColor = true } = call;
    if (target) this.#bind(target, viewport);
    this.#switch(gl.RASTERIZER_DISCARD, target === null);
    this.#switch(gl.SCISSOR_TEST, scissor !== undefined);
    if (scissor) gl.scissor(...scissor);
    this.#bindInputs(call);
    this.#switch(gl.BLEND, blend === "premultiplied");
    this.#switch(gl.DEPTH_TEST, depth !== "none");
    if (depth !== "none") this.#writeDepth(depth === "test-and-write");
    this.#writeColor(writesColor);
    this.#switch(gl.CULL_FACE, cull === "back");
    gl.bindVertexArray(vertexArray?.handle ?? null);
    const mode = gl[MODES[primitive]];
    if (vertexArray?.indexType) {
      const type = vertexArray.indexType === "uint16" ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
      gl.drawElements(mode, count, type, first * (type === gl.UNSIGNED_SHORT ? 2 : 4));
    } else if (into) {
      this.#capture(into, count);
    } else {
      gl.drawArrays(mode, first, count);
    }
    this.counts.drawCalls++;
    if (primitive === "triangles") this.counts.triangles += count / 3;
  }

  #switch(capability: GLenum, isOn: boolean): void {
    if (this.#enabled.has(capability) === isOn) return;
    if (isOn) {
      this.gl.enable(capability);
      this.#enabled.add(capability);
    } else {
      this.gl.disable(capability);
      this.#enabled.delete(capability);
    }
  }

  #writeDepth(isOn: boolean): void {
    if (this.#writesDepth === isOn) return;
    this.gl.depthMask(isOn);
    this.#writesDepth = isOn;
  }

  #writeColor(isOn: boolean): void {
    if (this.#writesColor === isOn) return;
    this.gl.colorMask(isOn, isOn, isOn, isOn);
    this.#writesColor = isOn;
  }

  #capture(into: Buffer, count: number): void {
    const gl = this.gl;
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, into.handle);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, count);
    gl.endTransformFeedback();
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
  }

  /** Copies a multisampled target to a surface of its size and format; with depth that can be read there. All, or a part. */
  resolve(target: RenderTarget, to: RenderTarget | TextureView, part?: Box): void {
    const gl = this.gl;
    this.forgetTarget();
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, target.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, to.framebuffer);
    const [x, y, width, height] = part ?? [0, 0, target.width, target.height];
    const box = [x, y, x + width, y + height] as const;
    this.#switch(gl.SCISSOR_TEST, false);
    const depth = "depth" in to && to.depth ? gl.DEPTH_BUFFER_BIT : 0;
    const bits = gl.COLOR_BUFFER_BIT | depth;
    gl.blitFramebuffer(...box, ...box, bits, gl.NEAREST);
  }

  /**
   * Pixels of the canvas, 8-bit RGBA, rows from the bottom up; only in the task that drew them: afterwards the browser
   * owns them. Waits for the GPU.
   */
  readCanvas([x, y, width, height]: Box): Uint8Array {
    const gl = this.gl;
    const pixels = new Uint8Array(width * height * 4);
    this.forgetTarget();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  /** RGB of a floating-point target, rows from the top. Waits for the GPU. */
  readFloats(target: RenderTarget | TextureView, [x, y, width, height]: Box): Float32Array {
    const gl = this.gl;
    const texels = new Float32Array(width * height * 4);
    this.forgetTarget();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    gl.readPixels(x, target.height - y - height, width, height, gl.RGBA, gl.FLOAT, texels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const rgb = new Float32Array(width * height * 3);
    for (let i = 0; i < width * height; i++) {
      const from = (i + width * (height - 1 - 2 * Math.floor(i / width))) * 4;
      rgb.set(texels.subarray(from, from + 3), i * 3);
    }
    return rgb;
  }

  protected beforeUse(_program: Program): void {}

  /** A framebuffer was bound by other means than a draw. */
  protected forgetTarget(): void {
    this.#target = null;
  }

  #bind(target: Surface, viewport?: Box): void {
    const gl = this.gl;
    if (target !== this.#target) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, target === "canvas" ? null : target.framebuffer);
      this.#target = target;
    }
    const { width, height } = target === "canvas" ? this.canvas : target;
    const next = viewport ?? ([0, 0, width, height] as const);
    if (next.every((x, i) => x === this.#viewport[i])) return;
    gl.viewport(...next);
    this.#viewport = next;
  }

  #bindInputs(call: Omit<Draw, "target">): void {
    const gl = this.gl;
    const { program, uniforms = {}, textures = {}, sampling = {}, blocks = {} } = call;
    this.beforeUse(program);
    program.finish();
    // First: laying out a block may have to look into another program.
    for (const [name, binding] of program.blocks) {
      const block = blocks[name];
      if (!block) throw new Error(`${program.label} needs a block ${name}.`);
      const { handle } = block;
      if (handle === this.#uniformBuffers[binding]) continue;
      gl.bindBufferBase(gl.UNIFORM_BUFFER, binding, handle);
      this.#uniformBuffers[binding] = handle;
    }
    gl.useProgram(program.handle);
    for (const name in uniforms) program.set(name, uniforms[name]!);
    for (const [name, unit] of program.samplers) {
      const texture = textures[name];
      if (!texture) throw new Error(`${program.label} needs a texture ${name}.`);
      if (texture.handle !== this.#textures[unit]) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(texture.target, texture.handle);
        this.#textures[unit] = texture.handle;
      }
      const how = sampling[name];
      this.#samplers.bind(unit, texture.hasMipmaps || how === "nearest" ? how : undefined);
    }
  }

  dispose(): void {
    this.#samplers.dispose();
  }
}
