declare global {
  /** What a recorded page said on the console, exceptions, rejections, and what could not be loaded. */
  var complaints: string[];
  /** All WebGL2 contexts that a recorded page has asked for, in order. */
  var contexts: WebGL2RenderingContext[];
}

/** Keeps a page's contexts; runs in it before all else. */
export function recordContexts(): void {
  globalThis.contexts = [];
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (
    this: HTMLCanvasElement,
    ...request: [string, unknown?]
  ) {
    const context: unknown = Reflect.apply(getContext, this, request);
    if (context instanceof WebGL2RenderingContext && !contexts.includes(context)) {
      contexts.push(context);
    }
    return context;
  } as typeof getContext;
}

/** WebGL errors of all living contexts since the last call; runs in a recorded page. */
export function contextErrors(): string[] {
  return contexts
    .filter((context) => !context.isContextLost())
    .map((context) => context.getError())
    .filter((error) => error !== WebGL2RenderingContext.NO_ERROR)
    .map((error) => `0x${error.toString(16)}`);
}

/** Keeps a page's complaints: some engines tell their drivers nothing of the console. */
function recordComplaints(): void {
  globalThis.complaints = [];
  for (const level of ["debug", "log", "info", "warn", "error"] as const) {
    const own = console[level];
    console[level] = (...words: unknown[]) => {
      complaints.push(`${level}: ${words.map(String).join(" ")}`);
      own.apply(console, words);
    };
  }
  addEventListener(
    "error",
    ({ target, message }: ErrorEvent) => {
      const { src, href } = target as { src?: string; href?: string };
      complaints.push(target === window ? `error: ${message}` : `not loaded: ${src ?? href}`);
    },
    true,
  );
  addEventListener("unhandledrejection", ({ reason }) => {
    complaints.push(`unhandled: ${reason}`);
  });
}

/** The script's text, for a page's head. */
export const RECORDER = `(${recordContexts})();(${recordComplaints})();`;
