import { defineConfig } from "playwright/test";
import { browser, servers } from "../support/browser.ts";

// No retries and no second worker: both would disturb the numbers.
export default defineConfig({
  testDir: ".",
  testMatch: "*.bench.ts",
  outputDir: "../../test-results/bench",
  fullyParallel: false,
  workers: 1,
  forbidOnly: Boolean(process.env.CI),
  reporter: [["list"], ["./report.ts"]],
  timeout: 180_000,
  use: { ...browser, viewport: { width: 800, height: 600 } },
  webServer: { ...servers.bench, cwd: "../.." },
});
