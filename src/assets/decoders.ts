import { LoadingManager, RGBAFormat } from "three";
import type { DRACOLoader } from "three/examples/jsm/loaders/DRACOLoader.js";
import type { KTX2Loader } from "three/examples/jsm/loaders/KTX2Loader.js";
import { Flaw } from "./asset-error.js";
import { cannotRun, DecoderJobs } from "./decoder-jobs.js";
import type { MeshoptCompression } from "./gltf-accessors.js";
import type { TextureImage } from "./model.js";
import { LONGEST_SIDE } from "./texture-images.js";

/** Longest side of an image that is decoded, pixels: of its mipmap levels a smaller one is taken, where there is one. */
const HUGE_SIDE = 8192;

/** Decoders of one file, each imported and fetched when first needed. */
export class Decoders {
  readonly #base: URL;
  readonly #manager = new LoadingManager();
  readonly #jobs = { draco: new DecoderJobs(), ktx2: new DecoderJobs() };
  readonly #loaders: { dispose(): unknown }[] = [];
  #isDisposed = false;
  #missing: string | null = null;
  #draco: Promise<DRACOLoader> | null = null;
  #ktx2: Promise<KTX2Loader> | null = null;

  /** @param base where the decoders' own files lie */
  constructor(base: URL) {
    this.#base = base;
    this.#manager.onError = (url) => {
      this.#missing = url;
    };
  }

  draco(): Promise<DRACOLoader> {
    this.#draco ??= this.#start(async () => {
      const { DRACOLoader } = await import("three/examples/jsm/loaders/DRACOLoader.js").catch(
        missed,
      );
      const path = (file: string) => new URL(file, this.#base).href;
      const loader = new DRACOLoader(this.#manager).setWorkerLimit(1).setDecoderPath({
        js: path("draco_wasm_wrapper.js"),
        wasm: path("draco_decoder.wasm"),
      });
      const inside = loader as unknown as DracoInside;
      const decode = inside.decodeGeometry.bind(loader);
      inside.decodeGeometry = (...job) => this.#jobs.draco.run(() => decode(...job));
      // The first of no jobs makes the worker.
      return { loader, worker: () => inside._getWorker(0, 0), jobs: this.#jobs.draco };
    });
    return this.#draco;
  }

  async meshopt(
    source: Uint8Array,
    { count, byteStride, mode, filter }: MeshoptCompression,
  ): Promise<Uint8Array<ArrayBuffer>> {
    const { MeshoptDecoder } = await import(
      "three/examples/jsm/libs/meshopt_decoder.module.js"
    ).catch(missed);
    await MeshoptDecoder.ready.catch((cause: unknown) => {
      throw cannotRun(cause);
    });
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
    this.#ktx2 ??= this.#start(async () => {
      const { KTX2Loader } = await import("three/examples/jsm/loaders/KTX2Loader.js").catch(missed);
      const loader = new KTX2Loader(this.#manager).setWorkerLimit(1);
      loader.setTranscoderPath(this.#base.href);
      // Without compressed formats the transcoder returns RGBA.
      loader.detectSupport({ extensions: { has: () => false } } as never);
      const worker = async () => {
        await loader.init();
        loader.workerPool._initWorker(0);
        return loader.workerPool.workers[0] as Worker;
      };
      return { loader, worker, jobs: this.#jobs.ktx2 };
    });
    const loader = await this.#ktx2;
    const decode = () =>
      new Promise<PlainTexture>((resolve, reject) => {
        // A copy: the buffer is transferred to the transcoder's worker.
        loader.parse(bytes.slice().buffer, (made) => resolve(made as never), reject);
      });
    const { image, mipmaps, format } = await this.#jobs.ktx2.run(decode).catch((cause: unknown) => {
      throw failure("is KTX2 that cannot be decoded", cause);
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

  /** Fetches a decoder and starts its worker, which `dispose` ends whenever it is called. */
  async #start<Loader extends { dispose(): unknown }>(
    create: () => Promise<{
      readonly loader: Loader;
      readonly worker: () => Promise<Worker>;
      readonly jobs: DecoderJobs;
    }>,
  ): Promise<Loader> {
    const { loader, worker, jobs } = await create();
    try {
      if (!this.#isDisposed) jobs.watch(await worker());
    } catch (cause) {
      if (this.#missing === null) throw cannotRun(cause);
      throw new Flaw(`needs a decoder that could not be fetched: ${this.#missing}`, { cause });
    } finally {
      if (this.#isDisposed) loader.dispose();
      else this.#loaders.push(loader);
    }
    return loader;
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#manager.abort();
    for (const jobs of Object.values(this.#jobs)) jobs.end();
    for (const loader of this.#loaders) loader.dispose();
  }
}

/** Why something was not decoded. */
export function failure(reason: string, cause: unknown): Flaw {
  return cause instanceof Flaw ? cause : new Flaw(reason, { cause });
}

/** Of a decoder's own chunk. */
function missed(cause: unknown): never {
  throw new Flaw("needs a decoder that could not be fetched", { cause });
}

/** Of three's loader, which its types leave out. */
interface DracoInside {
  _getWorker(job: number, cost: number): Promise<Worker>;
  decodeGeometry(buffer: ArrayBuffer, task: object): Promise<unknown>;
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
