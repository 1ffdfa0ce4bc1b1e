import { Gpu } from "../gl/gpu.js";
import type { SceneName } from "../settings.js";

/** Where pictures are drawn, and the canvas that shows them. */
export interface Screen {
  readonly gpu: Gpu;
  /** The canvas that owns the WebGL context and hears of its loss. */
  readonly source: HTMLCanvasElement;
  /** The canvas on the page. */
  readonly canvas: HTMLCanvasElement;
  /** Colours that it can show, now: a window may move to another screen. */
  readonly gamut: PredefinedColorSpace;
  /** Takes charge of what lives on `gpu`, to free it with the rest. */
  own(object: { dispose(): void }): void;
  /** Frees what the renderer made on `gpu`; the context stays. */
  clear(): void;
  /** The same, except what the next renderer of the same scene can take over. */
  clearUnshared(): void;
  /** A new `gpu`, after a lost context was given back. */
  renew(): void;
  /** To be called before anything is drawn. */
  prepare(): void;
  /** Shows what was drawn. In the task that drew it: afterwards the browser owns the pixels. */
  present(): void;
  dispose(): void;
}

/** Where a scene's pictures are drawn, to be seen on the canvas. Throws where there is no WebGL 2. */
export function createScreen(scene: SceneName, canvas: HTMLCanvasElement): Screen {
  return scene === "candle" ? new SharedScreen(canvas) : new OwnScreen(canvas);
}

/** A canvas with a WebGL context of its own. */
class OwnScreen implements Screen {
  gpu: Gpu;
  readonly source: HTMLCanvasElement;
  readonly canvas: HTMLCanvasElement;
  readonly #wide = matchMedia("(color-gamut: p3)");

  constructor(canvas: HTMLCanvasElement) {
    this.source = canvas;
    this.canvas = canvas;
    this.gpu = new Gpu(canvas);
  }

  get gamut(): PredefinedColorSpace {
    return this.#wide.matches ? "display-p3" : "srgb";
  }

  own(): void {}

  clear(): void {
    this.gpu.clearObjects();
  }

  clearUnshared(): void {
    this.gpu.clearUnshared();
  }

  renew(): void {
    this.gpu = new Gpu(this.canvas);
  }

  prepare(): void {}

  present(): void {}

  dispose(): void {
    this.gpu.dispose();
  }
}

/** The context that all lone candles share, since a page may have many and browsers give sixteen. */
class House {
  readonly canvas = document.createElement("canvas");
  gpu = new Gpu(this.canvas);
  users = 0;
  #isStale = false;

  constructor() {
    this.canvas.addEventListener("webglcontextlost", () => {
      this.#isStale = true;
    });
  }

  /** The first to ask after a loss renews it for all. */
  renew(): void {
    if (!this.#isStale) return;
    this.#isStale = false;
    this.gpu = new Gpu(this.canvas);
  }

  /** Large enough for each: those that are smaller use its corner. */
  hold(width: number, height: number): void {
    if (this.canvas.width < width) this.canvas.width = width;
    if (this.canvas.height < height) this.canvas.height = height;
  }
}

let house: House | null = null;

/** A plain canvas that takes copies of what is drawn in the shared context. */
class SharedScreen implements Screen {
  readonly canvas: HTMLCanvasElement;
  /** Pages are of sRGB's colours, and this lies upon one. */
  readonly gamut = "srgb";
  readonly #house: House;
  readonly #paper: CanvasRenderingContext2D;
  readonly #owned = new Set<{ dispose(): void }>();
  #isDisposed = false;

  constructor(canvas: HTMLCanvasElement) {
    const paper = canvas.getContext("2d");
    if (!paper) throw new Error("There is no canvas to draw on.");
    this.canvas = canvas;
    this.#paper = paper;
    if (!house || house.gpu.isLost) house = new House();
    this.#house = house;
    house.users++;
  }

  get gpu(): Gpu {
    return this.#house.gpu;
  }

  get source(): HTMLCanvasElement {
    return this.#house.canvas;
  }

  own(object: { dispose(): void }): void {
    this.#owned.add(object);
  }

  clear(): void {
    for (const object of this.#owned) object.dispose();
    this.#owned.clear();
  }

  clearUnshared(): void {
    this.clear();
  }

  renew(): void {
    this.#owned.clear(); // gone with the context
    this.#house.renew();
  }

  /** Before a frame: the shared canvas must hold it. */
  prepare(): void {
    this.#house.hold(this.canvas.width, this.canvas.height);
  }

  present(): void {
    const { width, height } = this.canvas;
    const from = this.#house.canvas.height - height;
    this.#paper.clearRect(0, 0, width, height);
    this.#paper.drawImage(this.#house.canvas, 0, from, width, height, 0, 0, width, height);
  }

  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.clear();
    this.#house.users--;
    if (this.#house.users > 0) return;
    this.#house.gpu.dispose();
    if (house === this.#house) house = null;
  }
}
