import type { TierName } from "./passes.js";
import { median } from "./statistics.js";

const SIZE = { width: 320, height: 180 } as const;
const CAMERA = { position: [-0.85, 1.3, 1.1], yaw: -0.805, pitch: -0.244 } as const;
/** Metres and radians of a frame's way, seconds, and frames to and fro. */
const STRIDE = { away: 0.047, turned: 0.02, seconds: 1 / 30 } as const;
const CYCLE = 2;
/** Time for the programs of motion to be compiled, milliseconds. */
const COMPILATION = 10_000;

/** Times of a frame with standing candles lit, as multiples of its time without. */
export interface CandleCost {
  readonly candles: number;
  readonly atRest: number;
  readonly inMotion: number;
}

/** An element for each number of standing candles; their frames interleaved. */
export async function measureCandles(
  quality: TierName,
  numbers: readonly number[],
  rounds: number,
): Promise<CandleCost[]> {
  document.body.replaceChildren();
  const scenes = [];
  for (const candles of [0, ...numbers]) scenes.push(await open(quality, candles));
  await new Promise((resolve) => setTimeout(resolve, COMPILATION));
  for (let round = 0; round <= rounds; round++) {
    for (const { inMotion, atRest, frame } of scenes) {
      const [moving, resting] = [frame(true), frame(false)];
      // The first is not counted: what is drawn for the first time is compiled.
      if (round === 0) continue;
      inMotion.push(moving);
      atRest.push(resting);
    }
  }
  const [first, ...others] = scenes;
  document.body.replaceChildren();
  if (!first) return [];
  return others.map(({ candles, atRest, inMotion }) => ({
    candles,
    atRest: median(atRest) / median(first.atRest),
    inMotion: median(inMotion) / median(first.inMotion),
  }));
}

async function open(quality: TierName, candles: number) {
  const element = document.createElement("candle-flame");
  Object.assign(element, { paused: true, look: "physical", quality, assetBase: "/" });
  element.style.cssText = `width: ${SIZE.width}px; height: ${SIZE.height}px`;
  document.body.append(element);
  await element.ready;
  for (const candle of element.candles.slice(1, 1 + candles)) candle.light();
  element.camera = CAMERA;
  element.step(1);
  const gl = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
  if (!gl) throw new Error("The element has no picture.");
  const pixel = new Uint8Array(4);
  const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  /** Milliseconds of a frame, mean over a cycle. A playing element counts as in motion. */
  const frame = (isMoving: boolean) => {
    element.play();
    element.step(STRIDE.seconds);
    wait();
    const begin = performance.now();
    for (let number = 1; number <= CYCLE; number++) {
      const strides = isMoving ? number % CYCLE : 0;
      const [x, y, z] = CAMERA.position;
      element.camera = {
        ...CAMERA,
        position: [x - STRIDE.away * strides, y, z],
        yaw: CAMERA.yaw + STRIDE.turned * strides,
      };
      element.step(STRIDE.seconds);
      wait();
    }
    const elapsed = performance.now() - begin;
    element.pause();
    wait();
    return elapsed / CYCLE;
  };
  // In which the program of all flames is asked for.
  frame(false);
  return { candles, frame, inMotion: [] as number[], atRest: [] as number[] };
}
