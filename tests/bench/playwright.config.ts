import { defineConfig } from "playwright/test";
import { browser } from "../support/browser.ts";

export const BENCH_PAGE = "http://127.0.0.1:4377/";

const vite = "node node_modules/vite/bin/vite.js";
const config = "--config tests/bench/vite.config.ts";

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
  webServer: {
    command: `${vite} build ${config} && ${vite} preview ${config}`,
    cwd: "../..",
    url: BENCH_PAGE,
    reuseExistingServer: false,
  },
});
