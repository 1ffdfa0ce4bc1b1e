/** Context that an object is created in; `forget` is called when it is disposed of. */
export interface GpuContext {
  readonly gl: WebGL2RenderingContext;
  readonly forget: (object: GpuObject) => void;
}

/** An object in GPU memory: created by `Gpu`, counted by it, and gone after `dispose()`. */
export abstract class GpuObject {
  readonly label: string;
  /** Memory it takes, in bytes, as far as WebGL lets us know. */
  abstract readonly bytes: number;
  protected readonly gl: WebGL2RenderingContext;
  readonly #forget: (object: GpuObject) => void;

  constructor({ gl, forget }: GpuContext, label: string) {
    this.gl = gl;
    this.label = label;
    this.#forget = forget;
  }

  dispose(): void {
    this.free();
    this.#forget(this);
  }

  protected abstract free(): void;
}

/** The context was lost while an object was created. */
export class ContextLostError extends Error {
  override readonly name = "ContextLostError";
}

/** The driver could not allocate or draw. The message is a sentence for the visitor; `cause` has the details. */
export class GraphicsError extends Error {
  override readonly name = "GraphicsError";
}

export function incomplete(label: string, status: GLenum): GraphicsError {
  const cause = new Error(`${label}: framebuffer incomplete (0x${status.toString(16)})`);
  return new GraphicsError("The graphics driver refuses a surface to draw on.", { cause });
}

/** The result of a `create*` call of WebGL; throws if there is none. */
export function created<T>(gl: WebGL2RenderingContext, object: T | null, label: string): T {
  if (object !== null && !gl.isContextLost()) return object;
  if (gl.isContextLost()) throw new ContextLostError(`${label}: the WebGL context is lost.`);
  throw outOfMemory(label);
}

export function outOfMemory(label: string): GraphicsError {
  const cause = new Error(`${label}: WebGL is out of memory.`);
  return new GraphicsError("The graphics driver has no memory left for the picture.", { cause });
}
