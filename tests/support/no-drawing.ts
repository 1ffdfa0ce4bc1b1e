import type { Page } from "playwright/test";

/** In the page: from now on nothing is drawn, for tests that look at no pixel. */
export function stopDrawing(): void {
  Object.assign(WebGL2RenderingContext.prototype, { drawArrays() {}, drawElements() {} });
}

/** The same from the beginning. Elements name their tier: `auto` would measure a GPU that takes no time. */
export async function drawNothing(page: Page): Promise<void> {
  await page.addInitScript(stopDrawing);
}
