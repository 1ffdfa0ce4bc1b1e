import type { CandleFlameElement, Feature } from "../../src/candle-flame-element.js";

/** Times of the paper's Table 1, in milliseconds on its author's unnamed GPU. */
export const STEPS = [
  { name: "baseline, no particles", adds: null, paper: 2.1 },
  { name: "+ basic emission", adds: "particles", paper: 4.5 },
  { name: "+ gradient shading", adds: "gradient", paper: 5.2 },
  { name: "+ attenuation", adds: "attenuation", paper: 6.7 },
  { name: "+ drift", adds: "drift", paper: 7.5 },
] as const satisfies readonly { name: string; adds: Feature | null; paper: number }[];

export interface LadderStep {
  readonly name: string;
  /** The least of all rounds: a busy machine can only add to it. */
  readonly frameMs: number;
  /** That time to the baseline's. */
  readonly multiple: number;
  readonly paperMs: number;
  readonly paperMultiple: number;
}

export interface Ladder {
  readonly renderer: string;
  readonly width: number;
  readonly height: number;
  readonly quality: string;
  readonly particles: number;
  readonly rounds: number;
  readonly steps: readonly LadderStep[];
}

const FRAME = 1 / 60;
/** Frames of a step in a round. The first is not counted: it catches up with what was switched. */
const FRAMES = 5;

/** The paper's Table 1 on the element itself: one more feature each step, rounds interleaved. */
export async function measureLadder(rounds: number): Promise<Ladder> {
  const element = document.createElement("candle-flame");
  element.paused = true;
  element.look = "paper";
  element.quality = "medium";
  element.assetBase = "/";
  document.body.replaceChildren(element);
  await element.ready;
  const gl = contextOf(element);
  const times = STEPS.map((): number[] => []);
  for (let round = 0; round < rounds; round++) {
    STEPS.forEach((_, step) => {
      climb(element, step);
      const frames = Array.from({ length: FRAMES }, () => timeFrame(element, gl));
      times[step]!.push(...frames.slice(1));
    });
  }
  const { width, height, quality, particles } = element.stats;
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const renderer = String(gl.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  element.remove();
  const least = times.map((rounds) => Math.min(...rounds));
  const steps = STEPS.map(({ name, paper }, step) => ({
    name,
    frameMs: least[step]!,
    multiple: least[step]! / least[0]!,
    paperMs: paper,
    paperMultiple: paper / STEPS[0].paper,
  }));
  return { renderer, width, height, quality, particles, rounds, steps };
}

function climb({ features }: CandleFlameElement, step: number): void {
  STEPS.forEach(({ adds }, i) => {
    // Drift makes the particles anew when set, so it is set only when it changes.
    if (adds && features[adds] !== i <= step) features[adds] = i <= step;
  });
}

function timeFrame(element: CandleFlameElement, gl: WebGL2RenderingContext): number {
  const begin = performance.now();
  element.step(FRAME);
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - begin;
}

// The element's own way to read pixels, readRadiance, may draw the frame a second time.
function contextOf(element: CandleFlameElement): WebGL2RenderingContext {
  const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
  if (!gl) throw new Error("The element has no picture.");
  return gl;
}
