// A poster: the picture that the element draws, as a file.
import { existsSync, readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, extname, isAbsolute, join, posix, relative, resolve, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { BROWSERS } from "./browsers.mjs";
import { openBrowser } from "./devtools.mjs";

/** A failure, in a sentence for the user. */
export class Refusal extends Error {}

const DIST = fileURLToPath(new URL("../dist/", import.meta.url));
const TYPES = {
  ".avif": "image/png",
  ".png": "image/png",
  ".jpg": "image/jpeg",
  ".webp": "image/webp",
};
const MIME = {
  ".js": "text/javascript",
  ".html": "text/html",
  ".json": "application/json",
  ".wasm": "application/wasm",
};
/** Longest side that is drawn on the CPU, and most pixels: a larger picture would be enlarged. */
const LARGEST = 8192;
const MOST_PIXELS = 4096 ** 2;
/** Longest that a picture may take: a CPU draws a large one in a minute or two. Milliseconds. */
const PATIENCE = 900_000;
/** Longest that a page may take to define the element and to insert it, milliseconds. */
const ARRIVAL = 30_000;
/** Longest that it may then keep it hidden, milliseconds. */
const APPEARANCE = 5_000;

/** Packages of the calling project: this package depends on nothing. */
async function own(name) {
  try {
    const path = createRequire(join(process.cwd(), "package.json")).resolve(name);
    const module = await import(pathToFileURL(path).href);
    return module.default ?? module;
  } catch {
    return null;
  }
}

async function findBrowser(asked) {
  if (asked && !existsSync(asked)) throw new Refusal(`There is no browser at ${asked}.`);
  const path = asked || process.env.CHROMIUM_PATH || BROWSERS.find(existsSync);
  if (path) return path;
  for (const name of ["playwright", "playwright-core", "puppeteer"]) {
    const found = await own(name);
    const installed = (found?.chromium ?? found)?.executablePath?.();
    if (installed && existsSync(installed)) return installed;
  }
  throw new Refusal(
    "No Chromium, Chrome or Edge was found. Name one: --browser path, or the variable CHROMIUM_PATH.",
  );
}

function readSize(text) {
  const [, width, height] = /^(\d{1,5})x(\d{1,5})$/.exec(text) ?? [];
  if (!(width > 0 && height > 0))
    throw new Refusal(`--size is like 1600x900, not ${text || "empty"}.`);
  if (Math.max(width, height) > LARGEST || width * height > MOST_PIXELS)
    throw new Refusal(`--size is at most ${LARGEST} a side and 16.7 megapixels, not ${text}.`);
  return { width: Number(width), height: Number(height) };
}

function readCamera(name, text) {
  if (text === undefined) return null;
  const numbers = text
    .trim()
    .split(/[\s,_]+/)
    .map(Number);
  const isLegal = numbers.length === 5 || (name === "camera" && numbers.length === 6);
  if (!isLegal || !numbers.every(Number.isFinite)) {
    const further = name === "camera" ? ", or six with the field of view" : "";
    throw new Refusal(
      `--${name} is five numbers, x y z yaw pitch${further}, not ${text || "none"}.`,
    );
  }
  const [x, y, z, yaw, pitch, fieldOfView] = numbers;
  return { position: [x, y, z], yaw, pitch, fieldOfView };
}

function readNumber(name, text, least, most) {
  const value = Number(text);
  if (!(value >= least && value <= most) || text === "") {
    throw new Refusal(`--${name} is a number from ${least} to ${most}, not ${text || "none"}.`);
  }
  return value;
}

/** The attributes that there are, by the manifest that the package ships. */
function checkAttributes(attributes) {
  if (Object.keys(attributes).length === 0) return;
  const manifest = join(DIST, "custom-elements.json");
  if (!existsSync(manifest))
    throw new Refusal(`The package is not built: there is no ${manifest}.`);
  const { modules } = JSON.parse(readFileSync(manifest, "utf8"));
  const known = modules.flatMap(({ declarations = [] }) =>
    declarations.flatMap((declaration) => (declaration.attributes ?? []).map(({ name }) => name)),
  );
  const unknown = Object.keys(attributes).filter((name) => !known.includes(name));
  if (unknown.length > 0) {
    throw new Refusal(`There is no option or attribute ${unknown.join(", ")}. See --help.`);
  }
}

/** The working folder, or that of a model which lies elsewhere. */
function folderOf(model) {
  const way = relative(process.cwd(), model ?? process.cwd());
  return way.startsWith("..") || isAbsolute(way) ? dirname(model) : process.cwd();
}

/** The package at `/`, a folder at `/here/`, and a page with one element. */
async function servePackage(folder) {
  const server = createServer(async ({ url }, response) => {
    try {
      // Of an address on any system: `normalize` of Windows has backslashes.
      const path = posix.normalize(decodeURIComponent(new URL(url, "http://localhost").pathname));
      const file = path.startsWith("/here/") ? join(folder, path.slice(5)) : join(DIST, path);
      const body =
        path === "/poster.html"
          ? `<!doctype html><meta charset="utf-8"><title>poster</title><style>body { margin: 0 }</style>
             <candle-flame paused></candle-flame><script type="module" src="/define.js"></script>`
          : await readFile(file);
      response.setHeader("content-type", MIME[extname(path)] ?? "application/octet-stream");
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { server, address: `http://127.0.0.1:${server.address().port}/` };
}

/** Runs in the page. It draws once, in the frame in which the room is there. */
async function draw(wanted) {
  const { selector, arrival, appearance, attributes, camera, candle, seconds } = wanted;
  const { type, compression } = wanted;
  const until = async (find, patience, reason) => {
    const latest = performance.now() + patience;
    for (let found = find(); ; found = find()) {
      if (found) return found;
      if (performance.now() > latest) throw new Error(reason());
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  };
  const find = () => {
    const found = document.querySelector(selector);
    const Element = customElements.get("candle-flame");
    return Element && found instanceof Element ? found : null;
  };
  // Frameworks insert it after the page has loaded.
  const element = await until(find, arrival, () =>
    customElements.get("candle-flame")
      ? `The page has no <candle-flame> that is ${selector}.`
      : "The page does not define <candle-flame>.",
  );
  element.pause();
  // Whatever box the page gives it, or none, as it does to a closed popover.
  const box = {
    display: "block",
    "content-visibility": "visible",
    position: "fixed",
    inset: "0",
    width: "100vw",
    height: "100vh",
    "min-width": "0",
    "min-height": "0",
    "max-width": "none",
    "max-height": "none",
    "aspect-ratio": "auto",
    margin: "0",
    border: "0",
    padding: "0",
    zoom: "1",
    transition: "none",
  };
  for (const [name, value] of Object.entries(box))
    element.style.setProperty(name, value, "important");
  await until(
    () => element.checkVisibility(),
    appearance,
    () => `The page hides the <candle-flame> that is ${selector}, by an element around it.`,
  );
  const sceneOf = ({ scene, look, src, assetBase }) =>
    `${[scene, look === "physical", src, assetBase]}`;
  const before = sceneOf(element);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  if (sceneOf(element) !== before) {
    // Out and in again, or the scene before would be there until this one is.
    const place = document.createComment("");
    element.replaceWith(place);
    await new Promise((resolve) => setTimeout(resolve));
    place.replaceWith(element);
  }
  const stand = () => {
    const view = camera ?? element.camera;
    if (candle) {
      if (!element.held && element.flame) {
        element.camera = { position: element.flame.position }; // within reach
        element.take();
      }
      element.camera = candle;
      element.place();
    }
    if (candle || camera) element.camera = view;
  };
  const isLate = element.flame !== null || (candle && !camera);
  if (!isLate) stand();
  const taken = new Promise((resolve, reject) => {
    const take = () => {
      if (isLate) stand();
      if (seconds > 0) element.step(seconds);
      if (candle && element.held) reject(new Error("The candle cannot be put down from there."));
      element.toBlob(type, compression).then(resolve, reject);
    };
    element.addEventListener("error", ({ detail }) => reject(new Error(detail.message)));
    element.ready.catch(reject); // it may have failed before
    if (element.flame) take();
    else element.addEventListener("load", take, { once: true });
  });
  let blob = await taken;
  if (element.stats.width !== innerWidth || element.stats.height !== innerHeight) {
    // Low draws coarser than it is shown, ultra finer.
    const size = { resizeWidth: innerWidth, resizeHeight: innerHeight, resizeQuality: "high" };
    const picture = await createImageBitmap(blob, size);
    const canvas = new OffscreenCanvas(innerWidth, innerHeight);
    canvas.getContext("2d").drawImage(picture, 0, 0);
    blob = await canvas.convertToBlob({ type, quality: compression });
  }
  const reader = new FileReader();
  await new Promise((resolve) => {
    reader.onload = resolve;
    reader.readAsDataURL(blob);
  });
  return reader.result.slice(reader.result.indexOf(",") + 1);
}

/**
 * The picture as the bytes of a file.
 *
 * @param options those of `npx candle-flame poster`, as text, and `attributes` of the element
 */
export async function makePoster(options) {
  const { out, url, attributes = {}, selector = "candle-flame" } = options;
  const extension = extname(out).toLowerCase().replace(".jpeg", ".jpg");
  const type = TYPES[extension];
  if (!type) throw new Refusal(`A poster is .avif, .webp, .jpg or .png, not ${out}.`);
  const { width, height } = readSize(options.size ?? "1600x900");
  const wanted = {
    selector,
    arrival: ARRIVAL,
    appearance: APPEARANCE,
    camera: readCamera("camera", options.camera),
    candle: readCamera("candle", options.candle),
    seconds: readNumber("seconds", options.seconds ?? "0", 0, 60),
    compression: readNumber("compression", options.compression ?? "0.8", 0, 1),
    type,
    attributes: { quality: "high", "max-pixel-ratio": "1", ...attributes },
  };
  checkAttributes(attributes);
  if (url !== undefined && !URL.canParse(url))
    throw new Refusal(`--url is an address, not ${url}.`);
  const sharp = extension === ".avif" ? await own("sharp") : null;
  if (extension === ".avif" && !sharp) {
    throw new Refusal(
      "An .avif needs the package sharp: npm install sharp. A .webp needs nothing.",
    );
  }
  const path = await findBrowser(options.browser);
  const { src } = attributes;
  const model = src && existsSync(src) ? resolve(src) : null;
  const folder = folderOf(model);
  const site = url === undefined ? await servePackage(folder) : null;
  if (site && model) {
    const steps = relative(folder, model).split(sep).map(encodeURIComponent);
    wanted.attributes.src = `/here/${steps.join("/")}`;
  }
  let browser = null;
  try {
    browser = await openBrowser(path, PATIENCE);
    const address = url ?? `${site.address}poster.html`;
    const page = await browser.openPage(address, { width, height });
    const picture = Buffer.from(await page.evaluate(draw, wanted), "base64");
    return sharp
      ? await sharp(picture)
          .avif({ quality: Math.max(1, Math.round(wanted.compression * 60)) })
          .toBuffer()
      : picture;
  } catch (error) {
    throw new Refusal(error.message);
  } finally {
    await browser?.close();
    site?.server.close();
  }
}
