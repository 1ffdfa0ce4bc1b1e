import type { Page } from "playwright/test";

/** One sample a pixel, for tests that look at no edges: with several SwiftShader shades what depth hides, too. */
export async function drawOneSample(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const { renderbufferStorageMultisample } = prototype;
    prototype.renderbufferStorageMultisample = function (target, _, ...storage) {
      renderbufferStorageMultisample.call(this, target, 0, ...storage);
    };
  });
}
