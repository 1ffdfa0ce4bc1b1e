// Calls in an unusual order: from listeners, before the first frame, with nothing for a value.
import type { CandleFlameElement } from "../../src/candle-flame-element.ts";
import type { RoomDriver } from "../support/room-driver.ts";
import { expect, test } from "../support/test.ts";

const WREATH = "/models/wreath.glb";

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
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
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

test("`ready` of a scene that a listener of `load` has chosen waits for that scene", async ({
  room,
}) => {
  const found = await useAnother(
    room,
    { look: "paper", paused: "" },
    (element) => {
      element.addEventListener(
        "load",
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

test("A wick that is no number is the model's own", async ({ room }) => {
  const scene = { scene: "candle", src: "/models/jar.glb", paused: "" };
  const heightOf = (element: CandleFlameElement) => {
    element.step(1);
    return element.flame?.height;
  };
  const own = await useAnother(room, scene, () => {}, heightOf);
  const bad = await useAnother(room, { ...scene, wick: "thick" }, () => {}, heightOf);
  expect(bad).toBe(own);
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
