// Calls in an unusual order: from listeners, before the first frame, with nothing for a value.
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import { plainRoom } from "../support/plain-room.ts";
import { LIBRARY, RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const WREATH = "/models/wreath.glb";
/** A transparent one. */
const PIXEL = Buffer.from(
  "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNkYAAAAAYAAjCB0C8AAAAASUVORK5CYII=",
  "base64",
);

/** Uses an element of its own beside the test's, before its first frame and after it. */
function useAnother<Result>(
  { page }: RoomDriver,
  attributes: Readonly<Record<string, string>>,
  before: (element: CandleFlameElement) => void,
  after: (element: CandleFlameElement) => Result | Promise<Result>,
): Promise<Result> {
  return page.evaluate(
    async ({ attributes, before, after }) => {
      const element = document.createElement("candle-flame");
      element.style.cssText = "width: 32px; height: 18px";
      for (const [name, value] of Object.entries({ quality: "low", ...attributes }))
        element.setAttribute(name, value);
      // biome-ignore lint/security/noGlobalEval: functions of this file, as text
      const [first, then] = [before, after].map((text) => globalThis.eval(`(${text})`));
      first(element);
      document.body.append(element);
      await element.ready;
      const result = await then(element);
      element.remove();
      return result;
    },
    { attributes, before: `${before}`, after: `${after}` },
  );
}

test("A listener may stop the time that begins, and let it go on where it ends", async ({
  room,
}) => {
  const [stopped, resumed] = await useAnother(
    room,
    { look: "paper" },
    (element) => element.addEventListener("play", () => element.pause(), { once: true }),
    async (element) => {
      const passes = async () => {
        const before = element.currentTime;
        for (let frame = 0; frame < 4; frame++) await new Promise(requestAnimationFrame);
        return element.currentTime > before;
      };
      const stopped = [element.paused, await passes(), element.matches(":state(playing)")];
      element.play();
      element.addEventListener("pause", () => element.play(), { once: true });
      element.pause();
      return [stopped, [element.paused, await passes(), element.matches(":state(playing)")]];
    },
  );
  expect(stopped).toEqual([true, false, false]);
  expect(resumed).toEqual([false, true, true]);
});

test("A property that is set to nothing takes the attribute away", async ({ room }) => {
  const found = await room.evaluate((element) => {
    for (const name of ["alt", "wick", "src", "poster"] as const) {
      Object.assign(element, { [name]: name === "wick" ? 3 : "" });
      Object.assign(element, { [name]: name === "alt" ? null : undefined });
    }
    return [element.alt, element.wick, element.getAttributeNames()] as const;
  });
  expect(found.slice(0, 2)).toEqual(["A burning candle", 2]);
  for (const name of ["alt", "wick", "src", "poster"]) expect(found[2]).not.toContain(name);
});

test("A flag that a template sets to the text of an attribute is on, and off where it is nothing", async ({
  room,
}) => {
  const found = await room.evaluate((element) =>
    ["", false, true, null, "true", undefined].map((value) => {
      Object.assign(element, { paused: value });
      return [element.paused, element.hasAttribute("paused")];
    }),
  );
  await room.evaluate((element) => element.pause());
  expect(found).toEqual([true, false, true, false, true, false].map((isOn) => [isOn, isOn]));
});

test("`lit` that is set to nothing stays as it is", async ({ room }) => {
  const found = await room.evaluate((element) =>
    [undefined, true, null, false, undefined].map((value) => {
      Object.assign(element, { lit: value });
      return element.lit;
    }),
  );
  await room.evaluate((element) => element.light());
  expect(found).toEqual([true, true, true, false, false]);
});

test("Before the first frame the first candle alone is lit and put out, and no attribute changes", async ({
  room,
}) => {
  const stateOf = (element: CandleFlameElement) => {
    const lit = element.candles.map((candle) => candle.lit);
    const { unlit } = element;
    element.reset();
    return { lit, unlit, afterwards: element.candles.map((candle) => candle.lit) };
  };
  const scene = { scene: "candle", src: WREATH, paused: "" };
  const out = await useAnother(room, scene, (element) => element.extinguish(), stateOf);
  expect(out.lit).toEqual([false, true, true, true]);
  expect([out.unlit, out.afterwards]).toEqual([false, [true, true, true, true]]);
  const lit = await useAnother(
    room,
    { ...scene, unlit: "" },
    (element) => {
      element.lit = true;
    },
    stateOf,
  );
  expect(lit.lit).toEqual([true, false, false, false]);
  expect([lit.unlit, lit.afterwards]).toEqual([true, [false, false, false, false]]);
});

test("A reset before the first frame drops what was asked for, as one after it does", async ({
  room,
}) => {
  const found = await useAnother(
    room,
    { look: "paper", paused: "" },
    (element) => {
      element.camera = { yaw: 1 };
      element.place();
      element.extinguish();
      element.reset();
    },
    (element) => {
      const seen = () => [element.camera.yaw, element.held, element.lit];
      const first = seen();
      element.reset();
      return [first, seen()];
    },
  );
  expect(found[0]).toEqual(found[1]);
});

test("Before the first frame, too, members of a camera that are missing or no numbers stay as they are", async ({
  room,
}) => {
  const [before, after] = await useAnother(
    room,
    { look: "paper", paused: "" },
    (element) => {
      element.camera = { position: [1, 1.5, -1], yaw: 1 };
      const nothing = { position: [Number.NaN, undefined, -2], yaw: null, pitch: 0.2 };
      element.camera = nothing as never;
      element.camera = { position: undefined, yaw: Number.NaN } as never;
      element.camera = null as never;
      const { position, yaw, pitch } = element.camera;
      Reflect.set(element, "before", { position: [...position], yaw, pitch });
      Reflect.set(position, "0", 3); // the page's own copy
    },
    (element) => {
      const { position, yaw, pitch } = element.camera;
      return [Reflect.get(element, "before"), { position, yaw, pitch }];
    },
  );
  expect(before).toEqual({ position: [1, 1.5, -2], yaw: 1, pitch: 0.2 });
  expect(after).toEqual(before);
});

test("What is asked for while another room is fetched is done there, too", async ({ room }) => {
  const found = await useAnother(
    room,
    { look: "paper", paused: "" },
    () => {},
    async (element) => {
      const loaded = new Promise((resolve) =>
        element.addEventListener("load", resolve, { once: true }),
      );
      element.src = "/models/paper-room.glb";
      element.camera = { yaw: 1, pitch: -0.5 };
      element.place();
      element.camera = { yaw: 2, pitch: 0 };
      await loaded;
      return [element.held, element.camera.yaw, element.camera.pitch];
    },
  );
  expect(found).toEqual([false, 2, 0]);
});

for (const [change, what] of [
  [{ look: "original" }, "is of the same files"],
  [{ src: "/models/paper-room.glb" }, "has other files"],
] as const) {
  test(`A camera set while programs are compiled is kept where another look or room ${what}`, async ({
    room,
  }) => {
    const found = await useAnother(
      room,
      { look: "paper", quality: "medium", paused: "", "data-change": JSON.stringify(change) },
      (element) => {
        const change = JSON.parse(element.dataset.change ?? "");
        const isShown = new Promise((resolve) => {
          let fetches = change.src ? 2 : 1;
          element.addEventListener("progress", ({ detail }) => {
            if (detail.totalProgress === 1) fetches--;
          });
          element.addEventListener("load", () => fetches === 0 && resolve(null));
        });
        const { prototype } = WebGL2RenderingContext;
        const { linkProgram } = prototype;
        prototype.linkProgram = function (program) {
          prototype.linkProgram = linkProgram;
          linkProgram.call(this, program);
          // All files are there.
          setTimeout(() => {
            Reflect.set(element, "wasCompiling", element.flame === null);
            element.camera = { yaw: 1.5 };
            Object.assign(element, change);
          });
        };
        Reflect.set(element, "isShown", isShown);
      },
      async (element) => {
        await Reflect.get(element, "isShown");
        return [Reflect.get(element, "wasCompiling"), element.camera.yaw];
      },
    );
    expect(found).toEqual([true, 1.5]);
  });
}

test("The picture is that of the quality asked for, also where it has just changed", async ({
  room,
}) => {
  const shades = await useAnother(
    room,
    { look: "paper", quality: "low" },
    () => {},
    async (element) => {
      for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
      await new Promise((resolve) => setTimeout(resolve)); // the browser has taken the last one
      element.inspect = "depth"; // drawn as at medium
      const bitmap = await createImageBitmap(await element.toBlob());
      element.pause();
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
      context?.drawImage(bitmap, 0, 0);
      const { data } = context?.getImageData(0, 0, bitmap.width, bitmap.height) ?? { data: [] };
      return new Set(data).size;
    },
  );
  expect(shades).toBeGreaterThan(10);
});

test("A fetch that was given up reports no progress", async ({ room }) => {
  const { before, after, isHidden } = await useAnother(
    room,
    { scene: "candle", src: "/models/jar.glb", paused: "" },
    () => {},
    async (element) => {
      let before = 0;
      let after = 0;
      let isOver = false;
      element.addEventListener("progress", ({ detail }) => {
        if (isOver) after++;
        else before = detail.totalProgress;
        if (isOver || before < 0.5) return;
        isOver = true;
        element.src = "/models/jar.glb";
      });
      element.src = "/models/wreath.glb";
      await (await fetch("/models/wreath.glb")).arrayBuffer();
      for (let frame = 0; frame < 30; frame++) await new Promise(requestAnimationFrame);
      const slot = element.shadowRoot?.querySelector<HTMLElement>("slot[name=progress]");
      return { before, after, isHidden: slot?.hidden };
    },
  );
  expect(before).toBeGreaterThan(0.5);
  expect({ after, isHidden }).toEqual({ after: 0, isHidden: true });
});

test("After a `src` that failed nothing more is fetched, and no progress reported", async ({
  room,
}) => {
  const late: (() => void)[] = [];
  await room.page.route(`${LIBRARY}half.gltf`, (route) => {
    const images = ["gone.png", "late.png"].map((uri) => ({ uri }));
    const materials = images.map((_, index) => ({
      pbrMetallicRoughness: { baseColorTexture: { index } },
    }));
    const primitives = materials.map((_, material) => ({ attributes: { POSITION: 0 }, material }));
    const json = {
      asset: { version: "2.0" },
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      meshes: [{ primitives }],
      materials,
      textures: images.map((_, source) => ({ source })),
      images,
      accessors: [{ componentType: 5126, count: 3, type: "VEC3", min: [0, 0, 0], max: [1, 1, 1] }],
    };
    return route.fulfill({ contentType: "model/gltf+json", body: JSON.stringify(json) });
  });
  await room.page.route(`${LIBRARY}gone.png`, (route) =>
    route.fulfill({ contentType: "image/png", body: "no image" }),
  );
  await room.page.route(`${LIBRARY}late.png`, async (route) => {
    await new Promise<void>((resolve) => late.push(resolve));
    await route.fulfill({ contentType: "image/png", body: PIXEL }).catch(() => {});
  });
  await room.page.exposeFunction("answer", () => late.pop()?.());
  const { events, isHidden } = await useAnother(
    room,
    { scene: "candle", src: WREATH, paused: "" },
    () => {},
    async (element) => {
      const events: string[] = [];
      for (const type of ["progress", "error"] as const)
        element.addEventListener(type, () => events.push(type));
      element.src = "half.gltf";
      await new Promise((resolve) => element.addEventListener("error", resolve, { once: true }));
      await (Reflect.get(globalThis, "answer") as () => Promise<void>)();
      for (let frame = 0; frame < 30; frame++) await new Promise(requestAnimationFrame);
      const slot = element.shadowRoot?.querySelector<HTMLElement>("slot[name=progress]");
      return { events, isHidden: slot?.hidden };
    },
  );
  expect(events.at(-1)).toBe("error");
  expect(isHidden).toBe(true);
});

test("A lone candle has no code of controls before it is to have them", async ({ browser }) => {
  const page = await browser.newPage();
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  const code = () => requests.filter((url) => url.includes("first-person-input"));
  const alone = await new RoomDriver(page).open({ scene: "candle", paused: "" });
  expect(code()).toEqual([]);
  await alone.evaluate((element) => {
    element.controls = true;
    element.enter(); // once it is there
  });
  await expect.poll(() => alone.isWalking()).toBe(true);
  expect(code()).toHaveLength(1);
  await page.close();
});

for (const [focused, isIn] of [
  ["input", false],
  ["candle-flame", true],
] as const) {
  test(`A candle that is entered before its controls are there ${isIn ? "is, if the visitor goes to it" : "leaves the focus to a field"}`, async ({
    browser,
  }) => {
    const page = await browser.newPage();
    const alone = await new RoomDriver(page).open({ scene: "candle", paused: "" });
    const found = await alone.evaluate(async (element, focused) => {
      element.after(document.createElement("input"));
      element.controls = true;
      element.enter();
      document.querySelector<HTMLElement>(focused)?.focus();
      const code = "/first-person-input.js";
      await import(code);
      await new Promise((resolve) => setTimeout(resolve));
      return [document.activeElement?.localName, element.matches(":state(walking)")];
    }, focused);
    expect(found).toEqual([focused, isIn]);
    await page.close();
  });
}

test("Another model alone has its own flames, whatever became of those before", async ({
  room,
}) => {
  const { lit, events } = await useAnother(
    room,
    { scene: "candle", src: "/models/jar.glb", paused: "" },
    () => {},
    async (element) => {
      element.extinguish();
      element.step(1);
      const events: string[] = [];
      element.addEventListener("light", ({ detail }) => events.push(detail.name));
      element.src = "/models/wreath.glb";
      await element.ready;
      return {
        lit: [
          element.lit,
          element.matches(":state(lit)"),
          ...element.candles.map((one) => one.lit),
        ],
        events,
      };
    },
  );
  expect(lit).toEqual(Array(6).fill(true));
  expect(events).toHaveLength(1);
});

test("A flame put out while another model alone is on its way stays out", async ({ room }) => {
  const { lit, events } = await useAnother(
    room,
    { scene: "candle", src: "/models/jar.glb", paused: "" },
    () => {},
    async (element) => {
      const events: string[] = [];
      for (const type of ["light", "extinguish"] as const)
        element.addEventListener(type, () => events.push(type));
      element.src = "/models/wreath.glb";
      element.extinguish();
      await element.ready;
      return { lit: element.candles.map((candle) => candle.lit), events };
    },
  );
  expect(lit).toEqual([false, true, true, true]);
  expect(events).toEqual(["extinguish"]);
});

test("Paused while its first frame is prepared, an element rests as sharp as it can be", async ({
  room,
}) => {
  const quality = await useAnother(
    room,
    { look: "paper", quality: "auto" },
    (element) => {
      const prototype = WebGL2RenderingContext.prototype;
      const { linkProgram } = prototype;
      const pause = () => {
        prototype.linkProgram = function (program) {
          prototype.linkProgram = linkProgram;
          element.paused = true;
          linkProgram.call(this, program);
        };
      };
      // Its code and models are there; the renderer's programs come now.
      element.addEventListener("progress", ({ detail }) => detail.totalProgress === 1 && pause());
    },
    (element) => element.stats.quality,
  );
  expect(quality).toBe("high");
});

test("A lone candle burns the same in any look", async ({ room }) => {
  const flameIn = (look: string) =>
    useAnother(
      room,
      { scene: "candle", look, paused: "", wind: "0.5", gustiness: "1" },
      () => {},
      (element) => {
        element.step(1);
        return element.flame;
      },
    );
  const flame = await flameIn("physical");
  expect(flame?.height).toBeGreaterThan(0.01);
  for (const look of ["paper", "original"]) expect(await flameIn(look), look).toEqual(flame);
});

test("Which candles burn is what the attributes say, also before another scene's first frame", async ({
  room,
}) => {
  const lit = await useAnother(
    room,
    { look: "paper", paused: "" },
    () => {},
    async (element) => {
      element.scene = "candle";
      element.litWicks = "1";
      const lit = [element.lit];
      await element.ready;
      return [...lit, element.lit];
    },
  );
  expect(lit).toEqual([false, false]);
});

test("An element that is taken out tells and shows nothing of what it did", async ({ room }) => {
  const found = await useAnother(
    room,
    { look: "paper", paused: "" },
    () => {},
    async (element) => {
      const hint = () => element.shadowRoot?.querySelector("[part=hint]")?.textContent;
      element.extinguish();
      const said = hint();
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
      return [said, hint()];
    },
  );
  expect(found[0]).toMatch(/out/);
  expect(found[1]).toBe("");
});

test("An empty alternative text is that of an image without meaning", async ({ room }) => {
  const semantics = () =>
    room.evaluate((element) => {
      const canvas = element.shadowRoot?.querySelector("canvas");
      return [canvas?.getAttribute("role"), canvas?.getAttribute("aria-label")];
    });
  expect(await semantics()).toEqual(["img", "A burning candle"]);
  await room.set({ alt: "" });
  expect(await semantics()).toEqual(["presentation", null]);
});

test("An array of the page's is read when it is set, and written to by nobody", async ({
  room,
}) => {
  const found = await useAnother(
    room,
    { look: "paper", paused: "" },
    (element) => {
      const position: [number, number, number] = [0.5, 1.6, -0.5];
      element.camera = { position };
      position[0] = 2;
      Reflect.set(element, "given", position);
    },
    (element) => {
      element.step(1);
      return [element.camera.position, Reflect.get(element, "given")];
    },
  );
  expect(found[0]?.[0]).toBeCloseTo(0.5, 3);
  expect(found[1]).toEqual([2, 1.6, -0.5]);
});

test("Another look leaves lone candles as they burn, and is reported", async ({ room }) => {
  const { lit, events } = await useAnother(
    room,
    { scene: "candle", src: WREATH, paused: "" },
    () => {},
    async (element) => {
      element.candles[1]?.extinguish();
      const events: string[] = [];
      element.look = "paper";
      // Listened to after the change, as a page may.
      for (const type of ["load", "light", "extinguish"]) {
        element.addEventListener(type, () => events.push(type));
      }
      await Promise.resolve();
      return { lit: element.candles.map((candle) => candle.lit), events };
    },
  );
  expect(lit).toEqual([true, false, true, true]);
  expect(events).toEqual(["load"]);
});

test("What a reset and another's moment change is reported as what the visitor does is", async ({
  room,
}) => {
  const events = await room.evaluate((element) => {
    const events: string[] = [];
    const types = ["light", "extinguish", "place", "take"] as const;
    for (const type of types) element.addEventListener(type, () => events.push(type));
    element.place();
    element.reset();
    const other = element.cloneNode() as CandleFlameElement;
    document.body.append(other);
    return other.ready.then(() => {
      other.place();
      other.extinguish();
      element.mirror(other);
      other.remove();
      return events;
    });
  });
  expect(events).toEqual(["place", "take", "extinguish", "place"]);
});

for (const type of ["load", "play"] as const) {
  test(`\`ready\` of a scene that a listener of \`${type}\` has chosen waits for that scene`, async ({
    room,
  }) => {
    const found = await useAnother(
      room,
      { look: "paper", ...(type === "load" && { paused: "" }), "data-type": type },
      (element) => {
        element.addEventListener(
          element.dataset.type as "load",
          () => {
            element.scene = "candle";
          },
          { once: true },
        );
      },
      async (element) => {
        await element.ready;
        return [element.flame !== null, element.matches(":state(loading)")];
      },
    );
    expect(found).toEqual([true, false]);
  });
}

test("`ready` waits for another `src`, and for one that is missing as long as it takes to know", async ({
  room,
}) => {
  const found = await useAnother(
    room,
    { scene: "candle", src: WREATH, paused: "" },
    () => {},
    async (element) => {
      const candles = [element.candles.length];
      for (const src of ["/models/jar.glb", "define.js"]) {
        const { ready } = element;
        element.src = src;
        if (element.ready === ready) throw new Error("It has resolved already.");
        await element.ready;
        candles.push(element.candles.length);
      }
      return candles;
    },
  );
  expect(found).toEqual([4, 1, 1]);
});

test("`ready` of another room that plays waits until that room is drawn", async ({ room }) => {
  const body = plainRoom({ min: [-2, 0, -2], max: [2, 2.6, 2] }, [], 0.5);
  for (const name of ["one", "another"]) {
    await room.page.route(`${LIBRARY}${name}.glb`, (route) =>
      route.fulfill({ contentType: "model/gltf-binary", body }),
    );
  }
  const draws = await useAnother(
    room,
    { look: "physical", src: "one.glb", quality: "medium" },
    () => {},
    async (element) => {
      // `stats` tells little: at rest frames draw a part of the room. `readRadiance` would draw a frame itself.
      const { prototype } = WebGL2RenderingContext;
      const { drawArrays } = prototype;
      let draws = Number.NaN;
      prototype.drawArrays = function (...call) {
        draws++;
        drawArrays.apply(this, call);
      };
      element.addEventListener("load", () => {
        draws = 0;
      });
      element.src = "another.glb";
      await element.ready;
      prototype.drawArrays = drawArrays;
      return draws;
    },
  );
  expect(draws, "since the event `load`").toBeGreaterThan(0);
});

test("A lone candle that was paused before its first frame smokes alike each time", async ({
  room,
}) => {
  const pictures = await useAnother(
    room,
    { scene: "candle", quality: "low" },
    (element) => setTimeout(() => element.pause()),
    async (element) => {
      const smoke = () => {
        element.reset();
        element.extinguish();
        element.step(0.5);
        return Array.from(element.readRadiance(0, 0, 32, 18)).join();
      };
      const first = smoke();
      await new Promise((resolve) => setTimeout(resolve, 300));
      return [first, smoke()];
    },
  );
  expect(pictures[0]).toBe(pictures[1]);
});

test("While the context is lost time stands, whatever is set, and there is no picture", async ({
  room,
}) => {
  const lost = await room.evaluate(async (element) => {
    const events: string[] = [];
    for (const type of ["play", "pause"]) element.addEventListener(type, () => events.push(type));
    element.play();
    const context = element.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
    const extension = context?.getExtension("WEBGL_lose_context");
    const next = (type: string) =>
      new Promise((resolve) => element.addEventListener(type, resolve, { once: true }));
    const isLost = next("contextlost");
    extension?.loseContext();
    await isLost;
    const before = element.currentTime;
    element.exposure = 1;
    for (let frame = 0; frame < 4; frame++) await new Promise(requestAnimationFrame);
    const stands = element.currentTime === before;
    const isPlaying = element.matches(":state(playing)");
    const blob = await element.toBlob().catch((error: Error) => error.name);
    const isBack = next("contextrestored");
    extension?.restoreContext();
    await isBack;
    const goesOn = element.matches(":state(playing)");
    element.pause();
    return { events, stands, isPlaying, blob, goesOn };
  });
  expect(lost).toEqual({
    events: ["play", "pause", "play", "pause"],
    stands: true,
    isPlaying: false,
    blob: "Error",
    goesOn: true,
  });
});
