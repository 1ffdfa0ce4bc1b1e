import { Flaw } from "./asset-error.js";
import type { Decoders } from "./decoders.js";
import { fetchBytes } from "./fetch-bytes.js";
import type { GltfDocument } from "./gltf-document.js";

interface Sources {
  /** Binary chunk of a .glb file. */
  readonly binary: Uint8Array<ArrayBuffer> | null;
  readonly decoders: Decoders;
  readonly resolve: (uri: string) => URL;
  readonly signal: AbortSignal;
}

/** The bytes of a document's buffer views, fetched and decompressed when first asked for, and kept. */
export class BufferBytes {
  readonly #document: GltfDocument;
  readonly #sources: Sources;
  readonly #buffers = new Map<number, Promise<Uint8Array<ArrayBuffer>>>();
  readonly #views = new Map<number, Promise<Uint8Array<ArrayBuffer>>>();

  constructor(document: GltfDocument, sources: Sources) {
    this.#document = document;
    this.#sources = sources;
  }

  view(index: number): Promise<Uint8Array<ArrayBuffer>> {
    return memoized(this.#views, index, () => this.#readView(index));
  }

  async #readView(index: number): Promise<Uint8Array<ArrayBuffer>> {
    const view = this.#document.views[index];
    if (!view) throw new Flaw(`is broken: it has no bufferViews[${index}]`);
    const buffer = await memoized(this.#buffers, view.buffer, () => this.#readBuffer(view.buffer));
    const { byteOffset, byteLength, meshopt } = view;
    if (!meshopt) return buffer.subarray(byteOffset, byteOffset + byteLength);
    const source = buffer.subarray(byteOffset, byteOffset + meshopt.byteLength);
    return this.#sources.decoders.meshopt(source, meshopt);
  }

  async #readBuffer(index: number): Promise<Uint8Array<ArrayBuffer>> {
    const { uri, byteLength } = this.#document.buffers[index] ?? { uri: undefined, byteLength: 0 };
    const bytes = await this.#sourceOf(index, uri);
    if (bytes.byteLength < byteLength) {
      throw new Flaw(
        `is cut short: ${bytes.byteLength} of ${byteLength} bytes of its buffer ${index} are there`,
      );
    }
    return bytes;
  }

  async #sourceOf(index: number, uri: string | undefined): Promise<Uint8Array<ArrayBuffer>> {
    const { binary, resolve, signal } = this.#sources;
    if (uri !== undefined) {
      return fetchBytes(resolve(uri), { signal }).catch((cause: unknown) => {
        if (!(cause instanceof Flaw)) throw cause;
        throw new Flaw(`needs a buffer that is not to be had: ${nameOf(uri)} ${cause.message}`, {
          cause,
        });
      });
    }
    if (index === 0 && binary) return binary;
    throw new Flaw(`lacks its buffer ${index}`);
  }
}

/** A name for a part of a file, short enough for a sentence. */
export function nameOf(uri: string): string {
  return uri.startsWith("data:") ? "embedded data" : (uri.split("/").pop() ?? uri);
}

function memoized<Value>(
  values: Map<number, Promise<Value>>,
  index: number,
  make: () => Promise<Value>,
): Promise<Value> {
  const value = values.get(index) ?? make();
  values.set(index, value);
  return value;
}
