import { afterEach, expect, test, vi } from "vitest";
import type { Sources } from "../../../src/assets/buffer-bytes.ts";
import { readDocument } from "../../../src/assets/gltf-document.ts";
import { TextureImages, withoutExif } from "../../../src/assets/texture-images.ts";

afterEach(() => void vi.unstubAllGlobals());

const text = (word: string) => [...word].map((character) => character.charCodeAt(0));
const APP0 = [0xff, 0xe0, 0, 7, ...text("JFIF"), 0];
const SCAN = [0xff, 0xda, 0, 2, ...[0xff, 0xe1, 0, 8, ...text("Exif"), 0, 0]];
const jpeg = (name: string) =>
  Uint8Array.from([0xff, 0xd8, ...APP0, 0xff, 0xe1, 0, 10, ...text(name), 0, 0, 1, 2, ...SCAN]);

test("a JPEG's orientation is hidden, in a copy, and nothing else is", () => {
  const bytes = jpeg("Exif");
  expect(withoutExif(bytes)).toEqual(jpeg("\0\0\0\0"));
  expect(bytes).toEqual(jpeg("Exif"));
  expect(withoutExif(jpeg("http"))).toEqual(jpeg("http"));
});

test("a JPEG that breaks off, and another picture, are left as they are", () => {
  for (const bytes of [[0xff, 0xd8, 0xff], [0xff, 0xd8, 0xff, 0xe1, 0], text("Exif")]) {
    expect(withoutExif(Uint8Array.from(bytes))).toEqual(Uint8Array.from(bytes));
  }
});

test("a KTX2 picture whose only level is longer than some GPUs accept is shrunk", async () => {
  const whole = { width: 8192, height: 2, data: new Uint8Array(4 * 8192 * 2) };
  const shrunk = { width: 4096, height: 1 };
  const resize = vi.fn(async (_image: object, _options: object) => shrunk);
  vi.stubGlobal("createImageBitmap", resize);
  vi.stubGlobal("ImageData", class {});
  const document = readDocument({
    asset: { version: "2.0" },
    textures: [{ extensions: { KHR_texture_basisu: { source: 0 } } }],
    images: [{ bufferView: 0, name: "wall" }],
    buffers: [{}],
    bufferViews: [{ buffer: 0 }],
  });
  const bytes = Uint8Array.from([0xab, ...text("KTX 20"), 0xbb]);
  const sources = { decoders: { ktx2: async () => whole } } as unknown as Sources;
  const images = new TextureImages(document, async () => bytes, sources);
  expect(await images.texture(0)).toBe(shrunk);
  expect(resize.mock.calls[0]?.[1]).toMatchObject({ resizeWidth: 4096, resizeHeight: 1 });
  expect([...images.warnings]).toEqual(["The texture wall is shrunk from 8192 x 2 pixels."]);
});

test("at most four pictures are decoded at once, and one that cannot be holds up no other", async () => {
  const open: { resolve: (image: object) => void; reject: (error: Error) => void }[] = [];
  let most = 0;
  const decode = () =>
    new Promise<object>((resolve, reject) => {
      open.push({ resolve, reject });
      most = Math.max(most, open.length);
    });
  vi.stubGlobal("createImageBitmap", decode);
  const indices = [...Array(10).keys()];
  const document = readDocument({
    asset: { version: "2.0" },
    textures: indices.map((source) => ({ source })),
    images: indices.map((bufferView) => ({ bufferView })),
    buffers: [{}],
    bufferViews: indices.map(() => ({ buffer: 0 })),
  });
  const sources = { file: "a.glb", signal: new AbortController().signal } as unknown as Sources;
  const images = new TextureImages(document, async () => jpeg("Exif"), sources);
  const read = Promise.allSettled(indices.map((index) => images.texture(index)));
  for (let done = 0; done < indices.length; ) {
    await new Promise((resolve) => setImmediate(resolve));
    const one = open.shift();
    if (done++ === 2) one?.reject(new Error("broken"));
    else one?.resolve({ width: 1, height: 1 });
  }
  const outcomes = (await read).map(({ status }) => status);
  expect(outcomes.filter((status) => status === "rejected")).toHaveLength(1);
  expect(most).toBe(4);
});
