/** What a page keeps of itself, as globals. */
export interface Recorded {
  /** What it said on the console, exceptions, rejections, and what could not be loaded. */
  readonly complaints: string[];
  /** All WebGL2 contexts, in order. */
  readonly contexts: WebGL2RenderingContext[];
}

/**
 * Records a page; runs in it before all else. Some engines tell their drivers nothing of the console.
 */
function record(): void {
  const { complaints, contexts } = Object.assign(globalThis, {
    complaints: [] as string[],
    contexts: [] as WebGL2RenderingContext[],
  });
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

/** The script's text, for a page's head. */
export const RECORDER = `(${record})();`;
