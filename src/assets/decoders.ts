import { LoadingManager, RGBAFormat } from "three";
import type { DRACOLoader } from "three/examples/jsm/loaders/DRACOLoader.js";
import type { KTX2Loader } from "three/examples/jsm/loaders/KTX2Loader.js";
import { Flaw } from "./asset-error.js";
import type { MeshoptCompression } from "./gltf-accessors.js";
import type { TextureImage } from "./model.js";

/** Timeout of a decoder's worker: one that has not answered by then has crashed. */
const PATIENCE = 20_000; // milliseconds

/** Longest side of an image that is decoded, and of the mipmap level that is taken from it. Pixels. */
const HUGE_SIDE = 8192;
const LONGEST_SIDE = 4096;

/** Decoders of one file, each imported and fetched when first needed. */
export class Decoders {
  readonly #base: URL;
  readonly #manager = new LoadingManager();
  #missing: string | null = null;
  #draco: Promise<DRACOLoader> | null = null;
  #ktx2: Promise<KTX2Loader> | null = null;

  /** @param base where the decoders' own files lie */
  constructor(base: URL, signal: AbortSignal) {
    this.#base = base;
    this.#manager.onError = (url) => {
      this.#missing = url;
    };
    signal.addEventListener("abort", () => this.#manager.abort(), { once: true });
  }

  draco(): Promise<DRACOLoader> {
    this.#draco ??= import("three/examples/jsm/loaders/DRACOLoader.js").then(({ DRACOLoader }) => {
      const path = (file: string) => new URL(file, this.#base).href;
      return new DRACOLoader(this.#manager).setWorkerLimit(1).setDecoderPath({
        js: path("draco_wasm_wrapper.js"),
        wasm: path("draco_decoder.wasm"),
      });
    });
    return this.#draco;
  }

  async meshopt(
    source: Uint8Array,
    { count, byteStride, mode, filter }: MeshoptCompression,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const { MeshoptDecoder } = await import("three/examples/jsm/libs/meshopt_decoder.module.js");
    await MeshoptDecoder.ready;
    const target = new Uint8Array(count * byteStride);
    try {
      MeshoptDecoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
    } catch (cause) {
      throw new Flaw("holds meshopt data that cannot be decoded", { cause });
    }
    return target;
  }

  /** A KTX2 image as plain pixels: the largest of its levels that is not too large. */
  async ktx2(bytes: Uint8Array<ArrayBuffer>): Promise<TextureImage> {
    checkSize(bytes);
    this.#ktx2 ??= import("three/examples/jsm/loaders/KTX2Loader.js").then(({ KTX2Loader }) => {
      const loader = new KTX2Loader(this.#manager).setWorkerLimit(1);
      loader.setTranscoderPath(this.#base.href);
      // Without compressed formats the transcoder returns RGBA.
      const plain = { extensions: { has: () => false } };
      return loader.detectSupport(plain as never);
    });
    const loader = await this.#ktx2;
    const { image, mipmaps, format } = await withTimeout(
      new Promise<PlainTexture>((resolve, reject) => {
        // A copy: the buffer is transferred to the transcoder's worker.
        loader.parse(bytes.slice().buffer, (made) => resolve(made as never), reject);
      }),
    ).catch((cause: unknown) => {
      throw this.failure("is KTX2 that cannot be decoded", cause);
    });
    for (const [level, { data }] of (format === RGBAFormat ? (mipmaps ?? []) : []).entries()) {
      // Not its own width, which three rounds up to whole blocks.
      const width = Math.max(1, image.width >> level);
      const height = Math.max(1, image.height >> level);
      const isLast = level === (mipmaps?.length ?? 0) - 1;
      if (!isLast && Math.max(width, height) > LONGEST_SIDE) continue;
      if (data instanceof Uint8Array && data.byteLength === width * height * 4) {
        return { width, height, data };
      }
    }
    throw new Flaw("is KTX2, but not of Basis Universal");
  }

  /** Why something was not decoded: it cannot be, or its decoder is missing. */
  failure(reason: string, cause: unknown): Flaw {
    if (cause instanceof Flaw) return cause;
    if (this.#missing === null) return new Flaw(reason, { cause });
    return new Flaw(`needs a decoder that could not be fetched: ${this.#missing}`, { cause });
  }

  dispose(): void {
    this.#draco?.then((loader) => loader.dispose()).catch(() => {});
    this.#ktx2?.then((loader) => loader.dispose()).catch(() => {});
  }
}

/** KTX 2.0 specification, section 2: the size stands at bytes 20 and 24. */
function checkSize(bytes: Uint8Array<ArrayBuffer>): void {
  if (bytes.byteLength < 80) throw new Flaw("is cut short");
  const header = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [width, height] = [header.getUint32(20, true), header.getUint32(24, true)];
  if (Math.max(width, height) > HUGE_SIDE) {
    throw new Flaw(`is too large: ${width} x ${height} pixels, where ${HUGE_SIDE} are the limit`);
  }
}

/** KTX2 texture; three's own type is too narrow. */
interface PlainTexture {
  readonly image: { readonly width: number; readonly height: number };
  readonly mipmaps: readonly { readonly data: unknown }[] | undefined;
  readonly format: number;
}

export function withTimeout<Value>(work: Promise<Value>): Promise<Value> {
  let timer = 0;
  const late = new Promise<never>((_, reject) => {
    timer = window.setTimeout(
      () => reject(new Flaw("is not decoded: its decoder does not answer")),
      PATIENCE,
    );
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}
