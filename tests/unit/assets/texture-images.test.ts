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
