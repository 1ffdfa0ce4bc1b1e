import { defineConfig } from "playwright/test";
import { browser, servers } from "./tests/support/browser.ts";

export default defineConfig({
  testDir: "tests/visual",
  outputDir: "test-results/visual",
  fullyParallel: false,
  // SwiftShader uses every core by itself, but pages that load, parse and simulate leave one idle.
  workers: 2,
  forbidOnly: Boolean(process.env.CI),
  reporter: "list",
  snapshotPathTemplate: "{testDir}/goldens/{arg}{ext}",
  // What hangs, not what a busy machine takes: no test waits for the clock.
  timeout: 400_000,
  expect: {
    timeout: 120_000,
    toHaveScreenshot: { animations: "disabled", threshold: 0.1, maxDiffPixelRatio: 0.002 },
  },
  use: browser,
  webServer: servers.all,
});
