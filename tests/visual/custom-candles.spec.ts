import type { Page } from "playwright/test";
import sharp from "sharp";
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { GlbBuilder } from "../../tools/models/glb-builder.mjs";
import { candlePlate, jarCandle, ringOf } from "../support/candle-model.ts";
import { plainRoom } from "../support/plain-room.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

/** A wick between two screens, each of which is cut out by its vertices' opacity times its material's. */
function screenedWick(ofVertices: number, ofMaterial: number): Buffer {
  const builder = new GlbBuilder();
  const cut = { baseColorFactor: [1, 1, 1, ofMaterial], metallicFactor: 0 };
  const plain = builder.add("materials", { pbrMetallicRoughness: { metallicFactor: 0 } });
  const screen = builder.add("materials", { pbrMetallicRoughness: cut, alphaMode: "MASK" });
  const square = (corners: readonly number[], material: number, opacity: number) => ({
    attributes: {
      POSITION: builder.accessor(Float32Array.from(corners), 3),
      COLOR_0: builder.accessor(
        Float32Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? opacity : 1)),
        4,
      ),
    },
    indices: builder.accessor(Uint16Array.of(0, 1, 2, 0, 2, 3), 1),
    material,
  });
  const upright = (x: number) => [x, 0, 0.05, x, 0, -0.05, x, 0.1, -0.05, x, 0.1, 0.05];
  const primitives = [
    square([-0.1, 0, 0.1, 0.1, 0, 0.1, 0.1, 0, -0.1, -0.1, 0, -0.1], plain, 1),
    ...[-0.04, 0.04].map((x) => square(upright(x), screen, ofVertices)),
  ];
  builder.root({ mesh: builder.add("meshes", { primitives }) });
  builder.root({ name: "wick", translation: [0, 0.03, 0] });
  return builder.glb();
}

/** A plate with a card of 2 cm, 1.3 mm above it at the right of its wick. */
function cardOverPlate(): Buffer {
  const builder = new GlbBuilder();
  const material = builder.add("materials", { pbrMetallicRoughness: { metallicFactor: 0 } });
  const level = ([left, right]: readonly [number, number], y: number, z: number) => ({
    attributes: {
      POSITION: builder.accessor(
        Float32Array.of(left, y, z, right, y, z, right, y, -z, left, y, -z),
        3,
      ),
    },
    indices: builder.accessor(Uint16Array.of(0, 1, 2, 0, 2, 3), 1),
    material,
  });
  const primitives = [level([-0.1, 0.1], 0, 0.1), level([0.05, 0.07], 0.0013, 0.02)];
  builder.root({ mesh: builder.add("meshes", { primitives }) });
  builder.root({ name: "wick", translation: [0, 0.03, 0] });
  return builder.glb();
}

const MODELS: Readonly<Record<string, Buffer>> = {
  "custom-candle.glb": candlePlate([{ at: [0, 0], height: 0.09, radius: 0.03 }], 0.06),
  "custom-plate.glb": candlePlate([{ at: [0, 0], height: 0.09, radius: 0.03 }], 0.2),
  "custom-candles-4.glb": candlePlate(ringOf(4, 0.09, 0.07, 0.028), 0.14),
  "custom-candles-16.glb": candlePlate(ringOf(16, 0.085, 0.05, 0.004), 0.11),
  "custom-jar.glb": jarCandle(),
  "custom-row.glb": candlePlate(
    [0, 0.05, 0.1, 0.15].map((z) => ({ at: [0, z], height: 0.09, radius: 0.01 })),
    0.2,
  ),
  "custom-card.glb": cardOverPlate(),
  "custom-low-and-high.glb": candlePlate(
    [
      { at: [0, -0.05], height: 0.05, radius: 0.02 },
      { at: [0, 0.02], height: 0.12, radius: 0.03 },
    ],
    0.1,
  ),
  "custom-clear-vertices.glb": screenedWick(0, 1),
  "custom-clear-material.glb": screenedWick(1, 0),
  "no-wick.glb": plainRoom({ min: [0, 0, 0], max: [0.1, 0.1, 0.1] }, [], 0.5),
};
/** The same as goldens.spec.ts. */
const TOLERANCE = { threshold: 0.1, maxDiffPixelRatio: 0.002 };
const SIZE = { width: 480, height: 270 };

let page: Page;
let room: RoomDriver;
const warnings: string[] = [];
const fetched: string[] = [];

test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  page.on("console", (message) => {
    if (message.type() === "warning" && /wick/.test(message.text())) warnings.push(message.text());
  });
  page.on("request", (request) => fetched.push(new URL(request.url()).pathname));
  for (const [name, body] of Object.entries(MODELS)) {
    await page.route(`${LIBRARY}${name}`, (route) =>
      route.fulfill({ contentType: "model/gltf-binary", body }),
    );
  }
  room = await new RoomDriver(page).open(
    { scene: "candle", src: "custom-candle.glb", look: "physical", quality: "medium" },
    SIZE,
  );
});
test.afterAll(() => page.close());
test.afterEach(() => expect(room.complaints).toEqual([]));

/** Shows another model, from time 0. */
const show = (src: string) =>
  room.evaluate(async (element, src) => {
    if (element.getAttribute("src") !== src) {
      const loaded = new Promise((resolve) =>
        element.addEventListener("load", resolve, { once: true }),
      );
      element.src = src;
      await loaded;
    }
    element.reset();
    element.step(0);
  }, src);

for (const [src, count] of [
  ["custom-candle.glb", 1],
  ["custom-candles-4.glb", 4],
  ["custom-candles-16.glb", 16],
  ["custom-jar.glb", 1],
  ["/models/wreath.glb", 4],
  ["/models/jar.glb", 1],
] as const) {
  const name = src.replace(/^\/models\//, "our-").replace(".glb", "");
  test(`${name} burns alone on the page as it did, with ${count} flames`, async () => {
    const picture = await room.png({ attributes: { src }, isReset: true, seconds: 0.5 });
    const states = await room.evaluate((element) =>
      element.candles.map(({ lit, name }) => `${name} ${lit}`),
    );
    expect(states).toHaveLength(count);
    expect(states[0]).toBe("wick true");
    expect(new Set(states).size, "each has its name").toBe(count);
    expect(picture).toMatchSnapshot(`${name}.png`, TOLERANCE);
    const { channels } = await sharp(picture).stats();
    expect(channels[3]?.min, "the page shows around it").toBe(0);
    expect(warnings).toEqual([]);
  });
}

test("its code and its model alone are fetched, and the built-in candle's is not", async () => {
  const files = fetched.filter((path) => /models|scene|chamberstick/.test(path));
  expect(files.some((path) => /custom-candle-scene/.test(path))).toBe(true);
  expect(files.filter((path) => /chamberstick|room-scene|\/candle-scene/.test(path))).toEqual([]);
});

test("flames that go out leave light to the others, and wax glows below a burning one alone", async () => {
  await show("custom-candles-4.glb");
  const [all, three, none] = await room.evaluate((element) => {
    // Through the lower half of a front candle's wax.
    const luminance = () => {
      element.step(1.5);
      const { width, height } = element.stats;
      const [x, y] = [Math.round(0.36 * width), Math.round(0.62 * height)];
      return element.readRadiance(x, y, 4, 4).reduce((sum, value) => sum + value, 0);
    };
    element.reset();
    const all = luminance();
    for (const candle of element.candles) {
      // The front left one: its wick is the lowest and leftmost.
      if (candle.position[2] > 0 && candle.position[0] < 0) candle.extinguish();
    }
    const three = luminance();
    for (const candle of element.candles) candle.extinguish();
    return [all, three, luminance()];
  });
  expect(three).toBeLessThan(0.9 * (all ?? 0));
  expect(none).toBeLessThan(0.5 * (three ?? 0));
});

test("wax does not glow by the light on another candle's top", async () => {
  await show("custom-low-and-high.glb");
  const [opaque = 0, glowing = 0] = await room.evaluate((element) => {
    // The lower one alone, behind the higher one.
    element.candles[1]?.extinguish();
    element.step(2);
    return [false, true].map((translucency) => {
      element.features.translucency = translucency;
      element.step(0);
      const { width, height } = element.stats;
      return element
        .readRadiance(width / 2 - 2, Math.round(0.4 * height), 4, 4)
        .reduce((sum, value) => sum + value, 0);
    });
  });
  console.log(`radiance with and without glow: ${glowing}, ${opaque}`);
  expect(opaque).toBeGreaterThan(0);
  expect(glowing / opaque).toBeLessThan(1.3);
});

test("what lies 1.3 mm above a plate casts a shadow on it", async () => {
  await show("custom-card.glb");
  const shadowed = await room.evaluate((element) => {
    element.step(0);
    const { width } = element.stats;
    // Around the card and its shadow, which lies at the right, and the same at the left.
    const [top, rows, left, columns] = [174, 36, 318, 50];
    const right = element.readRadiance(left, top, columns, rows);
    const mirrored = element.readRadiance(width - left - columns, top, columns, rows);
    return Array.from({ length: rows * columns }, (_, i) => {
      const [x, y] = [i % columns, Math.floor(i / columns)];
      return right[3 * i]! / mirrored[3 * (y * columns + columns - 1 - x)]!;
    }).filter((share) => share < 0.5).length;
  });
  console.log(`pixels in shadow: ${shadowed}`);
  expect(shadowed, "none with four times the bias").toBeGreaterThan(40);
});

test("the flame of a wide wick looks over the candle's rim onto the plate", async () => {
  await show("custom-plate.glb");
  const shares: number[] = [];
  for (const wick of ["2", "10"]) {
    await room.set({ wick });
    const [shadowed = 0, whole = 1] = await room.evaluate((element) =>
      [true, false].map((shadows) => {
        element.features.shadows = shadows;
        element.reset();
        element.step(0.5);
        const { width, height } = element.stats;
        const radiance = element.readRadiance(0, 0, width, height);
        // Of what is lit, not of the flame.
        return radiance.reduce((sum, x, i) => (i % 3 === 0 && x < 40 ? sum + x : sum), 0);
      }),
    );
    shares.push(shadowed / whole);
  }
  await room.evaluate((element) => {
    element.removeAttribute("wick");
    element.features.shadows = true;
  });
  console.log(`light beside shadows: ${shares.map((share) => share.toFixed(2))}`);
  expect(shares[0]).toBeLessThan(0.4);
  expect(shares[1], "0.43 from a taper's height").toBeGreaterThan(0.8);
});

test("the flame of a wider wick stays within the canvas", async () => {
  await show("custom-candle.glb");
  const shares: number[] = [];
  for (const wick of ["2", "10", "50"]) {
    await room.set({ wick });
    const [top = 0, all = 1] = await room.evaluate((element) => {
      element.reset();
      element.step(0.5);
      const { width, height } = element.stats;
      const brightest = (rows: number) =>
        element.readRadiance(0, 0, width, rows).reduce((a, b) => Math.max(a, b));
      return [brightest(2), brightest(height)];
    });
    shares.push(top / all);
  }
  await room.evaluate((element) => element.removeAttribute("wick"));
  expect(Math.max(...shares)).toBeLessThan(0.01);
});

test("a breath blows all of them out, and the events say which", async () => {
  await show("custom-candles-4.glb");
  const { events, out } = await room.evaluate((element) => {
    const events: string[] = [];
    const listen = ({ detail }: CustomEvent) => void events.push(`${detail.index} ${detail.name}`);
    element.addEventListener("extinguish", listen);
    element.blow();
    for (let i = 0; i < 6; i++) element.step(0.25);
    element.removeEventListener("extinguish", listen);
    return { events, out: element.candles.filter(({ lit }) => !lit).length };
  });
  expect(out).toBe(4);
  expect(events.toSorted()).toEqual(["0 wick", "1 wick.001", "2 wick.002", "3 wick.003"]);
});

test("one model after another leaves nothing on the GPU", async () => {
  await show("custom-candle.glb");
  const before = await room.stats();
  await show("custom-candles-4.glb");
  await show("custom-candle.glb");
  const { gpuObjects, gpuBytes } = await room.stats();
  expect({ gpuObjects, gpuBytes }).toEqual({
    gpuObjects: before.gpuObjects,
    gpuBytes: before.gpuBytes,
  });
});

test("what its vertices' opacity cuts out casts no shadow", async () => {
  const shown: number[][] = [];
  for (const src of ["custom-clear-vertices.glb", "custom-clear-material.glb"]) {
    await show(src);
    shown.push(
      await room.evaluate((element) => {
        const { width, height } = element.stats;
        const high = Math.floor(height / 5);
        const sum = (y: number) =>
          element.readRadiance(0, y, width, high).reduce((total, x) => total + x, 0);
        return [0, 1, 2, 3].map((band) => sum(band * high));
      }),
    );
  }
  console.log(`light in bands: ${shown.map((bands) => bands.map(Math.round))}`);
  expect(shown[0]?.some((light) => light > 0)).toBe(true);
  expect(shown[0]).toEqual(shown[1]);
});

test("four flames behind one another stay within half floats", async () => {
  await show("custom-row.glb");
  const { count, most } = await room.evaluate((element) => {
    element.step(0.5);
    const { width, height } = element.stats;
    const radiance = element.readRadiance(0, 0, width, height);
    const most = radiance.reduce((a, b) => Math.max(a, b));
    return { count: radiance.filter(Number.isFinite).length, most };
  });
  console.log(`largest radiance ${most}`);
  expect(count).toBe(3 * SIZE.width * SIZE.height);
  expect(most, "more than a flame alone").toBeGreaterThan(30_000);
});

test("without their volume, flames are not seen", async () => {
  await show("custom-candle.glb");
  const brightest = (volume: boolean) =>
    room.evaluate((element, volume) => {
      element.features.volume = volume;
      element.step(0);
      const { width, height } = element.stats;
      return element.readRadiance(0, 0, width, height).reduce((a, b) => Math.max(a, b), 0);
    }, volume);
  expect(await brightest(false)).toBeLessThan(0.1 * (await brightest(true)));
});

test("a candle beside another is the same when that shows another model", async () => {
  await show("custom-candle.glb");
  await room.evaluate(async (element) => {
    const other = element.cloneNode() as typeof element;
    other.id = "other";
    element.after(other);
    await other.ready;
  });
  const radiance = () =>
    page.locator("#other").evaluate((other: CandleFlameElement) => {
      other.step(0);
      return other.readRadiance(0, 0, other.stats.width, other.stats.height).join();
    });
  const before = await radiance();
  await show("custom-jar.glb");
  expect((await radiance()) === before).toBe(true);
  await page.locator("#other").evaluate((other) => other.remove());
});

test("a model without a wick gives way to the built-in candle, with a warning", async () => {
  await show("no-wick.glb");
  const candles = await room.evaluate((element) => element.candles.map(({ lit }) => lit));
  expect(candles).toEqual([true]);
  expect(warnings).toEqual([
    "The model has no node named wick: the built-in candle burns in its place.",
  ]);
});
