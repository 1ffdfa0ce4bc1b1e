import type { CandleFlameElement, Quality } from "../../src/candle-flame-element.js";
import { type Draw, Gpu } from "../../src/gl/gpu.js";
import { GpuTimer } from "../../src/gl/gpu-timer.js";
import { isSoftware } from "../../src/render/quality.js";
import { median } from "./statistics.js";

export type TierName = Exclude<Quality, "auto">;

/** What the visitor does, or the candle that was just put out. */
export type Doing = "stands" | "walks" | "smokes";

/** What burns beside the carried candle, or in its place. */
export type Lights =
  | "candle on the table"
  | "one more candle"
  | "three more candles"
  | "moon alone";
const STANDING: Readonly<Record<Lights, number>> = {
  "candle on the table": 0,
  "one more candle": 1,
  "three more candles": 3,
  "moon alone": 0,
};
/** Frames until a night's light is captured, and the eye is used to it. */
const NIGHTFALL = 480;

export interface PassCost {
  readonly pass: string;
  /** Full-screen copies of 640 x 360 pixels of RGBA8 that take as long. */
  readonly copies: number;
  /** Milliseconds by the GPU's own clock; null where there is none to be believed. */
  readonly gpuMs: number | null;
}

/** Cost of one frame of the physical look. */
export interface Passes {
  readonly renderer: string;
  readonly quality: TierName;
  readonly doing: Doing;
  /** Default: the carried candle, and moonlight. */
  readonly lights?: Lights;
  readonly width: number;
  readonly height: number;
  readonly rounds: number;
  /** Time from the beginning until the element is ready, milliseconds. */
  readonly readyMs: number;
  /** Main thread's time for one frame, milliseconds: the median. */
  readonly scriptMs: number;
  /** Draws of one frame: the most. */
  readonly draws: number;
  readonly gpuBytes: number;
  /** Time of a copy, milliseconds. */
  readonly copyMs: number;
  /** All passes, waited for once: the mean of the frames of a cycle. */
  readonly frame: PassCost;
  /** Copies of the dearest of these frames. */
  readonly worst: number;
  /** Milliseconds of the dearest by the GPU's own clock. */
  readonly worstGpuMs: number | null;
  /** Each waited for by itself: more than its share of a frame. */
  readonly passes: readonly PassCost[];
}

/** The page that low is made for; and as many pixels as a copy has, where each costs the more. */
const PAGE = { width: 1280, height: 720 } as const;
const SMALL_PAGE = { width: 640, height: 360 } as const;
/** Where the visitor stands and looks at the candle on the table. */
const PLACE = { position: [-0.4, 1.6, 0.6], yaw: -0.94, pitch: -0.5 } as const;
const CAMERA = { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 } as const;
/** Seconds, at which low is to draw; and metres that a visitor walks in them. */
const FRAME = 1 / 30;
const STRIDE = 1.4 * FRAME;
/** Frames to and fro, by the end of which whatever is not done in each frame has been done: at low, most. */
const CYCLE: Readonly<Record<Doing, number>> = { stands: 8, walks: 8, smokes: 1 };
const SHORT_CYCLE = 2;
/** Cycles after which everything that only motion needs is created. */
const WARM: Readonly<Record<Doing, number>> = { stands: 6, walks: 5, smokes: 30 };
/** Copies in a row, so that waiting for them is nothing against them. */
const COPIES = 6;
/** Copies before a frame on a GPU: some milliseconds. */
const BUSY = 200;
/** Frames whose script is timed, a cycle's number of times. */
const SCRIPTS = 6;
/** A slow machine has fewer rounds, so that they end: time for each scene, milliseconds. */
const PATIENCE = 25_000;
const LEAST_ROUNDS = 2;

/** Each pass of each frame in copies, copies and frames interleaved. */
export async function measurePasses(
  quality: TierName,
  rounds: number,
  size: { readonly width: number; readonly height: number } = quality === "low" ? PAGE : SMALL_PAGE,
  lights?: Lights,
): Promise<Passes[]> {
  const element = document.createElement("candle-flame");
  element.paused = true;
  element.look = "physical";
  element.quality = quality;
  element.assetBase = "/";
  element.style.cssText = `width: ${size.width}px; height: ${size.height}px`;
  const begin = performance.now();
  document.body.replaceChildren(element);
  await element.ready;
  const readyMs = performance.now() - begin;
  const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
  if (!gl) throw new Error("The element has no picture.");
  const clock = new Clock(gl);
  const how = { quality, most: rounds, readyMs, lights };
  if (lights) await light(element, lights);
  const results = [await measure(element, clock, { ...how, doing: "walks" })];
  if (lights !== "candle on the table") {
    place(element);
    results.unshift(await measure(element, clock, { ...how, doing: "stands" }));
  }
  if (quality === "low" && !lights) {
    element.extinguish();
    results.push(await measure(element, clock, { ...how, doing: "smokes" }));
  }
  clock.dispose();
  element.remove();
  return results;
}

/** Sets the carried candle down on the table. */
function place(element: CandleFlameElement): void {
  element.camera = PLACE;
  element.place();
  element.camera = CAMERA;
}

/** Lights standing candles, or puts the carried one out, and waits until what is drawn with is compiled and captured. */
async function light(element: CandleFlameElement, lights: Lights): Promise<void> {
  for (const candle of element.candles.slice(1, 1 + STANDING[lights])) candle.light();
  if (lights === "moon alone") element.extinguish();
  if (lights === "candle on the table") place(element);
  element.play();
  for (let number = 0; number < NIGHTFALL; number++) {
    element.step(FRAME);
    if (number % CYCLE.walks === 0) await new Promise((resolve) => setTimeout(resolve));
  }
  element.pause();
}

interface How {
  readonly quality: TierName;
  readonly doing: Doing;
  readonly lights?: Lights | undefined;
  readonly most: number;
  readonly readyMs: number;
}

async function measure(
  element: CandleFlameElement,
  clock: Clock,
  { quality, doing, lights, most, readyMs }: How,
): Promise<Passes> {
  const isFast = quality === "low" || clock.isReal;
  const cycle = isFast ? CYCLE[doing] : Math.min(CYCLE[doing], SHORT_CYCLE);
  const frame = (number: number) => {
    if (doing === "walks") {
      const [x, y, z] = CAMERA.position;
      const strides = Math.min(number, cycle - number);
      const [away, turned] = [STRIDE * strides, 0.02 * strides];
      element.camera = { ...CAMERA, position: [x - away, y, z], yaw: CAMERA.yaw + turned };
    }
    element.step(FRAME);
  };
  // As frames follow each other for a visitor; nothing is drawn in between, while a clock is read.
  const request = window.requestAnimationFrame;
  window.requestAnimationFrame = () => 1;
  element.play();
  for (let number = 0; number < cycle * (isFast ? WARM[doing] : 1); number++) frame(number % cycle);
  const copies: number[] = [];
  const wholes: Span[][] = Array.from({ length: cycle }, () => []);
  const passes = new Map<string, Span[][]>();
  const end = performance.now() + PATIENCE;
  let rounds = 0;
  while (rounds < most && (rounds < LEAST_ROUNDS || performance.now() < end)) {
    const copy = clock.copy();
    copies.push(copy);
    for (let number = 0; number < cycle; number++) {
      const { ms, gpuMs } = await clock.time(() => frame(number));
      wholes[number]?.push({ ms: ms / copy, gpuMs });
    }
    for (let number = 0; number < cycle; number++) {
      for (const [pass, { ms, gpuMs }] of await clock.timeEach(() => frame(number))) {
        const frames = passes.get(pass) ?? Array.from({ length: cycle }, () => []);
        passes.set(pass, frames);
        frames[number]?.push({ ms: ms / copy, gpuMs });
      }
    }
    rounds++;
  }
  const scripts: number[] = [];
  let draws = 0;
  for (let number = 0; number < cycle * SCRIPTS; number++) {
    clock.wait();
    frame(number % cycle);
    scripts.push(element.stats.cpuMs);
    draws = Math.max(draws, element.stats.drawCalls);
  }
  element.pause();
  window.requestAnimationFrame = request;
  // What is not done in each frame of a cycle, or not in each round, counts by its share.
  const eachOf = (frames: readonly (readonly Span[])[], time: keyof Span) =>
    frames.map((spans) =>
      usual(
        spans.map((span) => span[time]),
        rounds,
      ),
    );
  const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / cycle;
  const cost = (pass: string, frames: readonly (readonly Span[])[]): PassCost => ({
    pass,
    copies: mean(eachOf(frames, "ms")),
    gpuMs: clock.isReal ? mean(eachOf(frames, "gpuMs")) : null,
  });
  const { width, height, gpuBytes } = element.stats;
  return {
    renderer: clock.renderer,
    quality,
    doing,
    ...(lights && { lights }),
    width,
    height,
    rounds,
    readyMs,
    scriptMs: median(scripts),
    draws,
    gpuBytes,
    copyMs: median(copies),
    frame: cost("frame", wholes),
    worst: Math.max(...eachOf(wholes, "ms")),
    worstGpuMs: clock.isReal ? Math.max(...eachOf(wholes, "gpuMs")) : null,
    passes: [...passes].map(([pass, frames]) => cost(pass, frames)),
  };
}

/** The median of what was measured, as a share of all rounds. */
function usual(values: readonly number[], rounds: number): number {
  return values.length > 0 ? (median(values) * values.length) / rounds : 0;
}

interface Span {
  /** Until the GPU was done, milliseconds. */
  readonly ms: number;
  /** By its own clock, milliseconds; 0 where it has none. */
  readonly gpuMs: number;
}

/** Times what is drawn in a context, as a whole or pass by pass, and copies beside it. */
class Clock {
  readonly renderer: string;
  readonly isReal: boolean;
  readonly #gl: WebGL2RenderingContext;
  readonly #timer: { TIME_ELAPSED_EXT: number } | null;
  readonly #originals = {
    draw: Gpu.prototype.draw,
    resolve: Gpu.prototype.resolve,
    begin: GpuTimer.prototype.begin,
  };
  readonly #copier: Copier;
  readonly #pixel = new Uint8Array(4);
  #passes: Map<string, { ms: number; queries: WebGLQuery[] }> | null = null;
  #pass = "";
  #isWhole = false;
  #begin = 0;
  #query: WebGLQuery | null = null;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    this.renderer = String(gl.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
    this.#timer = gl.getExtension("EXT_disjoint_timer_query_webgl2");
    this.isReal = this.#timer !== null && !isSoftware(this.renderer);
    this.#copier = new Copier();
    const clock = this;
    const { draw, resolve } = this.#originals;
    Gpu.prototype.draw = function (how: Draw) {
      clock.#enter(how.program.label.split(" ")[0] ?? "");
      draw.call(this, how);
    };
    Gpu.prototype.resolve = function (...args) {
      clock.#enter("resolve");
      resolve.apply(this, args);
    };
    // Queries of one kind do not nest.
    GpuTimer.prototype.begin = () => {};
  }

  /** Time of one copy, milliseconds. */
  copy(): number {
    return this.#copier.time();
  }

  /** A GPU with little to do lowers its clock. */
  #keepClockUp(): void {
    if (this.isReal) this.#copier.draw(BUSY);
  }

  /** All that a frame draws. */
  async time(frame: () => void): Promise<Span> {
    this.#keepClockUp();
    this.#isWhole = true;
    this.#begin = Number.NaN;
    frame();
    this.#endQuery();
    this.wait();
    this.#isWhole = false;
    const ms = performance.now() - this.#begin;
    return { ms, gpuMs: await this.#read(this.#query) };
  }

  /** Of each pass, in the order of the first draw. */
  async timeEach(frame: () => void): Promise<Map<string, Span>> {
    this.#keepClockUp();
    this.#passes = new Map();
    this.#pass = "";
    frame();
    this.#enter("");
    const passes = this.#passes;
    this.#passes = null;
    const spans = new Map<string, Span>();
    for (const [pass, { ms, queries }] of passes) {
      let gpuMs = 0;
      for (const query of queries) gpuMs += await this.#read(query);
      spans.set(pass, { ms, gpuMs });
    }
    return spans;
  }

  #enter(pass: string): void {
    if (this.#isWhole && Number.isNaN(this.#begin)) {
      this.wait();
      this.#query = this.#beginQuery();
      this.#begin = performance.now();
    }
    if (!this.#passes || pass === this.#pass) return;
    if (this.#pass !== "") {
      this.#endQuery();
      this.wait();
      const known = this.#passes.get(this.#pass) ?? { ms: 0, queries: [] };
      known.ms += performance.now() - this.#begin;
      if (this.#query) known.queries.push(this.#query);
      this.#passes.set(this.#pass, known);
    } else this.wait();
    this.#pass = pass;
    this.#query = pass === "" ? null : this.#beginQuery();
    this.#begin = performance.now();
  }

  /** Until the GPU is done. Chromium's `finish` returns before; reading a pixel does not. */
  wait(): void {
    const gl = this.#gl;
    const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, this.#pixel);
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
  }

  #beginQuery(): WebGLQuery | null {
    if (!this.isReal || !this.#timer) return null;
    const query = this.#gl.createQuery();
    if (query) this.#gl.beginQuery(this.#timer.TIME_ELAPSED_EXT, query);
    return query;
  }

  #endQuery(): void {
    if (this.isReal && this.#timer) this.#gl.endQuery(this.#timer.TIME_ELAPSED_EXT);
  }

  async #read(query: WebGLQuery | null): Promise<number> {
    if (!query) return 0;
    const gl = this.#gl;
    while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE)) {
      await new Promise((resolve) => setTimeout(resolve));
    }
    const nanoseconds = gl.getQueryParameter(query, gl.QUERY_RESULT) as number;
    gl.deleteQuery(query);
    return nanoseconds / 1e6;
  }

  dispose(): void {
    const { draw, resolve, begin } = this.#originals;
    Object.assign(Gpu.prototype, { draw, resolve });
    GpuTimer.prototype.begin = begin;
    this.#copier.dispose();
  }
}

const COPY_VERTEX = `#version 300 es
out vec2 vUv;
void main() {
  vUv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(vUv * 2.0 - 1.0, 0.0, 1.0);
}`;
const COPY_FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D uSource;
in vec2 vUv;
out vec4 oColor;
void main() { oColor = texture(uSource, vUv); }`;

/** The unit: one texture of 640 x 360 pixels of RGBA8 copied to another, in a context of its own. */
class Copier {
  readonly #gl: WebGL2RenderingContext;
  readonly #pixel = new Uint8Array(4);

  constructor() {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) throw new Error("There is no second context.");
    this.#gl = gl;
    const program = gl.createProgram();
    for (const [type, source] of [
      [gl.VERTEX_SHADER, COPY_VERTEX],
      [gl.FRAGMENT_SHADER, COPY_FRAGMENT],
    ] as const) {
      const shader = gl.createShader(type);
      if (!shader) throw new Error("There is no shader.");
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    const texture = () => {
      const made = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, made);
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 640, 360);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
      return made;
    };
    const target = texture();
    texture();
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    gl.viewport(0, 0, 640, 360);
    this.time();
  }

  /** Copies, and waits for none. */
  draw(copies: number): void {
    for (let i = 0; i < copies; i++) this.#gl.drawArrays(this.#gl.TRIANGLES, 0, 3);
    this.#gl.flush();
  }

  /** Milliseconds. */
  time(): number {
    const gl = this.#gl;
    const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, this.#pixel);
    wait();
    const begin = performance.now();
    this.draw(COPIES);
    wait();
    return (performance.now() - begin) / COPIES;
  }

  dispose(): void {
    this.#gl.getExtension("WEBGL_lose_context")?.loseContext();
  }
}
