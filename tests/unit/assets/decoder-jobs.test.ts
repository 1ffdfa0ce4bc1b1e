import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { DecoderJobs } from "../../../src/assets/decoder-jobs.js";

const SLOW = 15_000; // of the 20 s that a job may take

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const decodeIn = (milliseconds: number) => () =>
  new Promise<number>((resolve) => setTimeout(resolve, milliseconds, milliseconds));

test("the time limit counts each job's own time, not its wait for the others", async () => {
  const jobs = new DecoderJobs();
  const all = Promise.all([0, 1, 2].map(() => jobs.run(decodeIn(SLOW))));
  await vi.advanceTimersByTimeAsync(3 * SLOW);
  expect(await all).toEqual([SLOW, SLOW, SLOW]);
});

test("a job beyond the limit fails", async () => {
  const late = new DecoderJobs().run(decodeIn(2 * SLOW)).catch(String);
  await vi.advanceTimersByTimeAsync(2 * SLOW);
  expect(await late).toMatch(/its decoder does not answer/);
});

test("when the worker fails, all jobs do, at once", async () => {
  const jobs = new DecoderJobs();
  const worker = new EventTarget();
  jobs.watch(worker);
  const decode = vi.fn(decodeIn(SLOW));
  const all = [jobs.run(decode), jobs.run(decode)].map((job) => job.catch(String));
  await vi.advanceTimersByTimeAsync(10);
  worker.dispatchEvent(new Event("error"));
  for (const job of all) expect(await job).toMatch(/its decoder cannot run/);
  expect(decode).toHaveBeenCalledTimes(1);
});

test("after the end no job begins", async () => {
  const jobs = new DecoderJobs();
  const decode = vi.fn(decodeIn(SLOW));
  const first = jobs.run(decode).catch(String);
  await vi.advanceTimersByTimeAsync(10);
  const second = jobs.run(decode).catch(String);
  jobs.end();
  expect([await first, await second]).toEqual(["Flaw: was given up", "Flaw: was given up"]);
  expect(decode).toHaveBeenCalledTimes(1);
});
