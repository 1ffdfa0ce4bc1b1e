import { expect, test } from "vitest";
import { noCounts } from "../../../src/gl/frame-counts.ts";
import { GpuTimer } from "../../../src/gl/gpu-timer.ts";

/** A driver whose queries all have taken as many nanoseconds as their number says, once it is ready. */
function place() {
  const driver = { isReady: false, isDisjoint: false, made: 0, deleted: 0, running: 0 };
  const gl = {
    QUERY_RESULT_AVAILABLE: 1,
    getExtension: () => ({ TIME_ELAPSED_EXT: 2, GPU_DISJOINT_EXT: 3 }),
    createQuery: () => ++driver.made,
    beginQuery: () => driver.running++,
    endQuery: () => driver.running--,
    deleteQuery: () => driver.deleted++,
    getQueryParameter: (query: number, name: number) => (name === 1 ? driver.isReady : query),
    getParameter: () => {
      const { isDisjoint } = driver;
      driver.isDisjoint = false; // reading it resets it
      return isDisjoint;
    },
  };
  const timer = new GpuTimer(gl as unknown as WebGL2RenderingContext);
  const frame = (counts = noCounts()) => {
    timer.begin(counts);
    timer.end();
    return counts;
  };
  return { driver, frame, timer };
}

test("the time of a frame is that of the view that drew it", () => {
  const { driver, frame } = place();
  const [one, other] = [frame(), frame()];
  driver.isReady = true;
  frame();
  frame();
  expect([one.seconds, other.seconds]).toEqual([1e-9, 2e-9]);
});

test("a disjoint clock takes the times of all frames in flight", () => {
  const { driver, frame } = place();
  const frames = [frame(), frame(), frame()];
  Object.assign(driver, { isReady: true, isDisjoint: true });
  for (let i = 0; i < 3; i++) frame();
  expect(frames.map(({ seconds }) => seconds)).toEqual([null, null, null]);
  expect(driver.deleted).toBe(5);
});

test("a frame that threw does not stop the clock of those after it", () => {
  const { driver, frame, timer } = place();
  timer.begin(noCounts());
  frame();
  expect(driver.running).toBe(0);
});
