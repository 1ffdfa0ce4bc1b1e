import type { Page } from "playwright/test";

declare global {
  /** WebGL2 contexts that the page has asked for, in order; see `recordContexts`. */
  var contexts: WebGL2RenderingContext[];
}

/** Keeps every WebGL2 context of the pages to come in `contexts`. */
export async function recordContexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
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
  });
}

/** Whether each context asked for so far is lost, in order. */
export function lostContexts(page: Page): Promise<boolean[]> {
  return page.evaluate(() => contexts.map((context) => context.isContextLost()));
}

/** WebGL errors of all living contexts since the last call. */
export function graphicsErrors(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    contexts
      .filter((context) => !context.isContextLost())
      .map((context) => context.getError())
      .filter((error) => error !== WebGL2RenderingContext.NO_ERROR)
      .map((error) => `0x${error.toString(16)}`),
  );
}
