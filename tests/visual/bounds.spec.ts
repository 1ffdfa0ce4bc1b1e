import { FEATURES, SETTINGS } from "../../src/settings.ts";
import { expect, test } from "../support/test.ts";

/** Longest script of one call on a busy machine, milliseconds; what has no bound takes minutes. */
const LONGEST = 5000;

/** What nobody should write anywhere; made in the page, since not all of it travels. */
function extremes(): unknown[] {
  const numbers = [1e9, -1e9, 1e308, Number.NaN, Infinity, -Infinity, -0, 0.5, 2 ** 32, 5e-324];
  const texts = ["", " ", "NaN", "1e9", "-1e9", "9".repeat(1e6), "x".repeat(1e6), "\u0000", "<b>"];
  const things = [null, undefined, true, {}, [], [1, 2], () => 1, 10n ** 30n, new Date(0)];
  return [...numbers, ...texts, ...things];
}

test("No value of any attribute or property throws, takes long, or remains if it is illegal", async ({
  room,
}) => {
  // Those fetch other models, which six hundred rounds are about.
  const settings = Object.keys(SETTINGS).filter(
    (name) => !["scene", "look", "src", "asset-base", "loading"].includes(name),
  );
  await room.set({ quality: "low" });
  const found = await room.evaluate(
    (element, { settings, features, make, longest }) => {
      const values = new Function(`return (${make})()`)() as unknown[];
      const faults: string[] = [];
      const attempt = (what: string, action: () => void) => {
        const timed = () => {
          const begin = performance.now();
          try {
            action();
          } catch (error) {
            faults.push(`${what}: ${error}`);
          }
          return performance.now() - begin;
        };
        if (timed() < longest) return;
        element.readRadiance(0, 0, 1, 1); // once more, lest it is the GPU or another program that lasts
        const time = timed();
        if (time > longest) faults.push(`${what}: ${time} ms`);
      };
      for (const name of settings) {
        const property = name.replace(/-(.)/g, (_, letter: string) => letter.toUpperCase());
        const before = element.getAttribute(name);
        for (const [i, value] of values.entries()) {
          if (value !== undefined) {
            attempt(`${name}[${i}]`, () => element.setAttribute(name, String(value)));
          }
          attempt(`.${property}[${i}]`, () => Reflect.set(element, property, value));
          // The others are no matter of the simulation; a million particles are the GPU's.
          if (/^(seed|wi|gust|motion)/.test(name))
            attempt(`step at ${name}[${i}]`, () => element.step(1 / 60));
        }
        if (before === null) element.removeAttribute(name);
        else element.setAttribute(name, before);
      }
      for (const [i, value] of values.entries()) {
        for (const name of ["features", "camera", "lit", "inspect"]) {
          attempt(`.${name}[${i}]`, () => Reflect.set(element, name, value));
        }
        for (const part of ["position", "yaw", "pitch", "fieldOfView"]) {
          attempt(`camera.${part}[${i}]`, () => Reflect.set(element, "camera", { [part]: value }));
        }
        const place = [value, value, value];
        attempt(`camera at [${i}]`, () => Reflect.set(element, "camera", { position: place }));
        attempt(`features of [${i}]`, () => {
          element.features = Object.fromEntries(
            [...features, "odd", "__proto__"].map((name) => [name, value]),
          ) as never;
        });
        attempt(`step after [${i}]`, () => element.step(1 / 60));
      }
      element.inspect = "picture";
      element.reset();
      for (const name of features) element.features[name] = true;
      element.lit = true;
      element.step(1);
      const { camera, flame, currentTime, stats } = element;
      const numbers = JSON.stringify({ camera, flame, currentTime });
      const radiance = element.readRadiance(0, 0, stats.width, stats.height);
      return {
        faults,
        holes: numbers.match(/null/g),
        most: radiance.reduce((most, value) => Math.max(most, value), 0),
      };
    },
    { settings, features: FEATURES, make: String(extremes), longest: LONGEST },
  );
  expect(found.faults).toEqual([]);
  expect(found.holes, "what is no number").toBeNull();
  expect(found.most, "the picture is not black").toBeGreaterThan(0.1);
});

test("No argument of any method throws, takes long, or has lasting effects", async ({ room }) => {
  await room.set({ quality: "low" });
  const found = await room.evaluate(
    async (element, { make, longest }) => {
      const values = new Function(`return (${make})()`)() as unknown[];
      const faults: string[] = [];
      const attempt = (what: string, action: () => void) => {
        const timed = () => {
          const begin = performance.now();
          try {
            action();
          } catch (error) {
            if (what.startsWith("step") && /^RangeError: .* at most 60 s/.test(String(error)))
              return 0;
            faults.push(`${what}: ${error}`);
          }
          return performance.now() - begin;
        };
        if (timed() < longest) return;
        element.readRadiance(0, 0, 1, 1); // once more, lest it is the GPU or another program that lasts
        const time = timed();
        if (time > longest) faults.push(`${what}: ${time} ms`);
      };
      const blobs: Promise<unknown>[] = [];
      const unstarted = document.createElement("candle-flame");
      const others = [element, unstarted, document.body, ...values];
      const names = ["step", "reset", "blow", "play", "pause", "light", "extinguish", "enter"];
      for (const one of [unstarted, element]) {
        const call = (name: string, ...given: unknown[]) => {
          const method: unknown = Reflect.get(one, name);
          if (typeof method === "function") return Reflect.apply(method, one, given);
          throw new Error(`There is no ${name}().`);
        };
        for (const [i, value] of values.entries()) {
          for (const name of names) attempt(`${name}[${i}]`, () => call(name, value));
          for (const name of ["place", "take"]) attempt(`${name}[${i}]`, () => call(name, value));
          attempt(`readRadiance[${i}]`, () => call("readRadiance", value, value, value, value));
          attempt(`readRadiance here[${i}]`, () => call("readRadiance", 0, 0, value, value));
          attempt(`readRadiance there[${i}]`, () => call("readRadiance", value, value, 2, 2));
          attempt(`toBlob[${i}]`, () => {
            const blob: unknown = call("toBlob", value, value);
            if (!(blob instanceof Promise)) throw new Error("There is no promise.");
            blobs.push(blob);
          });
          attempt(`after[${i}]`, () => one.step(1 / 60));
        }
        for (const [i, other] of others.entries()) {
          attempt(`mirror[${i}]`, () => call("mirror", other));
        }
      }
      await Promise.allSettled(blobs);
      element.blur();
      element.pause();
      element.reset(1);
      element.lit = true;
      element.step(1);
      const { camera, flame, currentTime, stats } = element;
      const numbers = JSON.stringify({ camera, flame, currentTime });
      const { width, height } = stats;
      const radiance = element.readRadiance(0, 0, width, height);
      return {
        faults,
        holes: numbers.match(/null/g),
        most: radiance.reduce((most, value) => Math.max(most, value), 0),
        sizes: [
          element.readRadiance(0, 0, 1e9, 1e9).length === width * height * 3,
          element.readRadiance(-1e9, 1e9, 2.9, 1).length === 2 * 3,
          element.readRadiance(-1e9, 0, 2, 2).every((value) => value === 0),
          element.readRadiance(0, 0, -1, Number.NaN).length === 0,
        ],
      };
    },
    { make: String(extremes), longest: LONGEST },
  );
  expect(found.faults).toEqual([]);
  expect(found.holes, "what is no number").toBeNull();
  expect(found.most, "the picture is not black").toBeGreaterThan(0.1);
  expect(found.sizes).toEqual([true, true, true, true]);
});

test("A step of more than a minute is refused in a sentence, and a minute is not", async ({
  room,
}) => {
  const found = await room.evaluate((element) => {
    const errors = [60.001, 1e6, Infinity].map((seconds) => {
      try {
        element.step(seconds);
      } catch (error) {
        return String(error);
      }
      return "nothing";
    });
    const before = element.currentTime;
    element.step(60);
    return { errors, passed: [before, element.currentTime] };
  });
  expect(found.errors[0]).toMatch(/^RangeError: step\(\) takes at most 60 seconds, not 60\.001\./);
  expect(found.errors.slice(1)).toEqual([
    expect.stringMatching(/^RangeError: .* not 1000000\./),
    expect.stringMatching(/^RangeError: .* not Infinity\./),
  ]);
  expect(found.passed[0]).toBe(0);
  expect(found.passed[1]).toBeCloseTo(60, 6);
});
