import { chromium } from "playwright";
import { preview } from "vite";
import { findBrowser } from "./find-browser.mjs";

/** What is built, served at a port that is free. */
export async function serveBuilt(outDir = "dist-page", options = {}) {
  const server = await preview({
    configFile: false,
    logLevel: "error",
    build: { outDir },
    preview: { host: "127.0.0.1", port: 0 },
    ...options,
  });
  const url = `http://127.0.0.1:${server.httpServer.address().port}/`;
  return { url, close: () => server.close() };
}

/** Chromium on SwiftShader: the same pixels and the same work on every machine. */
export async function launchSoftwareBrowser() {
  const { path, args } = await findBrowser();
  const swiftShader = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
  return chromium.launch({
    executablePath: path,
    args: [...args, ...swiftShader, "--ignore-gpu-blocklist"],
  });
}
