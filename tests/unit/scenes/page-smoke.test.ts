import { expect, test, vi } from "vitest";
import { createPageSmoke, fetchPageSmoke } from "../../../src/scenes/page-smoke.ts";

let isOnline = false;
const createPlume = vi.fn(() => ({}));
vi.mock("../../../src/scenes/page-smoke-code.ts", () => {
  if (!isOnline) throw new Error("offline");
  return { createPlume };
});

test("the smoke's code is fetched again after it was missed, a while later", async () => {
  vi.useFakeTimers();
  const warn = vi.spyOn(console, "warn").mockImplementation(() => {});
  await fetchPageSmoke();
  await fetchPageSmoke();
  expect(warn).toHaveBeenCalledOnce();
  isOnline = true;
  expect(createPageSmoke(1, [0, 0, 0], true)).toBeNull();
  vi.runAllTimers();
  await fetchPageSmoke();
  expect(createPageSmoke(1, [0, 0, 0], true)).not.toBeNull();
  vi.restoreAllMocks();
  vi.useRealTimers();
});
