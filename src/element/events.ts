import { ReflectedAttributes } from "./reflected-attributes.js";

/** `graphics`: an allocation, a framebuffer or a frame that failed. */
export type ErrorType = "webgl-unavailable" | "asset" | "shader" | "graphics" | "context-lost";

export interface ErrorDetail {
  readonly type: ErrorType;
  readonly message: string;
  readonly cause: unknown;
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
  light: CustomEvent<null>;
  extinguish: CustomEvent<null>;
  camerachange: CustomEvent<null>;
  qualitychange: CustomEvent<null>;
  contextlost: CustomEvent<null>;
  contextrestored: CustomEvent<null>;
}

/** Those and every element's own. */
type EventMap = Omit<HTMLElementEventMap, keyof CandleFlameEventMap> & CandleFlameEventMap;

/** Which of the types an error is of, by its name: most of what fails is a file. */
export function typeOf({ name }: Error): ErrorType {
  const types: Readonly<Record<string, ErrorType>> = {
    WebGLUnavailableError: "webgl-unavailable",
    ShaderError: "shader",
    GraphicsError: "graphics",
    ContextLostError: "context-lost",
  };
  return types[name] ?? "asset";
}

/** The element's events, whose listeners TypeScript knows by their names. */
export class TypedEvents extends ReflectedAttributes {
  override addEventListener<Type extends keyof EventMap>(
    type: Type,
    listener: (this: this, event: EventMap[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: unknown,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener as EventListener, options);
  }

  override removeEventListener<Type extends keyof EventMap>(
    type: Type,
    listener: (this: this, event: EventMap[Type]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: unknown,
    options?: boolean | EventListenerOptions,
  ): void {
    super.removeEventListener(type, listener as EventListener, options);
  }
}
