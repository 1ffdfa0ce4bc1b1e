import { Gpu } from "../gl/gpu.js";
import type { SceneName } from "../settings.js";

/** Where pictures are drawn, and the canvas that shows them. */
export interface Screen {
  readonly gpu: Gpu;
  /** The canvas that owns the WebGL context and hears of its loss. */
  readonly source: HTMLCanvasElement;
  /** The canvas on the page. */
  readonly canvas: HTMLCanvasElement;
  /** Frees what the renderer made on `gpu`; the context stays. */
  clear(): void;
  /** A new `gpu`, after a lost context was given back. */
  renew(): void;
  /** Shows what was drawn. In the task that drew it: afterwards the browser owns the pixels. */
  present(): void;
  dispose(): void;
}

/** Where a scene's pictures are drawn, to be seen on the canvas. Throws where there is no WebGL 2. */
export function createScreen(_scene: SceneName, canvas: HTMLCanvasElement): Screen {
  return new OwnScreen(canvas);
}

/** A canvas with a WebGL context of its own. */
class OwnScreen implements Screen {
  gpu: Gpu;
  readonly source: HTMLCanvasElement;
  readonly canvas: HTMLCanvasElement;

  constructor(canvas: HTMLCanvasElement) {
    this.source = canvas;
    this.canvas = canvas;
    this.gpu = new Gpu(canvas);
  }

  clear(): void {
    this.gpu.clearObjects();
  }

  renew(): void {
    this.gpu = new Gpu(this.canvas);
  }

  present(): void {}

  dispose(): void {
    this.gpu.dispose();
  }
}
