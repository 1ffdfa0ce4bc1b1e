import { execFileSync, spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { chromium } from "playwright";
import { BROWSERS } from "../bin/browsers.mjs";

const run = (command, ...args) =>
  spawnSync(command, args, {
    stdio: "inherit",
    timeout: 600_000,
    shell: process.platform === "win32",
  }).status === 0;

function answers(path) {
  try {
    execFileSync(path, ["--version"], { timeout: 20_000, stdio: "pipe" });
    return true;
  } catch {
    return false;
  }
}

const ofPlaywright = () => [chromium.executablePath()].find(existsSync);
const ofSystem = () => BROWSERS.find((path) => existsSync(path) && answers(path));

const isRoot = process.getuid?.() === 0;
const hasApt = existsSync("/usr/bin/apt-get");

function installed() {
  const dependencies = isRoot && hasApt ? ["--with-deps"] : [];
  if (run("npx", "playwright", "install", ...dependencies, "chromium")) return ofPlaywright();
  if (!isRoot || !hasApt) return undefined;
  run("apt-get", "update", "-qq");
  return run("apt-get", "install", "-y", "-qq", "--no-install-recommends", "chromium")
    ? ofSystem()
    : undefined;
}

/** A Chromium that ships inside an npm package: for Linux without root. */
async function unpacked() {
  if (process.platform !== "linux" || process.arch !== "x64") return undefined;
  const npm = ["install", "--no-save", "--no-audit", "--no-fund", "@sparticuz/chromium@143.0.4"];
  if (!run("npm", ...npm)) return undefined;
  const { default: sparticuz } = await import("@sparticuz/chromium");
  return sparticuz.executablePath();
}

/**
 * Finds a Chromium, or installs one: the one named by CHROMIUM_PATH, Playwright's own, the system's,
 * then whatever can be installed.
 */
export async function findBrowser() {
  const path = process.env.CHROMIUM_PATH || ofPlaywright() || ofSystem() || installed();
  if (path) return { path, args: [] };
  const last = await unpacked();
  if (!last) throw new Error("No Chromium found. Install one, or set CHROMIUM_PATH to its path.");
  // Its own default, one process for all, kills the browser with the first page that closes.
  return { path: last, args: ["--no-sandbox", "--ignore-gpu-blocklist"] };
}
