import { afterEach, expect, test, vi } from "vitest";
import { laterTask } from "../../../src/gl/next-task.ts";

afterEach(() => vi.unstubAllGlobals());

test("A later task comes in pages with no scheduler, with one of their own, and with the browser's", async () => {
  const delays: unknown[] = [];
  const postTask = async (task: () => void, options: unknown) => {
    delays.push(options);
    task();
  };
  for (const scheduler of [undefined, { events: [] }, { postTask }]) {
    vi.stubGlobal("scheduler", scheduler);
    await laterTask();
  }
  expect(delays).toEqual([{ delay: 1 }]);
});
