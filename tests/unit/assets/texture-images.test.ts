import { expect, test } from "vitest";
import { withoutExif } from "../../../src/assets/texture-images.ts";

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
