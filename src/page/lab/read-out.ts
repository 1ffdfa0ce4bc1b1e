import type { CandleFlameElement, Stats } from "../../candle-flame-element.js";
import type { Comparison } from "./comparison.js";
import { formatMilliseconds } from "./ladder-chart.js";
import { addRows } from "./readings.js";

const INTERVAL = 500;

/** Statistics of the last frame, by name. A dash stands for what is not known here or now. */
const ROWS: Readonly<Record<string, (stats: Stats, frameMs: number | null) => string>> = {
  "frames per second": (_, frameMs) => (frameMs ? (1000 / frameMs).toFixed(0) : "–"),
  "from frame to frame": (_, frameMs) => (frameMs ? `${formatMilliseconds(frameMs)} ms` : "–"),
  CPU: ({ cpuMs }) => `${formatMilliseconds(cpuMs)} ms`,
  GPU: ({ gpuMs }) => (gpuMs === null ? "–" : `${formatMilliseconds(gpuMs)} ms`),
  "draw calls": ({ drawCalls }) => String(drawCalls),
  triangles: ({ triangles }) => triangles.toLocaleString("en"),
  particles: ({ particles }) => particles.toLocaleString("en"),
  picture: ({ width, height }) => `${width} × ${height}`,
  "GPU objects": ({ gpuObjects }) => String(gpuObjects),
  "GPU memory": ({ gpuBytes }) => `${(gpuBytes / 1e6).toFixed(1)} MB`,
};

/** The element's statistics, read twice a second while the lab is open. */
export class ReadOut {
  readonly #element: CandleFlameElement;
  readonly #comparison: Comparison;
  readonly #values: ReadonlyMap<string, HTMLElement>;
  #timer = 0;

  /** @param comparison whose loop draws the element while it is open */
  constructor(element: CandleFlameElement, list: HTMLElement, comparison: Comparison) {
    this.#element = element;
    this.#comparison = comparison;
    this.#values = addRows(list, Object.keys(ROWS));
  }

  start(): void {
    this.stop();
    this.refresh();
    this.#timer = window.setInterval(() => this.refresh(), INTERVAL);
  }

  stop(): void {
    clearInterval(this.#timer);
  }

  refresh(): void {
    const { stats, paused } = this.#element;
    const frameMs = paused ? this.#comparison.frameMs : stats.frameMs;
    for (const [name, row] of Object.entries(ROWS)) {
      const value = this.#values.get(name);
      if (value) value.textContent = row(stats, frameMs);
    }
  }
}
