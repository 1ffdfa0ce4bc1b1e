import { expect, test, vi } from "vitest";
import { loadRoom } from "../../../src/scenes/room-scene.ts";
import type { Loading, SceneRequest } from "../../../src/scenes/scene.ts";

const close = vi.hoisted(() => vi.fn());
vi.mock("../../../src/scenes/room-models.ts", () => {
  const part = { material: { albedo: { close } } };
  const model = { parts: [part], anchors: {} };
  return { loadModels: async () => ({ room: model, candle: model }) };
});

test("the models of a room that cannot be walked in are closed", async () => {
  const request = { look: "physical", src: "" } as SceneRequest;
  await expect(loadRoom(request, {} as Loading)).rejects.toThrow();
  expect(close).toHaveBeenCalledTimes(2);
});
