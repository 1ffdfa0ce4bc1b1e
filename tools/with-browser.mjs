// node tools/with-browser.mjs playwright test …: runs Playwright with a browser found or installed.
import { spawnSync } from "node:child_process";
import { findBrowser } from "./find-browser.mjs";

const { path, args } = await findBrowser();
console.log(`browser: ${path}`);
const [, ...rest] = process.argv.slice(2);
const { status } = spawnSync(process.execPath, ["node_modules/playwright/cli.js", ...rest], {
  stdio: "inherit",
  env: { ...process.env, CHROMIUM_PATH: path, CHROMIUM_ARGS: args.join(" ") },
});
process.exit(status ?? 1);
