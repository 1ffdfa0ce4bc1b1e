// npm run test:soak: what an element holds after half an hour of flame, a hundred mounts, a hundred sizes and
// twenty lost contexts, beside what it held at first. Needs `npm run build`. Some minutes on SwiftShader.
import { launchSoftwareBrowser, serveBuilt } from "../../tools/built-site.mjs";

const HALF_AN_HOUR = 1800;
/** Growth that is noise of the collector's, bytes. */
const SLACK = 1.5e6;

const [chosen = ""] = process.argv.slice(2);
const SCENES = ['look="paper"', 'scene="candle"', 'look="physical"'].filter((scene) =>
  scene.includes(chosen),
);
if (SCENES.length === 0) throw new Error(`There is no ${chosen} to soak.`);

const server = await serveBuilt("dist");
const browser = await launchSoftwareBrowser();

const TRIALS = {
  "30 minutes of flame": async (element, seconds) => {
    for (let i = 0; i < seconds; i += 2) {
      element.step(2);
      if (i % 60 === 0) await new Promise((resolve) => setTimeout(resolve));
    }
  },
  "100 mounts": async (element) => {
    for (let i = 0; i < 100; i++) {
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
      document.body.append(element);
      await element.ready;
    }
  },
  "100 sizes": async (element) => {
    for (let i = 1; i <= 100; i++) {
      element.style.width = `${32 + (i % 7) * 9}px`;
      element.style.height = `${18 + (i % 5) * 11}px`;
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    }
    element.style.width = "32px";
    element.style.height = "18px";
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
  },
  "20 lost contexts": async (element) => {
    const next = (type) =>
      new Promise((resolve) => element.addEventListener(type, resolve, { once: true }));
    for (let i = 0; i < 20; i++) {
      const context = globalThis.contexts.findLast((context) => !context.isContextLost());
      const extension = context.getExtension("WEBGL_lose_context");
      const lost = next("contextlost");
      extension.loseContext();
      await lost;
      await new Promise((resolve) => setTimeout(resolve));
      const restored = next("contextrestored");
      extension.restoreContext();
      await restored;
    }
  },
};

async function soak(attributes) {
  const page = await browser.newPage({ viewport: { width: 320, height: 180 } });
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  await page.addInitScript(() => {
    globalThis.contexts = [];
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (...request) {
      const context = Reflect.apply(getContext, this, request);
      if (request[0] === "webgl2" && context && !contexts.includes(context)) {
        // As soon as it is lost it is nobody's: the list must not keep it.
        globalThis.contexts = contexts.filter((known) => !known.isContextLost());
        contexts.push(context);
      }
      return context;
    };
  });
  await page.route("**/soak.html", (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><title>soak</title><candle-flame paused quality="low" ${attributes} style="width: 32px; height: 18px; aspect-ratio: auto"></candle-flame><script type="module" src="/define.js"></script>`,
    }),
  );
  await page.goto(`${server.url}soak.html`);
  const element = page.locator("candle-flame");
  await element.evaluate(async (element) => {
    await customElements.whenDefined("candle-flame");
    await element.ready;
  });
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  const measure = async () => {
    await element.evaluate((element) => element.step(0));
    // What a canvas held is free some tasks after its canvas.
    for (let i = 0; i < 20; i++) {
      await client.send("HeapProfiler.collectGarbage");
      await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 100)));
    }
    const { metrics } = await client.send("Performance.getMetrics");
    const metric = (name) => metrics.find((one) => one.name === name).value;
    const { gpuObjects, gpuBytes } = await element.evaluate(({ stats }) => stats);
    return {
      gpuObjects,
      gpuBytes,
      listeners: metric("JSEventListeners"),
      nodes: metric("Nodes"),
      heap: metric("JSHeapUsedSize"),
    };
  };
  // Once of each first: code is compiled, and caches are filled.
  for (const [name, trial] of Object.entries(TRIALS)) {
    if (name !== "100 mounts") await element.evaluate(trial, 20);
  }
  const first = await measure();
  const rows = { "at first": first };
  let isFlat = true;
  for (const [name, trial] of Object.entries(TRIALS)) {
    const begin = Date.now();
    await element.evaluate(trial, HALF_AN_HOUR);
    const after = await measure();
    rows[name] = { ...after, seconds: Math.round((Date.now() - begin) / 1000) };
    console.log(name, JSON.stringify(after));
    const isSame = ["gpuObjects", "gpuBytes", "listeners"].every(
      (key) => after[key] === first[key],
    );
    if (!isSame || after.nodes > first.nodes + 10 || after.heap > first.heap + SLACK)
      isFlat = false;
  }
  console.log(`\n<candle-flame ${attributes}>: ${isFlat ? "flat" : "GROWS"}`);
  console.table(rows);
  for (const complaint of complaints) console.log(complaint);
  await page.close();
  return isFlat && complaints.length === 0;
}

const results = [];
for (const attributes of SCENES) results.push(await soak(attributes));
await browser.close();
await server.close();
process.exit(results.every(Boolean) ? 0 : 1);
