// npm run reference [names…]: the views as Blender Cycles sees them, into tests/fixtures/reference/.
// Needs `npm run build`, and Python with tools/models/requirements.txt (PYTHON names it).
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright";
import { createServer, preview } from "vite";
import { findBrowser } from "../find-browser.mjs";

/** The ring handle's turn against the visitor, and the wick above the foot: as the renderer has them. */
const HANDLE_TURN = -1.1;
const WICK = [0.0011, 0.2, 0.0003];
/** Vertical, degrees. */
const FIELD_OF_VIEW = 56;

const fixtures = new URL("../../tests/fixtures/reference/", import.meta.url);
const { width, height, views } = JSON.parse(readFileSync(new URL("views.json", import.meta.url)));
const names = process.argv.slice(2);
const wanted = names.length > 0 ? views.filter(({ name }) => names.includes(name)) : views;

/** The flame's extent and colour, from the sources. */
async function readFlame() {
  const vite = await createServer({ server: { middlewareMode: true }, logLevel: "error" });
  const { flameLight, TAPER } = await vite.ssrLoadModule("/src/light/flame-light.ts");
  await vite.close();
  const light = flameLight({ shown: { flame: [0, 0, 0] } }, TAPER);
  return { ...light, height: TAPER.height, reach: TAPER.radius };
}

/** Where camera, flame and candle are in each view: the element itself says so. */
async function stage(flame) {
  const server = await preview({
    build: { outDir: "dist" },
    preview: { port: 0, host: "127.0.0.1" },
    logLevel: "error",
  });
  const base = `http://127.0.0.1:${server.httpServer.address().port}/`;
  const { path, args } = await findBrowser();
  const browser = await chromium.launch({
    executablePath: path,
    args: [...args, "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const page = await browser.newPage({ viewport: { width, height } });
  await page.route(`${base}reference.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><style>body { margin: 0 } candle-flame { width: ${width}px; height: ${height}px }</style>
        <candle-flame look="physical" quality="low" paused></candle-flame>
        <script type="module" src="/define.js"></script>`,
    }),
  );
  await page.goto(`${base}reference.html`);
  await page.locator("candle-flame").evaluate((element) => element.ready);
  const staged = [];
  for (const view of wanted) {
    const seen = await page.locator("candle-flame").evaluate((element, { place, camera }) => {
      element.reset();
      if (place) {
        element.camera = place;
        element.place();
      }
      if (camera) element.camera = camera;
      element.step(0);
      return { camera: element.camera, position: element.flame.position, held: element.held };
    }, view);
    if (seen.held !== !view.place) throw new Error(`${view.name}: the candle would not stand there.`);
    const turn = (view.place ?? seen.camera).yaw + HANDLE_TURN;
    const foot = seen.position.map((x, axis) => x - WICK[axis] - flame.position[axis]);
    staged.push({
      ...view,
      camera: seen.camera,
      flame: { position: seen.position },
      candle: { foot, turn },
    });
  }
  await browser.close();
  await server.close();
  return staged;
}

const flame = await readFlame();
const { position, halfHeight, radius, intensity, height: flameHeight, reach } = flame;
const lamp = { halfHeight, radius, intensity, base: -position[1], height: flameHeight, reach };
const staged = await stage(flame);
const folder = process.env.REFERENCE_OUT ?? mkdtempSync(join(tmpdir(), "reference-"));
mkdirSync(fixtures, { recursive: true });
for (const view of staged) {
  const file = join(folder, `${view.name}.json`);
  const scene = { ...view, width, height, fieldOfView: FIELD_OF_VIEW, lamp };
  writeFileSync(file, `${JSON.stringify(scene, null, 2)}\n`);
  const python = process.env.PYTHON ?? "python3";
  const trace = new URL("trace.py", import.meta.url).pathname;
  const { status } = spawnSync(python, [trace, file, new URL(".", fixtures).pathname], {
    stdio: ["ignore", "inherit", "inherit"],
  });
  if (status !== 0) throw new Error(`${view.name} could not be traced.`);
}
