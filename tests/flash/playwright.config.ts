import { defineConfig } from "playwright/test";
import { browser, servers } from "../support/browser.ts";

/** The screen that WCAG's 10-degree field is measured on. */
export const SCREEN = { width: 1024, height: 768 } as const;

export default defineConfig({
  testDir: ".",
  testMatch: "*.flash.ts",
  outputDir: "../../test-results/flash",
  fullyParallel: true,
  workers: 2,
  forbidOnly: Boolean(process.env.CI),
  reporter: "list",
  timeout: 1_800_000,
  use: { ...browser, viewport: SCREEN },
  webServer: [{ ...servers.library, cwd: "../.." }],
});
