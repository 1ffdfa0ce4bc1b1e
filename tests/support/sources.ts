import type { Page } from "playwright/test";

export const SOURCES = "http://127.0.0.1:4175/";

/** An empty page of the development server, for tests that import what lies behind the element. */
export async function openSources(page: Page): Promise<void> {
  await page.route(`${SOURCES}empty.html`, (route) =>
    route.fulfill({ contentType: "text/html", body: "<!doctype html><title>test</title>" }),
  );
  await page.goto(`${SOURCES}empty.html`);
}
