import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { watchContext } from "../../../src/element/context-watch.ts";

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("window", globalThis);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("a lost context is given up once, after five seconds in sight", () => {
  const canvas = new EventTarget();
  const end = new AbortController();
  const sight = { isVisible: false };
  const reactions = { onLost: vi.fn(), onRestored: vi.fn(), onGivenUp: vi.fn() };
  watchContext(canvas as HTMLCanvasElement, end.signal, {
    isVisible: () => sight.isVisible,
    ...reactions,
  });
  const { onGivenUp } = reactions;
  canvas.dispatchEvent(new Event("webglcontextlost"));
  vi.advanceTimersByTime(60_000);
  sight.isVisible = true;
  vi.advanceTimersByTime(3500);
  sight.isVisible = false;
  vi.advanceTimersByTime(60_000);
  sight.isVisible = true;
  expect(onGivenUp).not.toHaveBeenCalled();
  vi.advanceTimersByTime(2500);
  expect(onGivenUp).toHaveBeenCalledOnce();
  vi.advanceTimersByTime(60_000);
  expect(onGivenUp).toHaveBeenCalledOnce();
  for (const type of ["webglcontextlost", "webglcontextrestored", "webglcontextlost"]) {
    canvas.dispatchEvent(new Event(type));
  }
  vi.advanceTimersByTime(4500);
  end.abort();
  vi.advanceTimersByTime(60_000);
  expect(onGivenUp).toHaveBeenCalledOnce();
});
