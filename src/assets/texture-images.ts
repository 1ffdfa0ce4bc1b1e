import { assetError, Flaw } from "./asset-error.js";
import { nameOf, type ReadView, type Sources } from "./buffer-bytes.js";
import { fetchBytes } from "./fetch-bytes.js";
import type { GltfDocument } from "./gltf-document.js";
import { AS_STORED, closeImage, type TextureImage } from "./model.js";

/** Longest side of an image, pixels: more than is visible by candlelight, and than some GPUs accept. */
export const LONGEST_SIDE = 4096;

/** Sources of a texture that the browser decodes itself, the smallest first. */
const SOURCES = ["EXT_texture_avif", "EXT_texture_webp"] as const;

const KTX2_IDENTIFIER = [0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb];
const EXIF = [0x45, 0x78, 0x69, 0x66];

/** Texture images of a file: each decoded once, and all of them closed if the model fails. */
export class TextureImages {
  readonly warnings = new Set<string>();
  readonly #document: GltfDocument;
  readonly #readView: ReadView;
  readonly #sources: Sources;
  readonly #images = new Map<number, Promise<TextureImage>>();
  #isClosed = false;

  constructor(document: GltfDocument, readView: ReadView, sources: Sources) {
    this.#document = document;
    this.#readView = readView;
    this.#sources = sources;
  }

  /** The image of a texture, or null where it has none of a known type. */
  async texture(index: number): Promise<TextureImage | null> {
    const images = this.#imagesOf(index);
    if (images.length === 0) {
      this.warnings.add("A texture without a picture of a known kind is left out.");
      return null;
    }
    let failure: unknown;
    for (const image of images) {
      try {
        return await this.#image(image);
      } catch (error) {
        failure ??= error;
      }
    }
    throw failure;
  }

  /** Whether two textures are of the same image. */
  areSame(one: number, other: number): boolean {
    return this.#imagesOf(one).join() === this.#imagesOf(other).join();
  }

  /** Closes the decoded images and those being decoded; none is begun afterwards. */
  close(): void {
    this.#isClosed = true;
    for (const image of this.#images.values()) image.then(closeImage).catch(() => {});
  }

  /** In the order in which they are tried. */
  #imagesOf(index: number): number[] {
    const texture = this.#document.textures[index];
    const count = this.#document.images.length;
    const sources = [
      ...SOURCES.map((name) => texture?.extension(name)?.index("source", count)),
      texture?.index("source", count),
      // Last: its decoder has to be fetched, and the result is plain pixels as well.
      texture?.extension("KHR_texture_basisu")?.index("source", count),
    ];
    return sources.filter((source) => source !== undefined);
  }

  #image(index: number): Promise<TextureImage> {
    // An image begun after the others were closed would stay open.
    if (this.#isClosed) throw new Flaw("was given up");
    const image = this.#images.get(index) ?? this.#readImage(index);
    this.#images.set(index, image);
    return image;
  }

  async #readImage(index: number): Promise<TextureImage> {
    const image = this.#document.images[index];
    const uri = image?.string("uri");
    const view = image?.index("bufferView", this.#document.views.length);
    const name = image?.string("name") ?? (uri === undefined ? `number ${index}` : nameOf(uri));
    // Errors of a buffer are reported for the file, not for this image.
    const inside = view === undefined ? null : await this.#readView(view);
    try {
      if (inside) return await this.#decode(inside, name);
      if (uri === undefined) throw new Flaw("is missing");
      const { resolve, shared, signal } = this.#sources;
      const address = resolve(uri);
      const isForeign = (type: string) => /^(text|video|audio|font)\//.test(type);
      const decoded =
        shared.get(address.href) ??
        fetchBytes(address, { signal, isForeign }).then((bytes) => this.#decode(bytes, name));
      shared.set(address.href, decoded);
      return await decoded;
    } catch (cause) {
      this.#sources.signal.throwIfAborted();
      throw assetError(`The texture ${name} of ${this.#sources.file}`, cause);
    }
  }

  async #decode(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<TextureImage> {
    const isKtx2 = KTX2_IDENTIFIER.every((byte, i) => bytes[i] === byte);
    const image = await (isKtx2 ? this.#sources.decoders.ktx2(bytes) : bitmapOf(bytes));
    const { width, height } = image;
    const shrink = LONGEST_SIDE / Math.max(width, height);
    if (shrink >= 1) return image;
    this.warnings.add(`The texture ${name} is shrunk from ${width} x ${height} pixels.`);
    try {
      return await resized(image, {
        resizeWidth: Math.max(1, Math.round(width * shrink)),
        resizeHeight: Math.max(1, Math.round(height * shrink)),
        resizeQuality: "high",
      });
    } finally {
      closeImage(image);
    }
  }
}

/** A copy of an image in another size. */
export function resized(image: TextureImage, options: ImageBitmapOptions): Promise<ImageBitmap> {
  const { width } = image;
  const source = "data" in image ? new ImageData(new Uint8ClampedArray(image.data), width) : image;
  return createImageBitmap(source, { ...AS_STORED, ...options });
}

/** Ends of the rows in which images are decoded: some browsers do it while the page waits, and all in one go. */
const rows: Promise<unknown>[] = Array.from({ length: 4 }, () => Promise.resolve());

function bitmapOf(bytes: Uint8Array<ArrayBuffer>): Promise<ImageBitmap> {
  const stored = new Blob([withoutExif(bytes)]);
  const before = rows.shift() ?? Promise.resolve();
  const decoded = before.then(() => createImageBitmap(stored, AS_STORED));
  rows.push(decoded.catch(() => {}));
  return decoded.catch((cause: unknown) => {
    throw new Flaw("is not a picture that can be read", { cause });
  });
}

/** A JPEG whose orientation is not known: glTF's uv is of the picture as stored, and browsers turn it. */
export function withoutExif(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  if (bytes[0] !== 0xff || bytes[1] !== 0xd8) return bytes;
  const copy = bytes.slice();
  // The segments before the scan: a marker of two bytes, and a length that counts its own two.
  for (let at = 2; copy[at] === 0xff && copy[at + 1] !== 0xda; ) {
    if (copy[at + 1] === 0xe1 && EXIF.every((byte, i) => copy[at + 4 + i] === byte)) {
      copy.fill(0, at + 4, at + 8);
    }
    at += 2 + (copy[at + 2] ?? 0) * 256 + (copy[at + 3] ?? 0);
  }
  return copy;
}
