import type { Page } from "playwright/test";
import sharp from "sharp";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { lostContexts, recordContexts } from "../support/contexts.ts";
import { decode } from "../support/flash.ts";
import { flip } from "../support/flip.ts";
import { drawNothing } from "../support/no-drawing.ts";
import { complaintsOf, LIBRARY } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

// Dear, and each for itself: whichever worker is free takes the next.
test.describe.configure({ mode: "parallel" });

/** A page of the built package; what it fetched is noted. */
async function open(
  page: Page,
  body: string,
): Promise<{ complaints: readonly string[]; fetched: string[] }> {
  const complaints = complaintsOf(page);
  const fetched: string[] = [];
  page.on("request", (request) => fetched.push(new URL(request.url()).pathname));
  await recordContexts(page);
  await page.route(`${LIBRARY}candles.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><meta charset="utf-8"><title>candles</title>
        <style>body { margin: 0 } candle-flame { aspect-ratio: auto }</style>${body}
        <script type="module" src="/define.js"></script>`,
    }),
  );
  await page.goto(`${LIBRARY}candles.html`);
  await page.waitForFunction(() => customElements.get("candle-flame") !== undefined);
  return { complaints, fetched };
}

test("A lone candle is uncropped in a box of any shape, on a transparent background", async ({
  page,
}) => {
  const { complaints, fetched } = await open(
    page,
    `<candle-flame scene="candle" paused quality="medium"></candle-flame>`,
  );
  for (const [width, height] of [
    [60, 240],
    [120, 120],
    [240, 60],
  ] as const) {
    const found = await page.locator("candle-flame").evaluate(
      async (element: CandleFlameElement, [width, height]) => {
        element.style.cssText = `width: ${width}px; height: ${height}px`;
        await element.ready;
        await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
        element.features.bloom = false; // its halo fades to nothing, and is no candle
        const canvas = element.shadowRoot?.querySelector("canvas");
        element.step(0);
        const paper = canvas?.getContext("2d");
        const { data } = paper?.getImageData(0, 0, width, height) ?? { data: [] };
        const seen = { left: width, right: 0, top: height, bottom: 0, solid: 0 };
        for (let y = 0; y < height; y++) {
          for (let x = 0; x < width; x++) {
            const alpha = data[(y * width + x) * 4 + 3] ?? 0;
            if (alpha === 255) seen.solid++;
            if (alpha < 8) continue;
            seen.left = Math.min(seen.left, x);
            seen.right = Math.max(seen.right, x);
            seen.top = Math.min(seen.top, y);
            seen.bottom = Math.max(seen.bottom, y);
          }
        }
        return seen;
      },
      [width, height] as [number, number],
    );
    const name = `${width} x ${height}`;
    expect(found.left, name).toBeGreaterThan(0.02 * width);
    expect(found.right, name).toBeLessThan(0.98 * width);
    expect(found.top, name).toBeGreaterThan(0.02 * height);
    expect(found.bottom, name).toBeLessThan(0.98 * height);
    // It fills the box one way or the other.
    const share = Math.max((found.right - found.left) / width, (found.bottom - found.top) / height);
    expect(share, name).toBeGreaterThan(0.7);
    expect(found.solid, name).toBeGreaterThan(100);
  }
  const files = fetched.filter((path) => /models|load-model|room-scene/.test(path));
  expect(files, "no room, and nothing that loads one").toEqual(["/models/chamberstick.glb"]);
  expect(complaints).toEqual([]);
});

test("Hidden and shown again at another size, it is drawn before the page is painted", async ({
  page,
}) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="low" style="width: 60px; height: 90px"></candle-flame>`,
  );
  const seen = await page.locator("candle-flame").evaluate(async (element: CandleFlameElement) => {
    await element.ready;
    element.hidden = true;
    for (let frame = 0; frame < 3; frame++) {
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    }
    const canvas = element.shadowRoot?.querySelector("canvas") as HTMLCanvasElement;
    element.hidden = false;
    element.style.width = "90px";
    // Made after the element's, so that it is called after it, and before the paint.
    await new Promise((resolve) => new ResizeObserver(resolve).observe(canvas));
    const { width, height } = canvas;
    const data = canvas.getContext("2d")?.getImageData(0, 0, width, height).data ?? [];
    return { width, height, isBlank: !data.some((value) => value > 0) };
  });
  expect(seen).toEqual({ width: 60, height: 60, isBlank: false });
  expect(complaints).toEqual([]);
});

test("The first frame of a higher quality is whole", async ({ page }) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="low" style="width: 120px; height: 180px">
      </candle-flame>`,
  );
  const [first, second] = await page
    .locator("candle-flame")
    .evaluate(async (element: CandleFlameElement) => {
      await element.ready;
      element.quality = "high";
      const frame = () => {
        element.step(0);
        return element.shadowRoot?.querySelector("canvas")?.toDataURL();
      };
      return [frame(), frame()];
    });
  expect(first).toBe(second);
  expect(complaints).toEqual([]);
});

test("At low it has a third of the triangles, and looks the same", async ({ page }) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="low" style="width: 360px; height: 480px">
      </candle-flame>`,
  );
  const drawn = (quality: "low" | "high") =>
    page.locator("candle-flame").evaluate(async (element: CandleFlameElement, quality) => {
      await element.ready;
      element.quality = quality;
      element.step(0);
      const { stats, shadowRoot } = element;
      return { ...stats, url: shadowRoot?.querySelector("canvas")?.toDataURL() ?? "" };
    }, quality);
  const [low, high] = [await drawn("low"), await drawn("high")];
  const shown = async ({ url }: { readonly url: string }) => {
    const png = Buffer.from(url.split(",")[1] ?? "", "base64");
    const { data, info } = await sharp(png)
      .flatten({ background: "#111" })
      .resize(360, 480)
      .raw()
      .toBuffer({ resolveWithObject: true });
    const linear = Float32Array.from(data, decode);
    return { width: info.width, height: info.height, linear };
  };
  const differences = flip(await shown(high), await shown(low));
  const mean = differences.reduce((sum, value) => sum + value, 0) / differences.length;
  console.log(`mean FLIP of low to high: ${mean.toFixed(4)}`);
  expect(mean).toBeLessThan(0.03);
  expect(low.triangles).toBeLessThan(high.triangles / 3);
  expect(complaints).toEqual([]);
});

test("On white its glow fades smoothly into the page, without a ring", async ({ page }) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="medium" style="width: 300px; height: 400px"></candle-flame>`,
  );
  await page.locator("candle-flame").evaluate((element: CandleFlameElement) => element.ready);
  const clip = { x: 0, y: 0, width: 300, height: 400 };
  const png = await page.screenshot({ clip });
  const { data } = await sharp(png).removeAlpha().raw().toBuffer({ resolveWithObject: true });
  /** How much darker than the page a column beside the flame is, by its mean: 4 pixels wide, 32 high. */
  const shadeAt = (left: number, channel: number) => {
    let sum = 0;
    for (let y = 50; y < 82; y++) {
      for (let x = left; x < left + 4; x++) sum += 255 - (data[(y * 300 + x) * 3 + channel] ?? 0);
    }
    return sum / 128;
  };
  for (const channel of [1, 2]) {
    const outwards = Array.from({ length: 26 }, (_, i) => shadeAt(128 - 4 * i, channel));
    expect(outwards[0], "beside the flame").toBeGreaterThan(4);
    expect(outwards.at(-1), "at the edge").toBe(0);
    const rises = outwards.slice(1).map((shade, i) => shade - (outwards[i] ?? 0));
    expect(Math.max(...rises), `of 255: ${outwards}`).toBeLessThan(0.2);
  }
  expect(complaints).toEqual([]);
});

test("The flame's outline is antialiased, and its tip tapers", async ({ page }) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="high" style="width: 300px; height: 400px"></candle-flame>`,
  );
  const widths = await page
    .locator("candle-flame")
    .evaluate(async (element: CandleFlameElement) => {
      await element.ready;
      element.features.bloom = false;
      element.features.candle = false;
      element.step(1);
      const canvas = element.shadowRoot?.querySelector("canvas");
      const { width = 0, height = 0 } = canvas ?? {};
      const { data } = canvas?.getContext("2d")?.getImageData(0, 0, width, height) ?? { data: [] };
      return Array.from({ length: height }, (_, y) => {
        let sum = 0;
        for (let x = 0; x < width; x++) sum += data[(y * width + x) * 4 + 3] ?? 0;
        return sum / 255;
      });
    });
  // In pixels, of each row from the tip to where the flame is widest.
  const upper = widths.slice(
    widths.findIndex((width) => width > 0.05),
    widths.indexOf(Math.max(...widths)),
  );
  const growth = upper.slice(1).map((width, i) => width - (upper[i] ?? 0));
  console.log(`width, pixels: ${upper.map((width) => width.toFixed(1))}`);
  expect(upper.length).toBeGreaterThan(20);
  expect(upper[0], "the tip").toBeLessThan(0.9);
  expect(Math.max(...growth), "from row to row").toBeLessThan(0.9);
  expect(Math.min(...growth), "from row to row").toBeGreaterThan(-0.2);
  expect(complaints).toEqual([]);
});

test("A flame two pixels wide covers as much of the page as a large one", async ({ page }) => {
  const sizes = [48, 192];
  await open(
    page,
    sizes
      .map(
        (size) =>
          `<candle-flame scene="candle" paused quality="high" style="width: ${size}px; height: ${size}px"></candle-flame>`,
      )
      .join(""),
  );
  const [small = 0, large = 0] = await page
    .locator("candle-flame")
    .evaluateAll(async (elements: CandleFlameElement[]) => {
      const shares: number[] = [];
      for (const element of elements) {
        await element.ready;
        element.features.bloom = false;
        element.features.candle = false;
        element.step(1);
        const canvas = element.shadowRoot?.querySelector("canvas");
        const { width = 0, height = 0 } = canvas ?? {};
        const pixels = canvas?.getContext("2d")?.getImageData(0, 0, width, height);
        let sum = 0;
        for (let i = 3; i < 4 * width * height; i += 4) sum += pixels?.data[i] ?? 0;
        shares.push(sum / (255 * width * height));
      }
      return shares;
    });
  console.log(`covered: ${small} and ${large}`);
  expect(small / large).toBeGreaterThan(0.8);
  expect(small / large).toBeLessThan(1.3);
});

test("Thin smoke has the colour of dense smoke", async ({ page }) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="low" style="width: 300px; height: 400px"></candle-flame>`,
  );
  const reds = await page.locator("candle-flame").evaluate(async (element: CandleFlameElement) => {
    await element.ready;
    element.features.candle = false;
    element.extinguish();
    element.step(1.2);
    const canvas = element.shadowRoot?.querySelector("canvas");
    const { width = 0, height = 0 } = canvas ?? {};
    const { data } = canvas?.getContext("2d")?.getImageData(0, 0, width, height) ?? { data: [] };
    const reds = { thin: [] as number[], dense: [] as number[] };
    for (let i = 0; i < data.length; i += 4) {
      const alpha = data[i + 3] ?? 0;
      if (alpha > 20 && alpha < 60) reds.thin.push(data[i] ?? 0);
      else if (alpha > 90) reds.dense.push(data[i] ?? 0);
    }
    return reds;
  });
  const [thin, dense] = [reds.thin, reds.dense].map((some) => some.sort((a, b) => a - b));
  const median = (sorted: readonly number[] = []) => sorted[sorted.length >> 1] ?? Number.NaN;
  console.log(`red of ${thin?.length} and ${dense?.length}: ${median(thin)}, ${median(dense)}`);
  expect(Math.abs(median(thin) - median(dense))).toBeLessThan(30);
  expect(complaints).toEqual([]);
});

test("Its halo goes with the exposure, as all light does", async ({ page }) => {
  await open(
    page,
    `<candle-flame scene="candle" paused quality="low" style="width: 150px; height: 200px"></candle-flame>`,
  );
  const halos = await page.locator("candle-flame").evaluate(async (element: CandleFlameElement) => {
    await element.ready;
    const opacity = async () => {
      element.step(0);
      const bitmap = await createImageBitmap(await element.toBlob());
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext("2d");
      context?.drawImage(bitmap, 0, 0);
      const pixels = context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
      return pixels.reduce((sum, value, i) => sum + (i % 4 === 3 ? value : 0), 0);
    };
    const halos: number[] = [];
    for (const exposure of [-4, 0, 1]) {
      element.exposure = exposure;
      element.features.bloom = true;
      const glowing = await opacity();
      element.features.bloom = false;
      halos.push(glowing - (await opacity()));
    }
    return halos;
  });
  const shares = halos.map((halo) => halo / (halos[1] ?? 1));
  console.log(`halo at -4, 0 and 1 EV: ${shares.map((share) => share.toFixed(2))}`);
  const [dark = 0, , bright = 0] = shares;
  expect(dark).toBeGreaterThan(0.1);
  expect(dark).toBeLessThan(0.4);
  expect(bright).toBeGreaterThan(1.1);
});

test("Over black, white or a photograph the candle is the same, and its light only adds to the page", async ({
  page,
}) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="medium" style="width: 120px; height: 160px"></candle-flame>`,
  );
  const pixels = async (background: string) => {
    await page.locator("body").evaluate((body, value) => {
      body.style.background = value;
    }, background);
    const clip = { x: 0, y: 0, width: 120, height: 160 };
    const png = await page.screenshot({ clip });
    const data = await page.evaluate(async (base64) => {
      const picture = await (await fetch(`data:image/png;base64,${base64}`)).blob();
      const bitmap = await createImageBitmap(picture);
      const paper = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
      paper?.drawImage(bitmap, 0, 0);
      return paper?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? null;
    }, png.toString("base64"));
    return [...(data ?? [])];
  };
  await page.locator("candle-flame").evaluate((element: CandleFlameElement) => element.ready);
  const [black, white] = [await pixels("#000"), await pixels("#fff")];
  let solid = 0;
  let clear = 0;
  let uneven = 0;
  for (let i = 0; i < black.length; i += 4) {
    const [onBlack, onWhite] = [black.slice(i, i + 3), white.slice(i, i + 3)];
    if (onBlack.every((value, c) => Math.abs(value - (onWhite[c] ?? 0)) <= 1)) solid++;
    if (onBlack.every((value) => value === 0) && onWhite.every((value) => value === 255)) clear++;
    // Premultiplied: what is left of the page is the same share of each channel, and never negative.
    const left = onBlack.map((value, c) => (onWhite[c] ?? 0) - value);
    if (Math.max(...left) - Math.min(...left) > 2 || Math.min(...left) < -1) uneven++;
  }
  // So it is over a photograph, too: what is left of the page, and the candle.
  const photo = "url(/textures/brass-albedo.avif)";
  await page.evaluate(
    async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
    },
    photo.slice(4, -1),
  );
  const onPhoto = await pixels(photo);
  await page.locator("candle-flame").evaluate((element) => {
    element.style.visibility = "hidden";
  });
  const bare = await pixels(photo);
  expect(Math.max(...bare) - Math.min(...bare.filter((_, i) => i % 4 === 0))).toBeGreaterThan(20);
  const errors = onPhoto.map((value, i) => {
    const share = ((white[i] ?? 0) - (black[i] ?? 0)) / 255;
    return i % 4 === 3 ? 0 : Math.abs(value - (black[i] ?? 0) - share * (bare[i] ?? 0));
  });
  expect(Math.max(...errors)).toBeLessThan(3);
  expect(solid).toBeGreaterThan(1000);
  expect(clear).toBeGreaterThan(2000);
  expect(uneven).toBe(0);
  expect(complaints).toEqual([]);
});

test("Twenty-four candles share one context, and invisible ones draw no frames", async ({
  page,
}) => {
  const one = `<candle-flame scene="candle" quality="low" style="width: 40px; height: 40px; margin-bottom: 23px"></candle-flame>`;
  await drawNothing(page);
  const { complaints, fetched } = await open(page, one.repeat(24));
  const frames = await page.evaluate(async () => {
    const elements = [...document.querySelectorAll("candle-flame")];
    await Promise.all(elements.map(({ ready }) => ready));
    const times = () => elements.map(({ currentTime }) => currentTime);
    const frames = async (count: number) => {
      for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
    };
    const isSettled = () =>
      elements.every(
        (element) =>
          element.matches(":state(playing)") === element.getBoundingClientRect().top < innerHeight,
      );
    while (!isSettled()) await frames(1); // the browser tells of sight a frame late
    const before = times();
    await frames(4);
    const after = times();
    return elements.map((element, i) => ({
      isSeen: element.getBoundingClientRect().top < innerHeight,
      moves: (after[i] ?? 0) > (before[i] ?? 0),
    }));
  });
  expect(frames.some(({ isSeen }) => isSeen)).toBe(true);
  expect(frames.some(({ isSeen }) => !isSeen)).toBe(true);
  for (const { isSeen, moves } of frames) expect(moves).toBe(isSeen);
  expect(await lostContexts(page)).toEqual([false]);
  expect(fetched.length).toBeGreaterThan(0);
  // Taken out one by one, the last gives the context back.
  await page.evaluate(async () => {
    for (const element of document.querySelectorAll("candle-flame")) element.remove();
    await new Promise((resolve) => setTimeout(resolve));
  });
  expect(await lostContexts(page)).toEqual([true]);
  expect(complaints).toEqual([]);
});

test("A shared context that is lost comes back for all, and the scene may change", async ({
  page,
}) => {
  const one = `<candle-flame scene="candle" paused quality="low" style="width: 40px; height: 40px"></candle-flame>`;
  const { complaints } = await open(page, one.repeat(2));
  const { same, objects } = await page.evaluate(async () => {
    const elements = [...document.querySelectorAll("candle-flame")];
    await Promise.all(elements.map(({ ready }) => ready));
    const pictures = () =>
      elements.map((element) => {
        element.step(0);
        return element.shadowRoot?.querySelector("canvas")?.toDataURL();
      });
    const before = pictures();
    const objects = [elements[0]?.stats.gpuObjects];
    const extension = contexts[0]?.getExtension("WEBGL_lose_context");
    const nextEvent = (type: "contextlost" | "contextrestored") =>
      Promise.all(
        elements.map(
          (element) =>
            new Promise((resolve) => element.addEventListener(type, resolve, { once: true })),
        ),
      );
    const lost = nextEvent("contextlost");
    extension?.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve));
    const restored = nextEvent("contextrestored");
    extension?.restoreContext();
    await restored;
    objects.push(elements[0]?.stats.gpuObjects);
    return { same: JSON.stringify(pictures()) === JSON.stringify(before), objects };
  });
  expect(same).toBe(true);
  expect(objects[0]).toBeGreaterThan(10);
  expect(objects[1]).toBe(objects[0]);
  // A room has a context of its own; back among candles, it is given back.
  await page.evaluate(async () => {
    const [element] = document.querySelectorAll("candle-flame");
    if (!element) throw new Error("no element");
    element.look = "paper";
    element.scene = "room";
    await element.ready;
    element.scene = "candle";
    await element.ready;
  });
  expect(await lostContexts(page)).toEqual([false, true]);
  expect(complaints).toEqual([]);
});

test("The candle's warm glow lies on the page if the page asks for it", async ({ page }) => {
  await drawNothing(page);
  await open(
    page,
    `<div style="padding: 100px"><candle-flame scene="candle" paused quality="low" style="width: 40px; height: 40px"></candle-flame></div>`,
  );
  const opacity = (glow: string) =>
    page.locator("candle-flame").evaluate(async (element: CandleFlameElement, glow) => {
      await element.ready;
      element.style.setProperty("--candle-flame-glow", glow);
      const layer = element.shadowRoot?.querySelector("[part~=glow]");
      return Number(layer && getComputedStyle(layer).opacity);
    }, glow);
  expect(await opacity("")).toBe(0);
  expect(await opacity("0.5")).toBeGreaterThan(0.3);
  expect(await opacity("7")).toBe(await opacity("1"));
  const unlit = await page.locator("candle-flame").evaluate((element: CandleFlameElement) => {
    const layer = element.shadowRoot?.querySelector("[part~=glow]");
    element.scene = "room";
    element.scene = "candle"; // anew: there is no flame yet
    return Number(layer && getComputedStyle(layer).opacity);
  });
  expect(unlit).toBe(0);
});

test("A lazy element fetches and asks for nothing until the visitor is near", async ({ page }) => {
  await drawNothing(page);
  const { complaints, fetched } = await open(
    page,
    `<div style="height: 3000px"></div>
     <candle-flame scene="candle" loading="lazy" poster="/textures/leather-albedo.avif" paused quality="low" style="width: 40px; height: 40px"></candle-flame>`,
  );
  const candle = page.locator("candle-flame");
  await page.evaluate(async () => {
    const poster = "/textures/leather-albedo.avif";
    Object.assign(document.createElement("candle-flame"), { poster, loading: "lazy" }); // not inserted
    for (let i = 0; i < 5; i++) await new Promise(requestAnimationFrame);
  });
  const early = fetched.filter((path) => /models|scene|textures/.test(path));
  expect(early).toEqual([]);
  expect(await lostContexts(page)).toEqual([]);
  await page.evaluate(() => scrollTo(0, 2600));
  await candle.evaluate((element: CandleFlameElement) => element.ready);
  expect(fetched).toContain("/models/chamberstick.glb");
  expect(fetched).toContain("/textures/leather-albedo.avif");
  expect(await lostContexts(page)).toEqual([false]);
  expect(complaints).toEqual([]);
});

const isSmokeCode = (path: string) => path.includes("page-smoke-code");

test("Blown out and stepped, it smokes over the page, in the same picture each time", async ({
  page,
}) => {
  const one = `<candle-flame scene="candle" paused quality="low" style="width: 120px; height: 120px"></candle-flame>`;
  const { complaints } = await open(page, one + one);
  /** Opacity over the wick, where a flame would end, and at the upper edge; and the pixels. */
  const smoke = (element: CandleFlameElement) =>
    element.ready.then(async () => {
      element.extinguish();
      element.step(0.7);
      const image = await createImageBitmap(await element.toBlob());
      const copy = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!copy) throw new Error("There is no 2D context.");
      copy.drawImage(image, 0, 0);
      const { data } = copy.getImageData(0, 0, image.width, image.height);
      const most = (row: number, rows: number) => {
        const part = data.subarray(4 * row * image.width, 4 * (row + rows) * image.width);
        return Math.max(...part.filter((_, i) => i % 4 === 3));
      };
      return {
        wick: most(Math.round(0.12 * image.height), 6),
        edge: most(0, 1),
        pixels: [...data],
      };
    });
  const candles = page.locator("candle-flame");
  const first = await candles.nth(0).evaluate(smoke);
  expect(first.wick).toBeGreaterThan(20);
  expect(first.edge).toBeLessThan(4);
  expect(await candles.nth(1).evaluate(smoke)).toEqual(first);
  expect(complaints).toEqual([]);
});

test("Blown out, it throws no rod of light, and a speck of its wick glows", async ({ page }) => {
  const { complaints } = await open(
    page,
    `<candle-flame scene="candle" paused quality="high" style="width: 640px; height: 480px"></candle-flame>`,
  );
  const found = await page.locator("candle-flame").evaluate(async (element: CandleFlameElement) => {
    await element.ready;
    const pixels = async () => {
      const image = await createImageBitmap(await element.toBlob());
      const copy = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!copy) throw new Error("There is no 2D context.");
      copy.fillRect(0, 0, image.width, image.height);
      copy.drawImage(image, 0, 0);
      return copy.getImageData(0, 0, image.width, image.height).data;
    };
    element.step(1);
    element.blow(1);
    element.step(0.3);
    const smoke: number[] = [];
    for (let i = 0; i < 3; i++) {
      element.step(0.1);
      element.features.smoke = true;
      const whole = await pixels();
      element.features.smoke = false;
      const without = await pixels();
      smoke.push(whole.reduce((most, value, at) => Math.max(most, value - (without[at] ?? 0)), 0));
    }
    const image = await pixels();
    let red = 0;
    for (let at = 0; at < image.length; at += 4) {
      const [r = 0, g = 0, b = 0] = image.subarray(at, at + 3);
      if (r > 120 && g < 0.45 * r && b < 0.45 * r) red++;
    }
    return { smoke, red };
  });
  const [during = 255, ...after] = found.smoke;
  expect(during, "in the breath, over black").toBeLessThan(40);
  expect(Math.max(...after), "it is gray").toBeLessThan(180);
  expect(Math.max(...after)).toBeGreaterThan(60);
  expect(found.red, "pixels of 0.4 mm").toBeGreaterThan(0);
  expect(found.red).toBeLessThan(16);
  expect(complaints).toEqual([]);
});

test("One that plays fetches the code of its smoke only when it is blown out", async ({ page }) => {
  await drawNothing(page);
  const { complaints, fetched } = await open(
    page,
    `<candle-flame scene="candle" quality="low" style="width: 120px; height: 120px"></candle-flame>`,
  );
  const candle = page.locator("candle-flame");
  await candle.evaluate((element: CandleFlameElement) => element.ready);
  expect(fetched.filter(isSmokeCode)).toEqual([]);
  await candle.evaluate((element: CandleFlameElement) => element.extinguish());
  await expect.poll(() => fetched.some(isSmokeCode)).toBe(true);
  expect(complaints).toEqual([]);
});

test("It works under a policy that allows nothing from elsewhere and no code from text", async ({
  page,
}) => {
  await drawNothing(page);
  const complaints = complaintsOf(page);
  const origins = new Set<string>();
  page.on("request", (request) => origins.add(new URL(request.url()).origin));
  await page.route(`${LIBRARY}strict.html`, (route) =>
    route.fulfill({
      contentType: "text/html",
      headers: { "content-security-policy": "default-src 'self'" },
      body: `<!doctype html><meta charset="utf-8"><title>strict</title>
        <candle-flame scene="candle" paused quality="low"></candle-flame>
        <candle-flame look="paper" paused quality="low"></candle-flame>
        <script type="module" src="/define.js"></script>`,
    }),
  );
  await page.goto(`${LIBRARY}strict.html`);
  const lit = await page.evaluate(async () => {
    await customElements.whenDefined("candle-flame");
    const elements = [...document.querySelectorAll("candle-flame")];
    await Promise.all(elements.map(({ ready }) => ready));
    return elements.map(({ flame }) => flame?.lit);
  });
  expect(lit).toEqual([true, true]);
  expect([...origins]).toEqual([new URL(LIBRARY).origin]);
  expect(complaints).toEqual([]);
});
