import loadFrag from "../../shaders/speed/load.frag";
import type { Gpu } from "../gl/gpu.js";
import { nextTask } from "../gl/next-task.js";

/** A slower pixel of the load is that of a software renderer, seconds: on two cores one takes 4e-7, on an H200 6e-9. */
export const SOFTWARE_PIXEL = 5e-8;

/** Of the load, which is kept for another measurement until everything is cleared. */
const KEY = "speed";
/** Edge of the largest square drawn, pixels. */
const EDGE = 512;
/** Pixels drawn, from the least to the most, each load four times the one before: a fast GPU draws a million in 0.1 ms. */
const LEAST_PIXELS = 16 ** 2;
const MOST_PIXELS = 8192 ** 2;
/** Least time of a reliable measurement, and a time that needs no other load to compare with, seconds. */
const LEAST_TIME = 0.012;
const LONG_TIME = 0.05;
/** Differences of this size may be the clock's, seconds. */
const CLOCK_NOISE = 0.001;
/** Repetitions, of which the shortest counts: other work only adds time. */
const TRIES = 3;
/** Tasks that take longer, together, than the step of any browser's clock: some have a tenth of a second. */
const TASKS = 20_000;
/** Edge of the sampled texture, texels. */
const TEXELS = 64;

const measured = new WeakMap<Gpu, Promise<number | null>>();

/** The time, seconds. */
type Clock = () => number;

/**
 * Time for a pixel of `speed/load.frag`, seconds, measured once or `again`, without blocking; a software renderer takes 0.1
 * to 0.4 s. Null if the context is lost or cleared, or the clock stands still.
 */
export function measureSpeed(gpu: Gpu, clock: Clock, again = false): Promise<number | null> {
  const pixel = (!again && measured.get(gpu)) || measure(gpu, clock);
  measured.set(gpu, pixel);
  return pixel;
}

async function measure(gpu: Gpu, clock: Clock): Promise<number | null> {
  try {
    const load = gpu.share(KEY, () => new Load(gpu, clock));
    const pixel = await load.pixel();
    if (gpu.isLost) measured.delete(gpu);
    else if (load.isGone) return measure(gpu, clock); // cleared for another renderer meanwhile
    return Number.isNaN(pixel) ? null : pixel;
  } catch {
    return null; // the renderer reports the error
  }
}

/**
 * Seconds for a pixel, from the smallest load of a reliable time, else from the largest. NaN where no time passes.
 *
 * @param draw draws so many pixels, a square number, and gives the time it took, seconds
 * @param wait waits longer than a step of the clock, and gives the time it took, seconds
 */
export async function secondsPerPixel(
  draw: (pixels: number) => Promise<number>,
  wait: () => Promise<number>,
): Promise<number> {
  let total = 0;
  const shortest = async (pixels: number) => {
    let least = Infinity;
    for (let i = 0; i < TRIES; i++) {
      const time = await draw(pixels);
      total += time;
      least = Math.min(least, time);
    }
    return least;
  };
  const overhead = await shortest(1);
  let before = CLOCK_NOISE;
  let growth = 0;
  for (let pixels = LEAST_PIXELS; ; pixels *= 4) {
    const time = await shortest(pixels);
    const net = Math.max(time - overhead, CLOCK_NOISE);
    // Time that does not grow with the load, twice, is that of other tasks.
    growth = net > 2.5 * before ? growth + 1 : 0;
    before = net;
    const isReliable = net > LONG_TIME || (net > LEAST_TIME && growth > 1);
    if (isReliable || !(pixels < MOST_PIXELS && time < Infinity)) return time / pixels;
    // A page's test has stopped the clock.
    if (total === 0 && pixels === EDGE ** 2 && (await wait()) === 0) return Number.NaN;
  }
}

/** A square of `speed/load.frag`. */
class Load {
  readonly #gpu: Gpu;
  readonly #clock: Clock;
  readonly #program;
  readonly #texture;
  readonly #target;

  constructor(gpu: Gpu, clock: Clock) {
    this.#gpu = gpu;
    this.#clock = clock;
    this.#program = gpu.pass("speed/load", loadFrag);
    const source = { width: TEXELS, height: TEXELS };
    const label = KEY;
    this.#texture = gpu.texture({
      label,
      format: "R16F",
      source,
      shape: "cube",
      filter: "nearest",
    });
    this.#clearFaces();
    this.#target = gpu.renderTarget({ label, width: EDGE, height: EDGE, color: ["RGBA8"] });
  }

  /** Drivers clear undrawn textures on first use, which must not be measured. */
  #clearFaces(): void {
    for (let image = 0; image < 6; image++) {
      const textures = [this.#texture];
      const face = this.#gpu.textureView({ label: KEY, textures, image });
      this.#gpu.clear(face, [1, 0, 0, 1]);
      face.dispose();
    }
  }

  /** Seconds for a pixel. */
  async pixel(): Promise<number> {
    await this.#gpu.whenCompiled();
    await this.#time(1); // drivers finish a program on its first draw
    const wait = async () => {
      const begin = this.#clock();
      for (let i = 0; i < TASKS; i++) await nextTask();
      return this.#clock() - begin;
    };
    return secondsPerPixel((pixels) => this.#time(pixels), wait);
  }

  get isGone(): boolean {
    return this.#gpu.isLost || !this.#gpu.isShared(KEY);
  }

  async #time(pixels: number): Promise<number> {
    if (this.isGone) return Number.NaN;
    const edge = Math.min(Math.sqrt(pixels), EDGE);
    const begin = this.#clock();
    for (let left = pixels; left > 0; left -= edge ** 2) {
      this.#gpu.draw({
        program: this.#program,
        target: this.#target,
        textures: { uTexture: this.#texture },
        viewport: [0, 0, edge, edge],
      });
    }
    await this.#gpu.whenIdle(Number.POSITIVE_INFINITY);
    return this.isGone ? Number.NaN : this.#clock() - begin;
  }
}
