import { beforeEach, expect, test, vi } from "vitest";
import type { Lifecycle } from "../../../src/element/lifecycle.ts";
import type { SessionInput } from "../../../src/element/session.ts";
import { areSame } from "../../../src/scenes/scene.ts";

const noop = () => {};
const source = new EventTarget();

const createCandle = vi.fn();
const MOCKS = {
  "../../../src/scenes/canvas-target.ts": {
    createCanvasTarget: () => ({ source, gpu: { isLost: false }, dispose: noop }),
  },
  "../../../src/scenes/scene.ts": { areSame, loadScene: async () => ({ close: noop }) },
  "../../../src/create-candle.ts": { createCandle, fetchInput: async () => {} },
};

beforeEach(() => {
  vi.stubGlobal("window", { devicePixelRatio: 1 });
  vi.resetModules();
  for (const [path, mock] of Object.entries(MOCKS)) vi.doMock(path, () => mock);
  return () => {
    for (const path of Object.keys(MOCKS)) vi.doUnmock(path);
    vi.resetModules();
    vi.unstubAllGlobals();
  };
});

test("what fails after the end of a session is no error of the next one", async () => {
  const candle = {
    view: { auto: {} },
    onFailure: noop as (error: Error) => void,
    restore: () => new Promise((_, reject) => setTimeout(reject)),
    dispose: noop,
  };
  createCandle.mockResolvedValue(candle);
  const { Session } = await import("../../../src/element/session.ts");
  const owner = { plays: () => true, onCandle: vi.fn(), onError: vi.fn(), onContextLost: noop };
  const words = { scene: "room", look: "paper", assetBase: "", moonDirection: "", litWicks: "" };
  const attributes = { ...words, getAttribute: () => null };
  const ending = new AbortController();
  const session = new Session(
    { clientWidth: 1, clientHeight: 1 } as HTMLCanvasElement,
    { attributes } as unknown as SessionInput,
    ending.signal,
    owner as unknown as Lifecycle,
  );
  await expect.poll(() => owner.onCandle.mock.calls.length).toBe(1);
  candle.onFailure(new Error("its own"));
  expect(owner.onError).toHaveBeenCalledOnce();
  source.dispatchEvent(new Event("webglcontextrestored"));
  ending.abort();
  session.dispose();
  candle.onFailure(new Error("late"));
  await new Promise((resolve) => setTimeout(resolve));
  expect(owner.onError).toHaveBeenCalledOnce();
});
