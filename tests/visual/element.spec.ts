import { SETTINGS } from "../../src/settings.ts";
import type { Attributes, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

interface Reflection {
  readonly attribute: string;
  readonly property: string;
  readonly fallback: unknown;
  /** Attribute's text, and the property that it gives. */
  readonly read: readonly (readonly [text: string, value: unknown])[];
  /** Property, and the attribute's text that it gives. */
  readonly write: readonly (readonly [value: unknown, text: string])[];
}

const REFLECTIONS: readonly Reflection[] = [
  {
    attribute: "scene",
    property: "scene",
    fallback: "room",
    read: [
      ["candle", "candle"],
      ["CANDLE ", "candle"],
      ["cabin", "room"],
    ],
    write: [["candle", "candle"]],
  },
  {
    attribute: "loading",
    property: "loading",
    fallback: "eager",
    read: [
      ["lazy", "lazy"],
      ["auto", "eager"],
    ],
    write: [["lazy", "lazy"]],
  },
  {
    attribute: "look",
    property: "look",
    fallback: SETTINGS.look.default,
    read: [
      ["original", "original"],
      [" Paper ", "paper"],
      ["PHYSICAL", "physical"],
      ["vivid", SETTINGS.look.default],
    ],
    write: [["original", "original"]],
  },
  {
    attribute: "quality",
    property: "quality",
    fallback: "auto",
    read: [
      ["low", "low"],
      ["LOW", "low"],
      ["best", "auto"],
      ["", "auto"],
    ],
    write: [["low", "low"]],
  },
  {
    attribute: "seed",
    property: "seed",
    fallback: 1,
    read: [
      ["7", 7],
      ["7.9", 7],
      ["-3", 0],
      ["1e99", 0xffffffff],
      ["seven", 1],
      ["Infinity", 1],
    ],
    write: [[9, "9"]],
  },
  {
    attribute: "exposure",
    property: "exposure",
    fallback: 0,
    read: [
      ["-1.5", -1.5],
      ["99", 8],
      ["-99", -8],
      ["NaN", 0],
    ],
    write: [[0.5, "0.5"]],
  },
  {
    attribute: "wind",
    property: "wind",
    fallback: 0.05,
    read: [
      ["1.5", 1.5],
      ["-1", 0],
      ["99", 5],
      ["breeze", 0.05],
    ],
    write: [[2, "2"]],
  },
  {
    attribute: "wind-direction",
    property: "windDirection",
    fallback: 0,
    read: [
      ["90", 90],
      ["-90", -90],
      ["north", 0],
    ],
    write: [[180, "180"]],
  },
  {
    attribute: "gustiness",
    property: "gustiness",
    fallback: 0.5,
    read: [
      ["0.25", 0.25],
      ["-1", 0],
      ["7", 1],
      ["", 0.5],
    ],
    write: [[1, "1"]],
  },
  {
    attribute: "wick",
    property: "wick",
    fallback: 2,
    read: [
      ["20", 20],
      ["0", 1],
      ["500", 50],
      ["thick", 2],
    ],
    write: [[5, "5"]],
  },
  {
    attribute: "unlit",
    property: "unlit",
    fallback: false,
    read: [
      ["", true],
      ["false", true],
    ],
    write: [[true, ""]],
  },
  {
    attribute: "lit-wicks",
    property: "litWicks",
    fallback: "",
    read: [["0 2", "0 2"]],
    write: [[[1, 3], "1,3"]],
  },
  {
    attribute: "moonlight",
    property: "moonlight",
    fallback: 0.15,
    read: [
      ["0.2", 0.2],
      ["-1", 0],
      ["9", 0.3],
      ["full", 0.15],
    ],
    write: [[0.1, "0.1"]],
  },
  {
    attribute: "moon-direction",
    property: "moonDirection",
    fallback: "",
    read: [["-98 27", "-98 27"]],
    write: [["0 45", "0 45"]],
  },
  {
    attribute: "sensitivity",
    property: "sensitivity",
    fallback: 1,
    read: [
      ["2.5", 2.5],
      ["0", 0.1],
      ["99", 5],
      ["fast", 1],
    ],
    write: [[0.5, "0.5"]],
  },
  {
    attribute: "motion",
    property: "motion",
    fallback: "auto",
    read: [
      ["reduced", "reduced"],
      ["FULL", "full"],
      ["none", "auto"],
    ],
    write: [["reduced", "reduced"]],
  },
  {
    attribute: "particles",
    property: "particles",
    fallback: 0,
    read: [
      ["1200", 1200],
      ["-1", 0],
      ["many", 0],
    ],
    write: [[100, "100"]],
  },
  {
    attribute: "max-pixel-ratio",
    property: "maxPixelRatio",
    fallback: 2,
    read: [
      ["1", 1],
      ["0", 0.25],
      ["16", 4],
      ["", 2],
    ],
    write: [[1.5, "1.5"]],
  },
  {
    attribute: "asset-base",
    property: "assetBase",
    fallback: "",
    read: [["elsewhere/", "elsewhere/"]],
    write: [["there", "there"]],
  },
  {
    attribute: "poster",
    property: "poster",
    fallback: "",
    read: [["data:,still", "data:,still"]],
    write: [["data:,other", "data:,other"]],
  },
  {
    attribute: "src",
    property: "src",
    fallback: "",
    read: [["house.glb", "house.glb"]],
    write: [["barn.gltf", "barn.gltf"]],
  },
  {
    attribute: "alt",
    property: "alt",
    fallback: SETTINGS.alt.default,
    read: [
      ["A flame", "A flame"],
      ["", ""],
    ],
    write: [["A light", "A light"]],
  },
  {
    attribute: "controls",
    property: "controls",
    fallback: false,
    read: [
      ["", true],
      ["false", true],
    ],
    write: [[true, ""]],
  },
  {
    attribute: "paused",
    property: "paused",
    fallback: false,
    read: [["", true]],
    write: [[true, ""]],
  },
];

test("Every setting is an attribute and a property of the element", () => {
  const attributes = REFLECTIONS.map(({ attribute }) => attribute).sort();
  expect(attributes).toEqual(Object.keys(SETTINGS).sort());
});

for (const { attribute, property, fallback, read, write } of REFLECTIONS) {
  test(`The attribute ${attribute} and the property ${property} are one`, async ({ room }) => {
    const results = await room.evaluate(
      (_, { attribute, property, read, write }) => {
        const element = document.createElement("candle-flame");
        const properties = element as unknown as Record<string, unknown>;
        const absent = properties[property];
        const texts = read.map(([text]) => {
          element.setAttribute(attribute, text);
          return [text, properties[property]];
        });
        const values = write.map(([value]) => {
          element.removeAttribute(attribute);
          properties[property] = value;
          return [value, element.getAttribute(attribute)];
        });
        return { absent, texts, values };
      },
      { attribute, property, read, write },
    );
    expect(results).toEqual({ absent: fallback, texts: read, values: write });
  });
}

test("A flag's property that is set to false takes the attribute away", async ({ room }) => {
  const left = await room.evaluate((element) => {
    element.controls = true;
    element.controls = false;
    element.paused = false;
    return [element.hasAttribute("controls"), element.hasAttribute("paused")];
  });
  expect(left).toEqual([false, false]);
});

/** What a screen reader is given of the page, and what holds it. */
async function spoken({
  page,
}: RoomDriver): Promise<
  { readonly role: string; readonly name: string; readonly parent: string }[]
> {
  const client = await page.context().newCDPSession(page);
  const { nodes } = await client.send("Accessibility.getFullAXTree");
  await client.detach();
  const roles = new Map(nodes.map(({ nodeId, role }) => [nodeId, role?.value as string]));
  const holder = (id = ""): string => {
    const node = nodes.find(({ nodeId }) => nodeId === id);
    const isBare = node?.ignored || ["generic", "paragraph"].includes(node?.role?.value);
    return isBare ? holder(node?.parentId) : (roles.get(id) ?? "");
  };
  return nodes.flatMap(({ ignored, role, name, parentId }) =>
    ignored ? [] : [{ role: role?.value, name: name?.value ?? "", parent: holder(parentId) }],
  );
}

test("The alternative text is the accessible name, of a picture or of something to enter", async ({
  room,
}) => {
  await room.set({ alt: "A wee flame" });
  const named = async () =>
    (await spoken(room)).flatMap(({ role, name }) => (name === "A wee flame" ? [role] : []));
  expect(await named()).toEqual(["image"]);
  await room.set({ controls: "" });
  expect(await named()).toEqual(["application"]);
});

test("What the hint says is read aloud, from a picture too", async ({ room }) => {
  await room.evaluate((element) => element.extinguish());
  const sentences = async () =>
    (await spoken(room)).flatMap(({ role, name, parent }) =>
      role === "StaticText" && parent === "status" ? [name] : [],
    );
  await expect.poll(sentences).toEqual(["The candle is out."]);
  await room.set({ controls: "" });
  await room.evaluate((element) => {
    element.light();
    element.enter();
    element.step(0);
    element.extinguish();
  });
  await expect.poll(sentences).toEqual(["The candle is out. Press E to light it."]);
  await room.evaluate((element) => element.blur());
  await expect.poll(sentences).toEqual(["The candle is out."]);
});

test.describe("The camera", () => {
  test("is where it was put, and says so", async ({ room }) => {
    await room.set({ look: "paper" });
    await room.stand({ position: [1, 1.5, -2], yaw: 0.5, pitch: -0.25 });
    expect(await room.camera()).toMatchObject({ position: [1, 1.5, -2], yaw: 0.5, pitch: -0.25 });
    await room.evaluate((element) => {
      element.camera = { pitch: 0.1 } as typeof element.camera;
    });
    expect(await room.camera()).toMatchObject({ position: [1, 1.5, -2], yaw: 0.5, pitch: 0.1 });
  });

  test("stays half a metre from every wall of the paper's room", async ({ room }) => {
    await room.set({ look: "paper" });
    await room.stand({ position: [100, 100, 100] });
    expect((await room.camera()).position).toEqual([4.5, 2.7, 4.5]);
    await room.stand({ position: [-100, -100, Number.NEGATIVE_INFINITY] });
    const [x, y, z] = (await room.camera()).position;
    expect([x, y]).toEqual([-4.5, 0.5]);
    expect(Math.abs(z)).toBeLessThanOrEqual(4.5);
  });

  test("goes through the walls of the original, and is brought back by the paper's", async ({
    room,
  }) => {
    await room.set({ look: "original" });
    await room.stand({ position: [9, 1.6, -12] });
    expect((await room.camera()).position).toEqual([9, 1.6, -12]);
    await room.set({ look: "paper" });
    expect((await room.camera()).position).toEqual([4.5, 1.6, -4.5]);
  });

  test("looks neither straight up nor straight down, and ignores what is no number", async ({
    room,
  }) => {
    await room.stand({ position: [0, 1.6, 0], yaw: 0.5, pitch: 9 });
    const { pitch } = await room.camera();
    expect(pitch).toBeGreaterThan(1.4);
    expect(pitch).toBeLessThan(Math.PI / 2);
    await room.stand({ position: [Number.NaN, 1, 1], yaw: Number.NaN, pitch: Number.NaN });
    expect(await room.camera()).toMatchObject({ position: [0, 1, 1], yaw: 0.5, pitch });
  });
});

test.describe("Time", () => {
  const timeOf = (room: RoomDriver) => room.evaluate((element) => element.currentTime);

  test("passes by exactly what a step says, and starts again at a reset", async ({ room }) => {
    await room.step(0.25);
    await room.step(0.1);
    expect(await timeOf(room)).toBeCloseTo(0.35, 9);
    await room.evaluate((element) => element.reset());
    expect(await timeOf(room)).toBe(0);
  });

  test("does not pass by steps that are none", async ({ room }) => {
    for (const seconds of [0, -1, Number.NaN]) await room.step(seconds);
    expect(await timeOf(room)).toBe(0);
  });

  test("passes by itself while playing, and stands still while paused", async ({ room }) => {
    await room.evaluate((element) => element.play());
    await expect.poll(() => timeOf(room)).toBeGreaterThan(0.1);
    const [before, after] = await room.evaluate(async (element) => {
      element.pause();
      const before = element.currentTime;
      for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
      return [before, element.currentTime];
    });
    expect(after).toBe(before);
    expect(await room.evaluate((element) => element.paused)).toBe(true);
  });
});

test("A reset brings the same picture back, whatever happened meanwhile", async ({ room }) => {
  const before = await room.pixels();
  await room.step(0.3);
  await room.stand({ position: [0, 1, 0], yaw: 2 });
  await room.evaluate((element) => element.place());
  expect(await room.pixels()).not.toBe(before);
  await room.evaluate((element) => element.reset());
  expect(await room.pixels()).toBe(before);
  expect(await room.evaluate((element) => element.held)).toBe(true);
});

test.describe("The candle", () => {
  test("can be put down, left, and taken up again where it stands", async ({ room }) => {
    await room.set({ look: "paper" });
    const held = await room.pixels();
    const events = await room.evaluate((element) => {
      const events: string[] = [];
      const stop = new AbortController();
      for (const type of ["place", "take"] as const) {
        const note = () => events.push(`${type} ${element.held}`);
        element.addEventListener(type, note, { signal: stop.signal });
      }
      const { camera } = element;
      element.take(); // it is in the hand
      element.place();
      element.place(); // it stands
      element.camera = { ...camera, position: [-4, 1.6, -4] };
      element.take(); // it is out of reach
      element.camera = camera;
      element.take();
      stop.abort();
      return events;
    });
    expect(events).toEqual(["place false", "take true"]);
    expect(await room.pixels()).toBe(held);
  });

  test("of the original stands where it stands", async ({ room }) => {
    await room.set({ look: "original" });
    const states = await room.evaluate((element) => {
      const states = [element.held];
      element.place();
      element.take();
      return [...states, element.held];
    });
    expect(states).toEqual([false, false]);
  });
});

test.describe("The picture", () => {
  test("comes as a file of the type asked for, as large as the canvas", async ({ room }) => {
    const files = await room.evaluate(async (element) => {
      const blobs = [await element.toBlob(), await element.toBlob("image/jpeg", 0.5)];
      const bitmaps = await Promise.all(blobs.map((blob) => createImageBitmap(blob)));
      return bitmaps.map(({ width, height }, i) => ({ width, height, type: blobs[i]?.type }));
    });
    expect(files).toEqual([
      { width: 160, height: 90, type: "image/png" },
      { width: 160, height: 90, type: "image/jpeg" },
    ]);
  });

  test("has the pixels of its box, capped by maxPixelRatio, scaled by quality", async ({
    room,
  }) => {
    const sizes: number[][] = [];
    for (const attributes of [
      {},
      { "max-pixel-ratio": "0.5" },
      { quality: "low" },
      { quality: "high" },
    ] as Attributes[]) {
      const [chosen, drawn, kept] = await room.evaluate((element, attributes) => {
        const canvas = element.shadowRoot?.querySelector("canvas");
        const before = canvas?.width;
        const size = () => {
          const { width, height, resolutionScale } = element.stats;
          return [width, height, resolutionScale];
        };
        for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
        const chosen = size();
        const isKept = canvas?.width === before;
        element.step(0);
        return [chosen, size(), isKept] as const;
      }, attributes);
      expect(chosen).toEqual(drawn);
      expect(kept, "the canvas keeps its image until it is drawn").toBe(true);
      sizes.push(drawn as number[]);
    }
    expect(sizes).toEqual([
      [160, 90, 1],
      [80, 45, 1],
      [53, 30, 2 / 3],
      [80, 45, 1],
    ]);
  });

  test("under auto, chosen later, is of high at rest and of low where a CPU plays, and leaves nothing behind", async ({
    room,
  }) => {
    await room.set({ quality: "auto" });
    // The machine is measured first: until then it is of low.
    const qualityNow = () =>
      room.evaluate((element) => {
        element.step(0);
        return element.stats.quality;
      });
    await expect.poll(qualityNow).toBe("high");
    expect(await room.stats()).toMatchObject({ width: 160 });
    const measurements = await room.evaluate(async (element) => {
      const measurements: unknown[] = [];
      for (let turn = 0; turn < 2; turn++) {
        element.play();
        while (element.stats.quality !== "low") await new Promise(requestAnimationFrame);
        element.pause();
        element.step(0);
        const { quality, gpuObjects, gpuBytes } = element.stats;
        measurements.push({ quality, gpuObjects, gpuBytes });
      }
      return measurements;
    });
    expect(measurements[0]).toMatchObject({ quality: "high" });
    expect(measurements[1], "nothing is left of the quality before").toEqual(measurements[0]);
  });

  test("brightens with exposure", async ({ room }) => {
    const brightness: number[] = [];
    for (const exposure of ["-2", "0", "2"]) {
      await room.set({ exposure });
      const { data } = await room.picture();
      brightness.push(data.reduce((sum, byte) => sum + byte, 0) / data.length);
    }
    const [dim = 0, even = 0, bright = 0] = brightness;
    expect(even).toBeGreaterThan(dim * 1.2);
    expect(bright).toBeGreaterThan(even * 1.2);
  });

  test("gives the radiance of the pixels asked for, whatever the exposure", async ({ room }) => {
    await room.set({ look: "paper" });
    // A piece of the wall, left of the middle, without the flame.
    const wall = { x: 20, y: 30, width: 40, height: 20 };
    const means: number[] = [];
    for (const exposure of ["0", "1"]) {
      await room.set({ exposure });
      const radiance = await room.evaluate(
        (element, { x, y, width, height }) => element.readRadiance(x, y, width, height),
        wall,
      );
      expect(radiance).toHaveLength(wall.width * wall.height * 3);
      means.push(radiance.reduce((sum, value) => sum + value, 0) / radiance.length);
    }
    const [even = 0, bright = 0] = means;
    expect(even).toBeGreaterThan(0);
    expect(bright / even).toBeCloseTo(1, 1);
  });

  test("has its radiance in the same order as its pixels, from the top left", async ({ room }) => {
    await room.set({ look: "paper" });
    const { data, width, height } = await room.picture();
    const radiance = await room.evaluate(
      (element, { width, height }) => element.readRadiance(0, 0, width, height),
      { width, height },
    );
    const linear = (byte: number) =>
      byte <= 10.31475 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;
    const gains = [...radiance].flatMap((value, i) => {
      const byte = data[Math.floor(i / 3) * 4 + (i % 3)] ?? 0;
      return byte > 20 ? [linear(byte) / value] : [];
    });
    expect(gains.length).toBeGreaterThan(width * height);
    expect(Math.max(...gains) / Math.min(...gains)).toBeCloseTo(1, 4);
  });

  test("is reported in numbers", async ({ room }) => {
    await room.step(1 / 60);
    const { width, height, quality, ...numbers } = await room.stats();
    expect({ width, height }).toEqual({ width: 160, height: 90 });
    expect(["low", "medium", "high", "ultra"]).toContain(quality);
    for (const name of [
      "drawCalls",
      "triangles",
      "particles",
      "gpuObjects",
      "gpuBytes",
      "cpuMs",
    ] as const) {
      expect(numbers[name], name).toBeGreaterThan(0);
    }
    expect(numbers.gpuBytes).toBeGreaterThan(160 * 90 * 4);
    expect(Object.keys(numbers)).toEqual(
      expect.arrayContaining(["fps", "frameMs", "gpuMs", "resolutionScale"]),
    );
  });

  test("has a flame that is reported in SI units", async ({ room }) => {
    await room.step(1);
    const flame = await room.evaluate((element) => element.flame);
    expect(flame).toMatchObject({
      lit: true,
      position: [expect.any(Number), expect.any(Number), expect.any(Number)],
    });
    const { height = 0, width = 0, colorTemperature = 0, tilt = -1 } = flame ?? {};
    expect(height).toBeGreaterThan(0.01);
    expect(height).toBeLessThan(0.2);
    expect(width).toBeGreaterThan(0.002);
    expect(width).toBeLessThan(height);
    expect(colorTemperature).toBeGreaterThan(1500);
    expect(colorTemperature).toBeLessThan(2500);
    expect(tilt).toBeGreaterThanOrEqual(0);
    expect(tilt).toBeLessThan(1);
  });
});

test("There is no picture before the first frame, and nothing throws for want of it", async ({
  room,
}) => {
  const result = await room.evaluate(async () => {
    const element = document.createElement("candle-flame");
    element.step(1);
    element.place();
    element.take();
    element.enter();
    element.reset(3);
    element.play();
    element.pause();
    const picture = await element.toBlob().catch((error: Error) => error.message);
    return {
      picture,
      time: element.currentTime,
      objects: element.stats.gpuObjects,
      radiance: element.readRadiance(0, 0, 2, 1).length,
      seed: element.getAttribute("seed"),
    };
  });
  expect(result).toEqual({
    picture: "There is no picture yet: wait for `ready`.",
    time: 0,
    objects: 0,
    radiance: 0,
    seed: "3",
  });
});

test("Before the first frame the candle is as its attributes and calls will have it", async ({
  room,
}) => {
  const states = await room.evaluate(async (shown) => {
    const made = (attributes: Record<string, string>) => {
      const element = document.createElement("candle-flame");
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
      return element;
    };
    const held = [{}, { scene: "candle" }, { look: "original" }].map((one) => made(one).held);
    const lit = [{}, { unlit: "" }, { "lit-wicks": "1" }, { "lit-wicks": "1 0" }].map(
      (one) => made(one).lit,
    );
    const paper = { look: "paper", paused: "", "lit-wicks": "1" };
    const called = made(paper);
    called.light();
    const later = made(paper);
    later.light();
    later.setAttribute("lit-wicks", "2");
    const same = made(paper);
    same.light();
    same.setAttribute("lit-wicks", "1");
    const all = [called, later, same];
    const before = all.map(({ lit }) => lit);
    shown.after(...all);
    await Promise.all(all.map(({ ready }) => ready));
    const after = all.map(({ lit }) => lit);
    for (const element of all) element.remove();
    return { held, lit, before, after };
  });
  expect(states).toEqual({
    held: [true, false, false],
    lit: [true, false, false, true],
    before: [true, false, true],
    after: [true, false, true],
  });
});
