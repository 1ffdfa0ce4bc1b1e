import { expect, test, vi } from "vitest";
import type { FrameCounts } from "../../../src/gl/frame-counts.ts";
import { AutoQuality, WORK } from "../../../src/render/auto-quality.ts";
import type { Renderer } from "../../../src/render/renderer.ts";
import type { CanvasTarget } from "../../../src/scenes/canvas-target.ts";
import type { Scene } from "../../../src/scenes/scene.ts";
import { SceneView } from "../../../src/scenes/scene-view.ts";
import type { ViewFrame, ViewSettings, ViewSubject } from "../../../src/scenes/view-subject.ts";

/** As much of a shared context as views of lone candles draw in. */
function createGpu() {
  const gpu = {
    counts: null as FrameCounts | null,
    isLost: false,
    longestSide: 4096,
    beginFrame: (counts: FrameCounts) => {
      Object.assign(counts, { drawCalls: 0, triangles: 0 });
      gpu.counts = counts;
    },
    endFrame: () => {},
    whenIdle: () => Promise.resolve(),
    compile: () => {},
    whenCompiled: () => new Promise<void>((resolve) => (gpu.compile = resolve)),
    finishPrograms: () => {},
    isWanted: () => false,
    checks: 0,
    check: () => {
      gpu.checks++;
    },
    clearUnshared: () => {},
  };
  return gpu;
}

/** A view whose renderer draws in that many calls. */
function createView(
  gpu: ReturnType<typeof createGpu>,
  calls: number,
  quality: ViewSettings["quality"] = "low",
): SceneView {
  const renderer = {
    particles: 0,
    resize: () => {},
    setLayers: () => {},
    prepare: async (_world: unknown, _settings: unknown, isWanted: () => boolean) => {
      gpu.isWanted = isWanted;
      await new Promise(() => {});
    },
    render: () => {
      if (gpu.counts) gpu.counts.drawCalls += calls;
    },
  };
  const canvas = { width: 1, height: 1 };
  const noop = () => {};
  const drawing = { prepare: noop, present: noop, renew: noop };
  const target = { gpu, canvas, ...drawing, clear: noop, clearUnshared: noop, dispose: noop };
  const scene = { createRenderer: () => renderer as unknown as Renderer };
  return new SceneView(
    target as unknown as CanvasTarget,
    scene as unknown as Scene,
    { look: "paper", quality } as ViewSettings,
    {} as ViewSubject,
    true,
    new AutoQuality(WORK.plain),
  );
}

const FRAME = { isMoving: false, canDefer: true } as ViewFrame;

test("statistics are of the view's own last frame, whoever else has drawn in the context", () => {
  const gpu = createGpu();
  const [one, other] = [createView(gpu, 6), createView(gpu, 181)];
  one.render(FRAME);
  other.render(FRAME);
  expect([one.stats.drawCalls, other.stats.drawCalls]).toEqual([6, 181]);
});

test("a frame is reported where one was presented: not while another tier is prepared, unless it is required", async () => {
  const view = createView(createGpu(), 1);
  let frames = 0;
  view.onDrawn = () => {
    frames++;
  };
  view.render(FRAME);
  expect(frames).toBe(1);
  await expect.poll(() => view.stats.preparing).toBe(false);
  view.settings = { look: "paper", quality: "high" } as ViewSettings;
  expect(view.stats.preparing, "from the moment it is asked for").toBe(true);
  view.render(FRAME);
  expect(frames).toBe(1);
  expect(view.stats.preparing).toBe(true);
  view.render(FRAME, true);
  expect(frames).toBe(2);
});

test("a view whose context comes back begins with the tier that plays, not with that of a still image", () => {
  const view = createView(createGpu(), 1, "auto");
  view.auto.pixel = 1e-9;
  view.resize(640, 360);
  view.isPlaying = false;
  view.render({ ...FRAME, canDefer: false });
  expect(view.stats.quality).toBe("high");
  view.restore(true);
  expect(view.stats.quality).toBe("low");
  expect(view.isBusy, "the caller prepares the first frame").toBe(false);
});

test("the driver is asked about the targets of another resolution of the same tier", async () => {
  const gpu = createGpu();
  const view = createView(gpu, 1, "auto");
  const draw = () => {
    view.render(FRAME);
    return expect.poll(() => view.isBusy).toBe(false);
  };
  view.resize(640, 360);
  await draw();
  await draw();
  expect(gpu.checks).toBe(1);
  const { resolutionScale } = view.stats;
  for (let frame = 0; frame < 20; frame++) view.measure(1);
  await draw();
  expect(view.stats.resolutionScale).toBeLessThan(resolutionScale);
  expect(gpu.checks).toBe(2);
});

test("a frame that is required ends the preparation of its renderer, which would go on in what it drew", async () => {
  const gpu = createGpu();
  const view = createView(gpu, 1);
  gpu.whenCompiled = () => Promise.resolve();
  view.prepareFrame(FRAME, () => true);
  await expect.poll(() => gpu.isWanted()).toBe(true);
  view.render(FRAME, true);
  expect(gpu.isWanted()).toBe(false);
});

test("a view that is gone neither prepares another frame nor hears what others are refused", async () => {
  const gpu = createGpu();
  const view = createView(gpu, 1);
  view.onRefused = vi.fn();
  view.render(FRAME);
  await expect.poll(() => view.isBusy).toBe(false);
  view.settings = { look: "paper", quality: "high" } as ViewSettings;
  view.rebuild();
  view.render(FRAME, true);
  gpu.check = gpu.finishPrograms = vi.fn(() => {
    throw new Error("another's");
  });
  view.dispose();
  gpu.compile();
  await new Promise((resolve) => setTimeout(resolve));
  expect(gpu.check).not.toHaveBeenCalled();
  expect(view.onRefused).not.toHaveBeenCalled();
});
