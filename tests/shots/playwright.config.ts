import { defineConfig } from "playwright/test";
import { browser, servers } from "../support/browser.ts";

export default defineConfig({
  testDir: ".",
  testMatch: "*.shots.ts",
  outputDir: "../../test-results/shots",
  workers: 1,
  reporter: "list",
  timeout: 120_000,
  use: { ...browser, viewport: { width: 1280, height: 720 } },
  webServer: [servers.page, servers.library].map((server) => ({ ...server, cwd: "../.." })),
});
