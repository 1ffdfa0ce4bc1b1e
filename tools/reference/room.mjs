import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { createServer } from "vite";
import { launchSoftwareBrowser, serveBuilt } from "../built-site.mjs";
import { ROOMS, roomModel } from "./rooms.mjs";

/** Of other views than ours: a folder that has its own views.json, and takes what is traced. */
const others = process.env.REFERENCES && pathToFileURL(`${process.env.REFERENCES}/`);
export const FIXTURES = others || new URL("../../tests/fixtures/reference/", import.meta.url);
export const { width, height, views } = JSON.parse(
  readFileSync(new URL("views.json", others || import.meta.url)),
);

/** Runs `use` for the views of each room, in an element that shows it. */
export async function inEachRoom(quality, wanted, use) {
  const results = [];
  for (const room of new Set(wanted.map(({ room }) => room))) {
    const there = wanted.filter((view) => view.room === room);
    results.push(...(await withElement(quality, room, (evaluate) => use(there, evaluate))));
  }
  return results;
}

/** Something of the sources: they are in TypeScript. */
export async function readSource(path) {
  const vite = await createServer({
    server: { middlewareMode: true, ws: false },
    logLevel: "error",
  });
  const module = await vite.ssrLoadModule(path);
  await vite.close();
  return module;
}

/** The element of the built package in a room, or in the cabin, for `use`, which is given what runs a function on it. */
export async function withElement(quality, room, use) {
  const server = await serveBuilt("dist");
  const browser = await launchSoftwareBrowser();
  try {
    const page = await browser.newPage({ viewport: { width, height } });
    const src = room ? `src="/${room}.glb"` : "";
    await page.route(`${server.url}${room}.glb`, (route) =>
      route.fulfill({ contentType: "model/gltf-binary", body: roomModel(ROOMS[room]) }),
    );
    await page.route(`${server.url}reference.html`, (route) =>
      route.fulfill({
        contentType: "text/html",
        body: `<!doctype html><style>body { margin: 0 } candle-flame { width: ${width}px; height: ${height}px }</style>
          <candle-flame look="physical" quality="${quality}" wind="0" ${src} paused></candle-flame>
          <script type="module" src="/define.js"></script>`,
      }),
    );
    await page.goto(`${server.url}reference.html`);
    const element = page.locator("candle-flame");
    await element.evaluate((element) => element.ready);
    return await use((run, argument) => element.evaluate(run, argument));
  } finally {
    await browser.close();
    await server.close();
  }
}
