import type { Page } from "playwright/test";
import { ORIGINS } from "./browser.ts";

export const SOURCES = ORIGINS.sources;

/** An empty page of the development server, for tests that import what lies behind the element. */
export async function openSources(page: Page, policy?: string): Promise<void> {
  await page.route(`${SOURCES}empty.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      headers: policy === undefined ? {} : { "content-security-policy": policy },
      body: "<!doctype html><title>test</title>",
    }),
  );
  await page.goto(`${SOURCES}empty.html`);
}
