import type { CandleFlameElement, Stats } from "../../candle-flame-element.js";
import { find } from "../find.js";
import type { Comparison } from "./comparison.js";
import { formatMilliseconds } from "./ladder-chart.js";
import { addRows, readWhileOpen } from "./readings.js";

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

/**
 * Lists the element's statistics, read twice a second.
 *
 * @param comparison whose loop draws the element while it is open
 * @returns to be called when the lab is shown or hidden
 */
export function bindReadOut(
  section: HTMLDetailsElement,
  element: CandleFlameElement,
  comparison: Comparison,
): () => void {
  const values = addRows(find(section, "dl", HTMLElement), Object.keys(ROWS));
  return readWhileOpen(section, INTERVAL, () => {
    const { stats, paused } = element;
    const frameMs = paused ? comparison.frameMs : stats.frameMs;
    for (const [name, value] of values) value.textContent = ROWS[name]?.(stats, frameMs) ?? "";
  });
}
