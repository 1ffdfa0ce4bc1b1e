import { afterAll, beforeAll, expect, test, vi } from "vitest";
import type { CandleFlameElement, Feature } from "../../../src/candle-flame-element.ts";
import { climb, LADDER_STEPS } from "../../../src/page/lab/ladder.ts";
import { allFeatures } from "../../../src/settings.ts";

/** As much of the element as is measured. */
class Room {
  readonly features = allFeatures();
  /** Steps at which frames were drawn, in their order. */
  readonly drawn: number[] = [];

  step(): void {
    const isOn = ({ adds }: { adds: readonly Feature[] }) =>
      adds.every((one) => this.features[one]);
    const step = LADDER_STEPS.findLastIndex(isOn);
    if (this.drawn.at(-1) !== step) this.drawn.push(step);
  }
  readRadiance(): void {}
}

const climbIn = (room: Room, signal: AbortSignal, onProgress: Parameters<typeof climb>[3]) =>
  climb(room as unknown as CandleFlameElement, 2, signal, onProgress);

beforeAll(() => {
  vi.stubGlobal("requestAnimationFrame", (run: () => void) => setTimeout(run));
});
afterAll(() => void vi.unstubAllGlobals());

test("rounds go up and down the ladder in turn, after frames that say how many fit a burst", async () => {
  const room = new Room();
  let last: readonly number[] = [];
  const frames = await climbIn(room, new AbortController().signal, (_, medians) => {
    last = medians;
  });
  expect(frames).toBeGreaterThan(0);
  expect(last).toHaveLength(LADDER_STEPS.length);
  expect(room.drawn).toEqual([4, 0, 1, 2, 3, 4, 3, 2, 1, 0]);
});

test("a climb that is stopped at a step draws no frame of the next", async () => {
  const room = new Room();
  const stop = new AbortController();
  const climbing = climbIn(room, stop.signal, () => stop.abort(new Error("enough")));
  await expect(climbing).rejects.toThrow("enough");
  expect(room.drawn).toEqual([4, 0]);
});
