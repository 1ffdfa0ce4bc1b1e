import { afterEach, expect, test, vi } from "vitest";
import { readBuiltInModel } from "../../../src/assets/built-in-model.ts";
import { packGlb } from "../../../tools/models/glb-builder.mjs";

afterEach(() => void vi.unstubAllGlobals());

const textures = [0, 1].map((source) => ({ source }));
const FILE = packGlb(
  {
    asset: { version: "2.0" },
    images: [{ uri: "there.png" }, { uri: "gone.png" }],
    textures,
    materials: textures.map((_, index) => ({ normalTexture: { index } })),
  },
  Buffer.alloc(4),
);

test("where a picture is missing, it is named, and those that are decoded later are closed", async () => {
  const picture = { close: vi.fn() };
  let decode = () => {};
  const decoded = new Promise((resolve) => {
    decode = () => resolve(picture);
  });
  vi.stubGlobal("createImageBitmap", () => decoded);
  vi.stubGlobal("fetch", async ({ pathname }: URL) =>
    pathname === "/gone.png"
      ? new Response(null, { status: 404, statusText: "Not Found" })
      : new Response(pathname === "/candle.glb" ? new Uint8Array(FILE) : "png"),
  );
  const url = new URL("http://host/candle.glb");
  await expect(readBuiltInModel(url, new AbortController().signal, () => {})).rejects.toThrow(
    "The texture gone.png of candle.glb could not be fetched: the server answers 404 Not Found.",
  );
  decode();
  await new Promise((resolve) => setTimeout(resolve));
  expect(picture.close).toHaveBeenCalledOnce();
});
