import type { CandleFlameElement, Feature } from "../../candle-flame-element.js";

/** A step of the paper's Table 1: what it adds, and what a frame cost there. */
interface LadderStep {
  readonly name: string;
  readonly adds: readonly Feature[];
  readonly milliseconds: number;
  readonly perSecond: number;
}

/** "Dynamic Fire Effects Using OpenGL Rasterization Techniques", Table 1. */
export const LADDER_STEPS: readonly LadderStep[] = [
  { name: "no particles", adds: [], milliseconds: 2.1, perSecond: 475 },
  {
    name: "+ basic emission",
    adds: ["particles", "core", "hazeLayer"],
    milliseconds: 4.5,
    perSecond: 222,
  },
  { name: "+ gradient shading", adds: ["gradient"], milliseconds: 5.2, perSecond: 192 },
  { name: "+ attenuation", adds: ["attenuation"], milliseconds: 6.7, perSecond: 149 },
  { name: "+ drift", adds: ["drift"], milliseconds: 7.5, perSecond: 133 },
];

const TIME_STEP = 1 / 60;
/** Length to aim at for one burst of frames, in milliseconds: the page does not answer meanwhile. */
const BURST = 50;
const FEWEST_FRAMES = 4;
const MOST_FRAMES = 120;

/**
 * Measures the frame time of a paused element in the paper's look at each step of the ladder, which its features then are.
 *
 * Rounds go up and down the ladder in turn, so that a machine that warms up or slows down favours no
 * step. Rejects when the signal aborts.
 *
 * @param onProgress called after each burst, with each step's median frame time so far, milliseconds
 * @returns frames in one burst
 */
export async function climb(
  element: CandleFlameElement,
  rounds: number,
  signal: AbortSignal,
  onProgress: (fraction: number, medians: readonly number[]) => void,
): Promise<number> {
  await nextFrame(signal);
  const frames = framesThatFit(element);
  const times: number[][] = LADDER_STEPS.map(() => []);
  for (let round = 0; round < rounds; round++) {
    for (let i = 0; i < LADDER_STEPS.length; i++) {
      const step = round % 2 === 0 ? i : LADDER_STEPS.length - 1 - i;
      await nextFrame(signal);
      standOn(element, step);
      times[step]?.push(burst(element, frames));
      onProgress(
        (round * LADDER_STEPS.length + i + 1) / (rounds * LADDER_STEPS.length),
        times.map(median),
      );
    }
  }
  return frames;
}

function standOn({ features }: CandleFlameElement, step: number): void {
  LADDER_STEPS.forEach(({ adds }, i) => {
    for (const feature of adds) features[feature] = i <= step;
  });
}

function framesThatFit(element: CandleFlameElement): number {
  standOn(element, LADDER_STEPS.length - 1);
  const frames = Math.round(BURST / burst(element, FEWEST_FRAMES));
  return Math.min(Math.max(frames, FEWEST_FRAMES), MOST_FRAMES);
}

/** Mean time of a frame, in milliseconds. */
function burst(element: CandleFlameElement, frames: number): number {
  // One frame for the cost of the last change. Reading a pixel waits for the GPU.
  element.step(TIME_STEP);
  element.readRadiance(0, 0, 1, 1);
  const begin = performance.now();
  for (let i = 0; i < frames; i++) element.step(TIME_STEP);
  element.readRadiance(0, 0, 1, 1);
  return (performance.now() - begin) / frames;
}

function median(values: readonly number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  const middle = (sorted.length - 1) / 2;
  return ((sorted[Math.floor(middle)] ?? NaN) + (sorted[Math.ceil(middle)] ?? NaN)) / 2;
}

async function nextFrame(signal: AbortSignal): Promise<void> {
  await new Promise(requestAnimationFrame);
  signal.throwIfAborted();
}
