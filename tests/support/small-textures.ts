import type { BrowserContext, Page } from "playwright/test";
import sharp from "sharp";

/** Serves every texture as a grey one of 4 x 4 texels, for tests that load a room many times. */
export async function serveSmallTextures(page: Page | BrowserContext): Promise<void> {
  const size = { width: 4, height: 4, channels: 3, background: "#808080" } as const;
  const body = await sharp({ create: size }).jpeg().toBuffer();
  await page.route(/\.(avif|jpg)$/, (route) => route.fulfill({ contentType: "image/jpeg", body }));
}
