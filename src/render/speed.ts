import fullscreenVert from "../../shaders/post/fullscreen.vert";
import loadFrag from "../../shaders/speed/load.frag";
import type { Gpu } from "../gl/gpu.js";

/** How fast a GPU was measured to be. */
export interface Speed {
  /** Time for a pixel of `speed/load.frag`, seconds. */
  readonly pixel: number;
  /** The same for one of `GRAZING` footprints, with anisotropic filtering, seconds. */
  readonly anisotropicPixel: number;
}

/** Edges of the squares that are drawn, pixels: each has four times as many as the one before. */
const EDGES = [16, 32, 64, 128, 256, 512, 1024] as const;
/** A draw that takes this long says enough, seconds. */
const LONG = 0.006;
/** Each is drawn so often; the least counts, since other work can only add to it. */
const TRIES = 3;
/** Texels along the edge of the texture that is read. */
const TEXELS = 64;

const known = new WeakMap<Gpu, Promise<Speed | null>>();

/** Tells the time, seconds. */
type Clock = () => number;

/** Measures once, in 0.15 to 0.4 s where a CPU draws, without blocking. Null where the context is lost. */
export function measureSpeed(gpu: Gpu, clock: Clock): Promise<Speed | null> {
  const speed = known.get(gpu) ?? measure(gpu, clock);
  known.set(gpu, speed);
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
    return null; // what is wrong with this GPU shows where something is to be drawn
  } finally {
    for (const one of loads) one.dispose();
  }
}

/** One load, at any size. */
class Load {
  readonly #gpu: Gpu;
  readonly #clock: Clock;
  readonly #program;
  readonly #texture;
  readonly #target;
  readonly #screen;

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
    if (!isGrazing) this.#clearFaces();
    const edge = Math.max(...EDGES);
    this.#target = gpu.renderTarget({
      label: "speed",
      width: edge,
      height: edge,
      color: ["RGBA8"],
    });
    this.#screen = gpu.vertexArray("speed", { attributes: {}, count: 3 });
  }

  /** Drivers clear what nobody has drawn when it is first read. */
  #clearFaces(): void {
    for (let image = 0; image < 6; image++) {
      const textures = [this.#texture];
      const face = this.#gpu.textureView({ label: "speed", textures, image });
      this.#gpu.clear(face, [1, 0, 0, 1]);
      face.dispose();
    }
  }

  /** Seconds for a pixel, of the smallest square that takes long enough. */
  async pixel(anisotropy = 1): Promise<number> {
    await this.#gpu.whenCompiled();
    await this.#time(1, anisotropy); // drivers finish a program with its first draw
    const overhead = await this.#least(1, anisotropy);
    for (const edge of EDGES) {
      const time = await this.#least(edge, anisotropy);
      if (time < LONG && edge !== EDGES.at(-1)) continue;
      // What is shorter than the clock's step is none at all; then the whole is an upper bound.
      return (time > 2 * overhead ? time - overhead : time) / edge ** 2;
    }
    return Number.NaN;
  }

  async #least(edge: number, anisotropy: number): Promise<number> {
    let least = Infinity;
    for (let i = 0; i < TRIES; i++) least = Math.min(least, await this.#time(edge, anisotropy));
    return least;
  }

  async #time(edge: number, anisotropy: number): Promise<number> {
    const begin = this.#clock();
    this.#gpu.draw({
      program: this.#program,
      target: this.#target,
      vertexArray: this.#screen,
      textures: { uTexture: this.#texture },
      sampling: { uTexture: { anisotropy } },
      viewport: [0, 0, edge, edge],
    });
    await this.#gpu.whenIdle();
    return this.#gpu.isLost ? Number.NaN : this.#clock() - begin;
  }

  dispose(): void {
    for (const object of [this.#program, this.#texture, this.#target, this.#screen]) {
      object.dispose();
    }
  }
}
