import { expect, test, vi } from "vitest";
import { AutoQuality, type Rung, WORK } from "../../../src/render/auto-quality.ts";
import type { Renderer } from "../../../src/render/renderer.ts";
import type { CanvasTarget } from "../../../src/scenes/canvas-target.ts";
import { type NextParts, NextRenderer } from "../../../src/scenes/next-renderer.ts";
import type { Scene } from "../../../src/scenes/scene.ts";
import { SceneView } from "../../../src/scenes/scene-view.ts";
import type { ViewFrame, ViewSettings } from "../../../src/scenes/view-subject.ts";

const MEDIUM: Rung = { tier: "medium", share: 0.6 };
/** Until all promises of a preparation have been kept. */
const settled = () => new Promise((resolve) => setTimeout(resolve));

/** As much of a GPU and a scene as a renderer is prepared with. */
function place({ error = null as Error | null } = {}) {
  const gpu = {
    isAhead: false,
    isLost: false,
    ahead: new Set<object>(),
    longestSide: 4096,
    whenCompiled: () => Promise.resolve(),
    whenIdle: () => Promise.resolve(),
    finishPrograms: () => {
      if (error) throw error;
    },
    check: () => {},
    clearUnshared: () => {
      gpu.ahead = new Set();
    },
  };
  const sizes: number[][] = [];
  const ahead: boolean[] = [];
  const renderer = {
    resize: (...size: number[]) => sizes.push(size),
    setLayers: () => ahead.push(gpu.isAhead),
    async prepare(_: unknown, __: unknown, isWanted: () => boolean) {
      for (let step = 0; step < 3 && isWanted(); step++) {
        ahead.push(gpu.isAhead);
        await Promise.resolve();
        gpu.isAhead = false; // a frame of the renderer before
      }
    },
  } as unknown as Renderer;
  let isReady = false;
  const scene = { prepareRenderer: () => isReady, createRenderer: () => renderer };
  const parts = {
    scene,
    target: { gpu },
    settings: { look: "physical" },
    auto: new AutoQuality(WORK.physical),
    subject: { world: {}, layers: [] },
    pixels: { width: 1000, height: 500 },
    frame: {},
  } as unknown as NextParts;
  const uploaded = () => {
    isReady = true;
  };
  return { next: new NextRenderer(() => parts), parts, gpu, renderer, sizes, ahead, uploaded };
}

test("a renderer is prepared once its parts are, at its rung's size, and taken by its tier alone", async () => {
  const { next, renderer, sizes, ahead, uploaded } = place();
  expect([next.proceed(MEDIUM), next.isBusy]).toEqual([false, false]);
  uploaded();
  expect([next.proceed(MEDIUM), next.isBusy]).toEqual([false, true]);
  await settled();
  expect(next.proceed(MEDIUM)).toBe(true);
  expect(sizes).toEqual([[600, 300]]);
  expect(ahead, "what it makes is its own").toEqual([true, true, true, true]);
  expect(next.take("medium")?.renderer).toBe(renderer);
});

test("particles made for another world while it is prepared are its own, and those of the one before are not", async () => {
  const { next, parts, gpu, renderer, ahead, uploaded } = place();
  const { subject, target, auto } = parts;
  const scene = { createRenderer: () => renderer } as unknown as Scene;
  const settings = { look: "physical", quality: "auto" } as ViewSettings;
  const view = new SceneView(target as CanvasTarget, scene, settings, subject, true, auto);
  uploaded();
  next.proceed(MEDIUM);
  await settled();
  ahead.length = 0;
  gpu.isAhead = true; // between two steps
  view.follow(subject);
  next.follow(subject);
  expect([...ahead, gpu.isAhead]).toEqual([false, true, false]);
});

test("one that is taken for a still frame, of a larger size than those in motion, gets that size", async () => {
  const { parts, renderer, sizes, uploaded } = place();
  const { scene, target, subject, auto } = parts;
  uploaded();
  const canvas = { width: 1, height: 1 };
  const ignore = () => {};
  Object.assign(scene, { createNext: (now: () => NextParts) => new NextRenderer(now) });
  Object.assign(target, { canvas, clearUnshared: ignore, prepare: ignore, present: ignore });
  Object.assign(target.gpu, { beginFrame: ignore, endFrame: ignore, whenIdle: settled });
  Object.assign(renderer, { render: ignore });
  const settings = { look: "physical", quality: "auto" } as ViewSettings;
  const view = new SceneView(target, scene as Scene, settings, subject, true, auto);
  view.resize(1920, 1080);
  auto.pixel = 6e-9; // of a GPU that draws three quarters of `high` in time
  const frame = { isMoving: false, canDefer: true } as ViewFrame;
  for (let i = 0; i < 100 && !auto.wanted; i++) {
    await settled();
    view.render(frame, true);
    view.measure(1 / 60);
  }
  await settled();
  expect(sizes.at(-1)).toEqual([1440, 810]);
  view.isPlaying = false;
  view.render(frame, true);
  expect([canvas, sizes.at(-1)]).toEqual([{ width: 1920, height: 1080 }, [1920, 1080]]);
});

test("another tier's is given up, and made again where it is wanted", async () => {
  const { next, uploaded } = place();
  uploaded();
  next.proceed(MEDIUM);
  await settled();
  expect(next.take("high")).toBeNull();
  expect([next.isBusy, next.proceed(MEDIUM), next.isBusy]).toEqual([false, false, true]);
});

test("one whose objects were freed meanwhile is no longer prepared", async () => {
  const { next, gpu, ahead, uploaded } = place();
  uploaded();
  next.proceed(MEDIUM);
  gpu.clearUnshared();
  await settled();
  expect(ahead, "the layers alone").toEqual([true]);
  expect([next.isBusy, next.take("medium")]).toEqual([false, null]);
});

test("a tier that the driver refuses is given up with a warning, but not for a lost context", async () => {
  const error = new Error("refused");
  const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
  const { next, parts, gpu, uploaded } = place({ error });
  const made = gpu.ahead;
  parts.auto.pixel = 1e-12;
  uploaded();
  next.proceed(MEDIUM);
  await settled();
  expect(warn.mock.calls).toEqual([[error]]);
  expect([next.isBusy, gpu.ahead === made], "what was made is freed").toEqual([false, false]);
  parts.auto.renew();
  expect(parts.auto.stillRung).toEqual({ tier: "low", share: 1 });

  const lost = place();
  lost.gpu.whenCompiled = () => Promise.reject(new Error("lost"));
  lost.uploaded();
  lost.next.proceed(MEDIUM);
  lost.gpu.isLost = true;
  await settled();
  expect(lost.next.proceed(MEDIUM)).toBe(false);
  expect(warn).toHaveBeenCalledTimes(1);
  warn.mockRestore();
});
