import type { FrameCounts } from "./frame-counts.js";

/** Queries in flight: results come a few frames late. */
const RING = 4;

/** GPU time of frames, where the driver offers `EXT_disjoint_timer_query_webgl2`. Nothing waits. */
export class GpuTimer {
  readonly #gl: WebGL2RenderingContext;
  readonly #extension: { TIME_ELAPSED_EXT: number; GPU_DISJOINT_EXT: number } | null;
  readonly #pending: { readonly query: WebGLQuery; readonly counts: FrameCounts }[] = [];
  #isRunning = false;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#extension = gl.getExtension("EXT_disjoint_timer_query_webgl2");
  }

  /** @param counts of the frame's view: several may share the context */
  begin(counts: FrameCounts): void {
    if (!this.#extension) return;
    this.end(); // a frame that threw
    this.#collect(this.#extension.GPU_DISJOINT_EXT);
    if (this.#pending.length >= RING) return;
    const query = this.#gl.createQuery();
    if (!query) return;
    this.#gl.beginQuery(this.#extension.TIME_ELAPSED_EXT, query);
    this.#pending.push({ query, counts });
    this.#isRunning = true;
  }

  end(): void {
    if (!this.#extension || !this.#isRunning) return;
    this.#gl.endQuery(this.#extension.TIME_ELAPSED_EXT);
    this.#isRunning = false;
  }

  #collect(disjointFlag: number): void {
    const gl = this.#gl;
    const oldest = this.#pending[0];
    if (!oldest || !gl.getQueryParameter(oldest.query, gl.QUERY_RESULT_AVAILABLE)) return;
    // A disjoint clock (the GPU slept, or changed its frequency) makes all numbers meaningless. Reading it resets it.
    if (gl.getParameter(disjointFlag)) {
      this.dispose();
      return;
    }
    const nanoseconds = gl.getQueryParameter(oldest.query, gl.QUERY_RESULT) as number;
    oldest.counts.seconds = nanoseconds / 1e9;
    gl.deleteQuery(oldest.query);
    this.#pending.shift();
  }

  dispose(): void {
    for (const { query } of this.#pending) this.#gl.deleteQuery(query);
    this.#pending.length = 0;
  }
}
