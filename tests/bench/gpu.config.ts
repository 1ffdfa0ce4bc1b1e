import { defineConfig } from "playwright/test";
import { onOwnGpu, servers } from "../support/browser.ts";

/** npm run bench:gpu. */
export default defineConfig({
  testDir: ".",
  testMatch: "gpu-frames.ts",
  outputDir: "../../test-results/bench",
  workers: 1,
  reporter: [["list"], ["./report.ts"]],
  timeout: 180_000,
  use: { ...onOwnGpu, viewport: { width: 1920, height: 1080 } },
  webServer: { ...servers.bench, cwd: "../.." },
});
