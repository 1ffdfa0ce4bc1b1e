import type { Page } from "playwright/test";
import { contextErrors, recordContexts as record } from "../engines/drivers/recorder.ts";

/** Keeps every WebGL2 context of the pages to come in `contexts`. */
export async function recordContexts(page: Page): Promise<void> {
  await page.addInitScript(record);
}

/** Whether each context asked for so far is lost, in order. */
export function lostContexts(page: Page): Promise<boolean[]> {
  return page.evaluate(() => contexts.map((context) => context.isContextLost()));
}

/** WebGL errors of all living contexts since the last call. */
export function graphicsErrors(page: Page): Promise<string[]> {
  return page.evaluate(contextErrors);
}
