import { GraphicsError } from "../gl/gpu-object.js";

/** `graphics`: an allocation, a framebuffer or a frame that failed. */
export type ErrorType = "webgl-unavailable" | "asset" | "shader" | "graphics" | "context-lost";

export interface ErrorDetail {
  readonly type: ErrorType;
  readonly message: string;
  readonly cause: unknown;
}

/** The candle that was lit or went out. */
export interface CandleDetail {
  /** Its place in `candles`. */
  readonly index: number;
  readonly name: string;
}

export interface CandleFlameEventMap {
  progress: CustomEvent<{ readonly totalProgress: number }>;
  load: CustomEvent<null>;
  error: CustomEvent<ErrorDetail>;
  play: CustomEvent<null>;
  pause: CustomEvent<null>;
  place: CustomEvent<null>;
  take: CustomEvent<null>;
  enter: CustomEvent<null>;
  leave: CustomEvent<null>;
  light: CustomEvent<CandleDetail>;
  extinguish: CustomEvent<CandleDetail>;
  camerachange: CustomEvent<null>;
  qualitychange: CustomEvent<null>;
  contextlost: CustomEvent<null>;
  contextrestored: CustomEvent<null>;
}

/** Our events and those of every element. */
type EventMap = Omit<HTMLElementEventMap, keyof CandleFlameEventMap> & CandleFlameEventMap;

/** Type of an error, by its name. All others are of assets: most of what fails is a file. */
export function typeOf({ name }: Error): ErrorType {
  const types: Readonly<Record<string, ErrorType>> = {
    WebGLUnavailableError: "webgl-unavailable",
    ShaderError: "shader",
    GraphicsError: "graphics",
    ContextLostError: "context-lost",
  };
  return types[name] ?? "asset";
}

/** The error of a frame: as the GPU's own modules threw it, or anything else in a sentence. */
export function frameError(cause: unknown): Error {
  if (cause instanceof Error && typeOf(cause) !== "asset") return cause;
  return new GraphicsError("The picture cannot be drawn.", { cause });
}

export function emit<Type extends keyof CandleFlameEventMap>(
  element: EventTarget,
  type: Type,
  detail: CandleFlameEventMap[Type]["detail"],
): void {
  element.dispatchEvent(new CustomEvent(type, { detail }));
}

/** Listeners of the element's events, which TypeScript knows by the events' names. */
export interface TypedListeners {
  addEventListener<Type extends keyof EventMap>(
    type: Type,
    listener: (this: this, event: EventMap[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof EventMap>(
    type: Type,
    listener: (this: this, event: EventMap[Type]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}
