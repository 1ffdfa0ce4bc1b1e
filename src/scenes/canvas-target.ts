import { Gpu } from "../gl/gpu.js";
import type { SceneName } from "../settings.js";
import { windowOf } from "../window-of.js";

/** A canvas on the page, and the WebGL context that its frames are drawn in. */
export abstract class CanvasTarget {
  abstract readonly gpu: Gpu;
  /** The canvas that owns the WebGL context, and gets the events of its loss. */
  abstract readonly source: HTMLCanvasElement;
  readonly canvas: HTMLCanvasElement;
  /** Primaries that the canvas can show now: a window may move to another monitor. */
  abstract readonly gamut: PredefinedColorSpace;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
  }

  /** Takes ownership of an object on `gpu`, to free it with the rest. */
  own<Owned extends { dispose(): void }>(object: Owned): Owned {
    return object;
  }
  /** Frees what the renderer made on `gpu`; the context stays. */
  abstract clear(): void;
  /** The same, except what the next renderer of the same scene can take over. */
  clearUnshared(): void {
    this.clear();
  }
  /** A new `gpu`, after a lost context was restored. */
  abstract renew(): void;
  /** To be called before a frame is drawn. */
  prepare(): void {}
  /** Shows the frame. In the task that drew it: afterwards the browser owns the pixels. */
  present(): void {}
  abstract dispose(): void;
}

/** The target that a scene is drawn to. Throws where there is no WebGL 2. */
export function createCanvasTarget(scene: SceneName, canvas: HTMLCanvasElement): CanvasTarget {
  return scene === "candle" ? new SharedContextTarget(canvas) : new DedicatedContextTarget(canvas);
}

class DedicatedContextTarget extends CanvasTarget {
  gpu = new Gpu(this.canvas);
  readonly source = this.canvas;
  readonly #wide = windowOf(this.canvas).matchMedia("(color-gamut: p3)");

  get gamut(): PredefinedColorSpace {
    return this.#wide.matches ? "display-p3" : "srgb";
  }

  clear(): void {
    this.gpu.clearObjects();
  }

  override clearUnshared(): void {
    this.gpu.clearUnshared();
  }

  renew(): void {
    this.gpu = new Gpu(this.canvas);
  }

  dispose(): void {
    this.gpu.dispose();
  }
}

/** Frames of each lone candle that the shared canvas keeps its size for. */
const KEPT = 60;

/** The context that all lone candles share: a page may have many, and browsers allow sixteen contexts. */
class SharedContext {
  readonly canvas = document.createElement("canvas");
  gpu = new Gpu(this.canvas, true);
  users = 0;
  #isStale = false;
  /** Frames since the canvas was last fitted, and the largest size among them. */
  #frames = 0;
  readonly #largest = { width: 0, height: 0 };

  constructor() {
    this.canvas.addEventListener("webglcontextlost", () => {
      this.#isStale = true;
    });
  }

  /** The first to ask after a loss renews it for all. */
  renew(): void {
    if (!this.#isStale) return;
    this.#isStale = false;
    this.gpu = new Gpu(this.canvas, true);
  }

  /** Fits the canvas to the largest target that draws; smaller ones use its corner. It shrinks after a while. */
  fit(target: HTMLCanvasElement): void {
    const isDue = ++this.#frames > KEPT * this.users;
    for (const side of ["width", "height"] as const) {
      const most = Math.max(this.#largest[side], target[side]);
      if (isDue ? this.canvas[side] !== most : this.canvas[side] < most) this.canvas[side] = most;
      this.#largest[side] = isDue ? 0 : most;
    }
    if (isDue) this.#frames = 0;
  }
}

let sharedContext: SharedContext | null = null;

/** A 2D canvas that frames drawn in the shared context are copied to. */
class SharedContextTarget extends CanvasTarget {
  /** The page around a lone candle is sRGB. */
  readonly gamut = "srgb";
  readonly #shared: SharedContext;
  readonly #copy: CanvasRenderingContext2D;
  readonly #owned = new Set<{ dispose(): void }>();
  #isDisposed = false;

  constructor(canvas: HTMLCanvasElement) {
    const copy = canvas.getContext("2d");
    if (!copy) throw new Error("There is no canvas to draw on.");
    super(canvas);
    this.#copy = copy;
    if (!sharedContext || sharedContext.gpu.isLost) sharedContext = new SharedContext();
    this.#shared = sharedContext;
    this.#shared.users++;
  }

  get gpu(): Gpu {
    return this.#shared.gpu;
  }

  get source(): HTMLCanvasElement {
    return this.#shared.canvas;
  }

  override own<Owned extends { dispose(): void }>(object: Owned): Owned {
    this.#owned.add(object);
    return object;
  }

  clear(): void {
    for (const object of this.#owned) object.dispose();
    this.#owned.clear();
  }

  renew(): void {
    this.#owned.clear(); // gone with the context
    this.#shared.renew();
  }

  override prepare(): void {
    this.#shared.fit(this.canvas);
  }

  override present(): void {
    const { width, height } = this.canvas;
    const from = this.#shared.canvas.height - height;
    this.#copy.clearRect(0, 0, width, height);
    this.#copy.drawImage(this.#shared.canvas, 0, from, width, height, 0, 0, width, height);
  }

  dispose(): void {
    if (this.#isDisposed) return;
    this.#isDisposed = true;
    this.clear();
    this.#shared.users--;
    if (this.#shared.users > 0) return;
    this.#shared.gpu.dispose();
    if (sharedContext === this.#shared) sharedContext = null;
  }
}
