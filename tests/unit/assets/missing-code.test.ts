import { expect, test, vi } from "vitest";
import { Decoders } from "../../../src/assets/decoders.ts";
import { loadCustomCandle } from "../../../src/scenes/custom-candle-scene.ts";
import { loadModels } from "../../../src/scenes/room-models.ts";

const offline = vi.hoisted(() => () => {
  throw new Error("Failed to fetch dynamically imported module: http://host/chunk.js");
});
vi.mock("../../../src/assets/load-model.ts", offline);
vi.mock("three/examples/jsm/loaders/DRACOLoader.js", offline);
vi.mock("three/examples/jsm/loaders/KTX2Loader.js", offline);
vi.mock("three/examples/jsm/libs/meshopt_decoder.module.js", offline);

test("a missing part of the program is named in one sentence, without its address", async () => {
  const request = { look: "physical", src: "", assetRoot: "http://host/" } as never;
  for (const load of [loadModels, loadCustomCandle]) {
    await expect(load(request, {} as never)).rejects.toThrow(/^A part of the program .* again\.$/);
  }
});

test("so is a missing decoder, in the file's sentence", async () => {
  const decoders = new Decoders(new URL("http://host/"));
  const decoded = [
    decoders.draco(),
    decoders.ktx2(new Uint8Array(80)),
    decoders.meshopt(new Uint8Array(), {} as never),
  ];
  for (const one of decoded) {
    await expect(one).rejects.toThrow(/^needs a decoder that could not be fetched$/);
  }
});
