import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { CandleFlameElement } from "../../../src/candle-flame-element.ts";
import { fullResolution } from "../../../src/page/full-resolution.ts";

const room = (width: number, others = {}) =>
  ({
    clientWidth: 1280,
    maxPixelRatio: 2,
    quality: "auto",
    inspect: "picture",
    paused: false,
    matches: () => false,
    stats: { width },
    ...others,
  }) as unknown as CandleFlameElement & { stats: { width: number } };

beforeEach(() => {
  vi.stubGlobal("devicePixelRatio", 1);
  vi.useFakeTimers();
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.useRealTimers();
});

test("a photo waits until the canvas has all of its pixels", async () => {
  const coarse = room(512);
  const done = vi.fn();
  const onWait = vi.fn();
  void fullResolution(coarse, onWait).then(done);
  await vi.advanceTimersByTimeAsync(3000);
  expect(onWait).toHaveBeenCalledOnce();
  expect(done).not.toHaveBeenCalled();
  coarse.stats.width = 1280;
  await vi.advanceTimersByTimeAsync(200);
  expect(done).toHaveBeenCalled();
});

test("not for long where that never comes", async () => {
  const done = vi.fn();
  void fullResolution(room(512), () => {}).then(done);
  await vi.advanceTimersByTimeAsync(8000);
  expect(done).toHaveBeenCalled();
});

test.each([
  ["it has them", 1280, {}],
  ["the page chose its tier", 512, { quality: "low" }],
  ["a pass is inspected", 512, { inspect: "depth" }],
  ["nothing is drawn", 512, { paused: true }],
  ["one walks", 512, { matches: () => true }],
])("and not at all where %s", async (_, width, others) => {
  const onWait = vi.fn();
  await fullResolution(room(width, others), onWait);
  expect(onWait).not.toHaveBeenCalled();
});
