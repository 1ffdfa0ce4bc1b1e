import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { DrawScheduler } from "../../../src/element/draw-scheduler.ts";

/** Callbacks of the next animation frame. */
let frame = new Map<number, () => void>();
let page = { isVisible: true, isPlaying: false, isBusy: false, draws: 0 };

function createScheduler(): DrawScheduler {
  const element = { ownerDocument: { defaultView: globalThis } } as unknown as Element;
  const scheduler = new DrawScheduler(element, {
    isVisible: () => page.isVisible,
    isPlaying: () => page.isPlaying,
    draw: (isRequired) => {
      if (page.isBusy && !isRequired) return;
      page.draws++;
      scheduler.drawn();
    },
  });
  return scheduler;
}

function nextFrame(): void {
  const callbacks = [...frame.values()];
  frame.clear();
  for (const callback of callbacks) callback();
}

beforeEach(() => {
  let last = 0;
  frame = new Map();
  page = { isVisible: true, isPlaying: false, isBusy: false, draws: 0 };
  vi.stubGlobal("requestAnimationFrame", (callback: () => void) => {
    frame.set(++last, callback);
    return last;
  });
  vi.stubGlobal("cancelAnimationFrame", (id: number) => frame.delete(id));
});

afterEach(() => {
  vi.unstubAllGlobals();
});

test("many requests are one draw, in the next frame", () => {
  const scheduler = createScheduler();
  for (let i = 0; i < 5; i++) scheduler.request();
  expect(page.draws).toBe(0);
  nextFrame();
  nextFrame();
  expect(page.draws).toBe(1);
});

test("a draw in between takes the place of the one that was requested", () => {
  const scheduler = createScheduler();
  scheduler.request();
  scheduler.draw();
  nextFrame();
  expect(page.draws).toBe(1);
});

test("while the animation plays nothing is requested beside it", () => {
  const scheduler = createScheduler();
  page.isPlaying = true;
  scheduler.request();
  nextFrame();
  expect(page.draws).toBe(0);
});

test("changes of an invisible canvas are drawn once it is visible", () => {
  const scheduler = createScheduler();
  page.isVisible = false;
  scheduler.request();
  scheduler.drawIfVisible(false);
  scheduler.review();
  nextFrame();
  expect(page.draws).toBe(0);
  page.isVisible = true;
  scheduler.review();
  scheduler.review();
  expect(page.draws).toBe(1);
});

test("a canvas that appears is drawn at once, before the browser says that it is visible", () => {
  const scheduler = createScheduler();
  page.isVisible = false;
  scheduler.drawIfVisible(true);
  expect(page.draws).toBe(1);
  page.isVisible = true;
  scheduler.review();
  expect(page.draws).toBe(1);
});

test("pixels are read as they were drawn in the same task, and drawn again after it", async () => {
  const scheduler = createScheduler();
  scheduler.draw();
  scheduler.refresh();
  expect(page.draws).toBe(1);
  scheduler.request();
  scheduler.refresh();
  expect(page.draws, "after a change").toBe(2);
  await Promise.resolve();
  scheduler.refresh();
  expect(page.draws, "after the task").toBe(3);
});

test("pixels are drawn to be read where a frame left the canvas as it was", () => {
  const scheduler = createScheduler();
  page.isBusy = true; // a renderer is prepared
  scheduler.draw();
  expect(page.draws).toBe(0);
  scheduler.refresh();
  expect(page.draws).toBe(1);
});

test("a call after the next frame draws one now, or waits for the animation loop's", () => {
  const scheduler = createScheduler();
  const called: string[] = [];
  scheduler.afterNext(() => called.push("now"));
  expect([page.draws, called]).toEqual([1, ["now"]]);
  page.isPlaying = true;
  scheduler.afterNext(() => called.push("later"));
  expect([page.draws, called]).toEqual([1, ["now"]]);
  scheduler.draw();
  scheduler.draw();
  expect(called).toEqual(["now", "later"]);
});
