import fullscreenVert from "../../shaders/post/fullscreen.vert";
import loadFrag from "../../shaders/speed/load.frag";
import type { Gpu } from "../gl/gpu.js";

/** Measured speed of a GPU. */
export interface Speed {
  /** Time for a pixel of `speed/load.frag`, seconds. */
  readonly pixel: number;
  /** The same for one of `GRAZING` footprints, with anisotropic filtering, seconds. */
  readonly anisotropicPixel: number;
}

/** Edge of the largest square drawn, pixels. */
const EDGE = 1024;
/** Edges of the squares, and how often they are drawn: a fast GPU draws a million pixels before a task has ended. */
const LOADS: readonly (readonly [edge: number, times: number])[] = [
  [16, 1],
  [32, 1],
  [64, 1],
  [128, 1],
  [256, 1],
  [512, 1],
  [EDGE, 1],
  [EDGE, 8],
  [EDGE, 32],
];
/** Least time of a reliable measurement, seconds. */
const LEAST_TIME = 0.006;
/** Repetitions, of which the shortest counts: other work only adds time. */
const TRIES = 3;
/** Edge of the sampled texture, texels. */
const TEXELS = 64;

const measured = new WeakMap<Gpu, Promise<Speed | null>>();

/** The time, seconds. */
type Clock = () => number;

/** Measures once, without blocking; a software renderer takes 0.15 to 0.4 s. Null if the context is lost. */
export function measureSpeed(gpu: Gpu, clock: Clock): Promise<Speed | null> {
  const speed = measured.get(gpu) ?? measure(gpu, clock);
  measured.set(gpu, speed);
  return speed;
}

async function measure(gpu: Gpu, clock: Clock): Promise<Speed | null> {
  const loads: Load[] = [];
  const load = (isGrazing: boolean) => {
    loads.push(new Load(gpu, isGrazing, clock));
    return loads.at(-1)!;
  };
  try {
    const pixel = await load(false).pixel();
    const anisotropicPixel = await load(true).pixel(8);
    return Number.isFinite(pixel + anisotropicPixel) ? { pixel, anisotropicPixel } : null;
  } catch {
    return null; // the renderer reports the error
  } finally {
    for (const each of loads) each.dispose();
  }
}

/** A square of `speed/load.frag`. */
class Load {
  readonly #gpu: Gpu;
  readonly #clock: Clock;
  readonly #program;
  readonly #texture;
  readonly #target;

  constructor(gpu: Gpu, isGrazing: boolean, clock: Clock) {
    this.#gpu = gpu;
    this.#clock = clock;
    const defines = { GRAZING: isGrazing ? 1 : 0 };
    this.#program = gpu.program("speed/load", fullscreenVert, loadFrag, { defines });
    const size = { width: TEXELS, height: TEXELS };
    this.#texture = gpu.texture(
      isGrazing
        ? {
            label: "speed",
            format: "RGBA8",
            source: { ...size, data: new Uint8Array(TEXELS * TEXELS * 4) },
            mipmaps: true,
            wrap: "repeat",
          }
        : { label: "speed", format: "R16F", source: size, shape: "cube", filter: "nearest" },
    );
    if (isGrazing) this.#texture.updateMipmaps();
    else this.#clearFaces();
    this.#target = gpu.renderTarget({
      label: "speed",
      width: EDGE,
      height: EDGE,
      color: ["RGBA8"],
    });
  }

  /** Drivers clear undrawn textures on first use, which must not be measured. */
  #clearFaces(): void {
    for (let image = 0; image < 6; image++) {
      const textures = [this.#texture];
      const face = this.#gpu.textureView({ label: "speed", textures, image });
      this.#gpu.clear(face, [1, 0, 0, 1]);
      face.dispose();
    }
  }

  /** Seconds for a pixel, from the smallest load of a reliable time, else from the largest. */
  async pixel(anisotropy = 1): Promise<number> {
    await this.#gpu.whenCompiled();
    await this.#time(1, 1, anisotropy); // drivers finish a program on its first draw
    const overhead = await this.#shortest(1, 1, anisotropy);
    let seconds = Number.NaN;
    for (const [edge, times] of LOADS) {
      const time = await this.#shortest(edge, times, anisotropy);
      // The overhead may be below the clock's resolution; then the whole time is an upper bound.
      seconds = (time > 2 * overhead ? time - overhead : time) / (edge ** 2 * times);
      if (!(time < LEAST_TIME)) break;
    }
    return seconds;
  }

  async #shortest(edge: number, times: number, anisotropy: number): Promise<number> {
    let shortest = Infinity;
    for (let i = 0; i < TRIES; i++)
      shortest = Math.min(shortest, await this.#time(edge, times, anisotropy));
    return shortest;
  }

  async #time(edge: number, times: number, anisotropy: number): Promise<number> {
    const begin = this.#clock();
    for (let i = 0; i < times; i++) {
      this.#gpu.draw({
        program: this.#program,
        target: this.#target,
        textures: { uTexture: this.#texture },
        sampling: { uTexture: { anisotropy } },
        viewport: [0, 0, edge, edge],
      });
    }
    await this.#gpu.whenIdle(Number.POSITIVE_INFINITY);
    return this.#gpu.isLost ? Number.NaN : this.#clock() - begin;
  }

  dispose(): void {
    for (const object of [this.#program, this.#texture, this.#target]) {
      object.dispose();
    }
  }
}
