import { Flaw } from "./asset-error.js";
import type { Decoders } from "./decoders.js";
import { fetchBytes } from "./fetch-bytes.js";
import type { GltfDocument } from "./gltf-document.js";
import { memoized } from "./memoized.js";
import type { TextureImage } from "./model.js";

/** Where what a document names is found. */
export interface Sources {
  /** Name of the model's file. */
  readonly file: string;
  /** Binary chunk of a .glb file. */
  readonly binary: Uint8Array<ArrayBuffer> | null;
  readonly decoders: Decoders;
  readonly resolve: (uri: string) => URL;
  readonly signal: AbortSignal;
  /** Decoded images by address, which models that are loaded together share. */
  readonly shared: Map<string, Promise<TextureImage>>;
}

export type ReadView = (index: number) => Promise<Uint8Array<ArrayBuffer>>;

/** Reads buffer views: each is fetched and decompressed when first asked for, and kept. */
export function viewReader({ views, buffers }: GltfDocument, sources: Sources): ReadView {
  const readBuffer = memoized(async (index: number) => {
    const { uri, byteLength } = buffers[index] ?? { uri: undefined, byteLength: 0 };
    const bytes = await bufferBytes(index, uri, sources);
    if (bytes.byteLength < byteLength) {
      throw new Flaw(
        `is cut short: ${bytes.byteLength} of ${byteLength} bytes of its buffer ${index} are there`,
      );
    }
    return bytes;
  });
  return memoized(async (index) => {
    const view = views[index];
    if (!view) throw new Flaw(`is broken: it has no bufferViews[${index}]`);
    const buffer = await readBuffer(view.buffer);
    const { byteOffset, byteLength, meshopt } = view;
    if (!meshopt) return buffer.subarray(byteOffset, byteOffset + byteLength);
    const source = buffer.subarray(byteOffset, byteOffset + meshopt.byteLength);
    return sources.decoders.meshopt(source, meshopt);
  });
}

async function bufferBytes(
  index: number,
  uri: string | undefined,
  { binary, resolve, signal }: Sources,
): Promise<Uint8Array<ArrayBuffer>> {
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

/** A name for a part of a file, short enough for a sentence. */
export function nameOf(uri: string): string {
  return uri.startsWith("data:") ? "embedded data" : (uri.split("/").pop() ?? uri);
}
