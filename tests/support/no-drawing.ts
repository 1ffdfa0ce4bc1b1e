import type { Page } from "playwright/test";

/** Draws nothing, for tests that look at no pixel and name their tier: `auto` would measure a GPU that takes no time. */
export async function drawNothing(page: Page): Promise<void> {
  await page.addInitScript(() => {
    Object.assign(WebGL2RenderingContext.prototype, { drawArrays() {}, drawElements() {} });
  });
}
