import { expect, test, vi } from "vitest";
import type { AutoQuality } from "../../../src/render/auto-quality.ts";
import type { FrameSettings } from "../../../src/render/frame-settings.js";
import type { Renderer } from "../../../src/render/renderer.js";
import { Refinement } from "../../../src/scenes/refinement.js";
import type { ViewSubject } from "../../../src/scenes/view-subject.js";
import { partsOf } from "../../support/refinement-parts.ts";

const SUBJECT = {
  world: { flame: { glow: 1 }, standing: [], moon: null },
  layers: [],
} as unknown as ViewSubject;
const SIZE = { width: 8, height: 8 };
const FRAME = 1 / 60;
const CUBE = "a shadow cube";

/**
 * A refinement whose captures take so many calls, and its first frame another number, with what they were told. Its
 * surfaces take six steps, as do their shadows, and their light two.
 */
async function refinement(captures: number, passes: number) {
  const told = {
    captures: [] as number[],
    filled: 0,
    faces: 0,
    shadows: [] as unknown[],
    shaded: 0,
    released: 0,
    first: 0,
    begun: 0,
    remaining: 1,
    isMoonOutdated: false,
  };
  const refining = {
    get remaining() {
      return told.remaining;
    },
    prepare: (_: unknown, { steps = 0 }: FrameSettings) => told.captures.push(steps) > captures,
    *shadow() {
      for (let face = 0; face < 6; face++) yield told.faces++;
      return CUBE;
    },
    begin: () => told.begun++,
    drawFirst: () => ++told.first > passes,
    display: { image: () => null },
  };
  const renderer = { refining, resize() {}, setLayers() {} } as unknown as Renderer;
  function* fill() {
    for (let step = 0; step < 6; step++) yield told.filled++;
  }
  function* shade(shadow: unknown) {
    told.shadows.push(shadow);
    for (let step = 0; step < 2; step++) yield told.shaded++;
    return {};
  }
  const initialImage = () => ({
    fill: fill(),
    get isMoonOutdated() {
      return told.isMoonOutdated;
    },
    shade,
    release: () => told.released++,
  });
  const coarse = { initialImage } as unknown as Renderer;
  const made = new Refinement(partsOf(renderer));
  const frame = (settings = {} as FrameSettings) => {
    made.take(FRAME);
    return made.advance(SUBJECT, settings, coarse, SIZE);
  };
  frame();
  await new Promise((resolve) => setTimeout(resolve));
  const until = (isDone: () => boolean) => {
    for (let frames = 0; !isDone(); frames++) {
      if (frames > 1000) throw new Error("It has never happened.");
      frame();
    }
  };
  return { made, told, frame, until };
}

test("a refinement begins with single steps, however fast the frames before it were", async () => {
  const { told, frame, until } = await refinement(3, 2);
  for (let i = 0; i < 28; i++) expect(frame()).toBe(0);
  expect(told.filled).toBe(0);
  for (let i = 0; i < 3; i++) frame();
  expect(told.filled).toBeGreaterThan(0);
  expect(told.filled).toBeLessThanOrEqual(3);
  until(() => told.captures.length > 2);
  expect(told.begun).toBe(1);
  expect(told.captures[0]).toBe(1);
  expect(Math.max(...told.captures)).toBeLessThanOrEqual(2);
});

test("the surfaces that it begins with are drawn, then lit in the light of that moment and its own shadows, and freed", async () => {
  const { told, until } = await refinement(3, 2);
  until(() => told.faces > 0);
  expect(told.filled, "all of them").toBe(6);
  until(() => told.shaded > 0);
  expect([told.faces, told.shadows]).toEqual([6, [CUBE]]);
  until(() => told.begun > 0);
  expect([told.shaded, told.released, told.captures.length]).toEqual([2, 1, 0]);
});

test("a moon that has moved is waited for, before the surfaces are lit", async () => {
  const { told, frame, until } = await refinement(1, 0);
  told.isMoonOutdated = true;
  until(() => told.faces === 6);
  for (let i = 0; i < 60; i++) expect(frame(), "the coarser one goes on").toBe(0);
  expect([told.shaded, told.begun]).toEqual([0, 0]);
  told.isMoonOutdated = false;
  until(() => told.begun > 0);
});

test("its first frame is drawn off the screen, a pass in each frame, before it is shown and tiles are", async () => {
  const { made, told, frame, until } = await refinement(1, 3);
  until(() => told.begun > 0);
  for (let pass = 1; pass <= 3; pass++) {
    expect(frame()).toBe(0);
    expect([told.first, made.shown]).toEqual([pass, null]);
  }
  frame();
  expect(made.shown).not.toBeNull();
  expect(told.captures).toEqual([]);
  while (told.captures.length < 2) expect(frame(), "captures of the tiles' light").toBe(0);
  expect(frame(), "tiles").toBe(1);
});

test("no step is done once no tile is left", async () => {
  const { told, frame, until } = await refinement(1, 0);
  until(() => told.captures.length === 2);
  for (let i = 0; i < 20; i++) frame();
  expect(frame()).toBeGreaterThan(1);
  told.remaining = 0;
  expect(frame()).toBe(0);
  expect(told.captures.length).toBe(2);
});

test("a step aside begins all of it anew", async () => {
  const { made, told, frame, until } = await refinement(1, 0);
  until(() => made.shown !== null);
  for (let i = 0; i < 60; i++) frame();
  made.stop();
  expect(made.shown).toBeNull();
  until(() => told.begun === 2);
  expect(told.filled).toBe(12);
});

test("another exposure, or another feature, begins all of it anew", async () => {
  for (const settings of [{ exposure: 1 }, { features: { shadows: false } }]) {
    const { made, frame, until } = await refinement(1, 0);
    until(() => made.shown !== null);
    frame();
    expect(made.shown).not.toBeNull();
    frame(settings as unknown as FrameSettings);
    expect(made.shown).toBeNull();
  }
});

test("surfaces that nothing begins with are freed, once", async () => {
  const { made, told, until } = await refinement(1, 0);
  until(() => told.filled > 3);
  made.stop();
  made.stop();
  expect(told.released).toBe(1);
});

test("programs are prepared two in a frame, and one after a frame in which a driver compiled", () => {
  let prepared = 0;
  const renderer = {} as Renderer;
  const made = new Refinement(partsOf(renderer, undefined, () => ++prepared > 100));
  const after = (seconds: number) => {
    const before = prepared;
    made.take(seconds);
    made.advance(SUBJECT, {} as FrameSettings, renderer, SIZE);
    return prepared - before;
  };
  expect([0.05, 0.3, 0.1, 0.03].map(after)).toEqual([2, 1, 1, 2]);
});

test("frames that wait for the display are a reason to measure the machine again, and slow ones none", () => {
  let remeasured = 0;
  const parts = partsOf({} as Renderer);
  const auto = { rise: () => {}, remeasure: async () => remeasured++ } as unknown as AutoQuality;
  const made = new Refinement(() => ({ ...parts(), auto }));
  const take = (count: number, seconds: number) => {
    for (let i = 0; i < count; i++) made.take(seconds);
  };
  for (let i = 0; i < 20; i++) {
    take(8, 1 / 60);
    take(1, 0.05);
  }
  expect(remeasured).toBe(0);
  take(30, 1 / 60);
  expect(remeasured).toBe(1);
});

test("what the driver refuses is given up with a warning, until another tier's renderer is there", async () => {
  const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
  const refusal = new Error("refused");
  const refuse = () => {
    throw refusal;
  };
  const renderer = { setLayers() {} } as unknown as Renderer;
  const failing = [
    partsOf(renderer, undefined, refuse),
    partsOf({ setLayers: refuse } as unknown as Renderer),
    partsOf(renderer, () => Promise.reject(refusal)),
  ];
  for (const parts of failing) {
    const prepared = vi.fn(parts().scene.prepareRenderer);
    const scene = { ...parts().scene, prepareRenderer: prepared };
    const made = new Refinement(() => ({ ...parts(), scene }));
    const frame = async () => {
      made.take(FRAME);
      expect(made.advance(SUBJECT, {} as FrameSettings, renderer, SIZE)).toBe(0);
      await new Promise((resolve) => setTimeout(resolve));
    };
    await frame();
    await frame();
    expect(warn).toHaveBeenCalledExactlyOnceWith(refusal);
    expect([prepared.mock.calls.length, made.shown, made.isBusy]).toEqual([1, null, false]);
    made.forget();
    await frame();
    expect(prepared, "again").toHaveBeenCalledTimes(2);
    warn.mockClear();
  }
  warn.mockRestore();
});
