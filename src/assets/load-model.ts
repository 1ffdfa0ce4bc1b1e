import { assetError, Flaw } from "./asset-error.js";
import { viewReader } from "./buffer-bytes.js";
import { Decoders } from "./decoders.js";
import { fetchBytes } from "./fetch-bytes.js";
import { openContainer } from "./glb.js";
import { type GltfDocument, readDocument } from "./gltf-document.js";
import type { Model, TextureImage } from "./model.js";
import { type PlacedMaterial, readMaterial } from "./read-material.js";
import { readScene } from "./read-scene.js";
import { readWarnings } from "./read-warnings.js";
import { TextureImages } from "./texture-images.js";
import { buildScene } from "./three-scene.js";

export interface LoadOptions {
  readonly signal: AbortSignal;
  /** Called with the share done, 0 to 1. */
  readonly onProgress: (progress: number) => void;
  /** Whether it is to be a candle alone, whose wax and glass are drawn as such. */
  readonly isCandle?: boolean;
  /** Absolute URL where the decoders for Draco and KTX2 lie, with a slash at the end. */
  readonly decoderBase: string | URL;
  /** Decoded images by address; models that are loaded together share theirs. */
  readonly sharedImages?: Map<string, Promise<TextureImage>>;
}

/** Share of the progress that the bytes of the model file take. */
const FILE_SHARE = 0.3;

/**
 * Fetches and decodes a glTF file, its buffers and its images. Rejects with an `AssetError` that
 * names the file, or with the signal's reason; then nothing is left open.
 */
export async function loadModel(url: string, options: LoadOptions): Promise<Model> {
  const { signal } = options;
  const file = fileName(url);
  try {
    signal.throwIfAborted();
    const model = await load(url, file, options);
    if (model.warnings.length > 0) console.warn(`${file}: ${model.warnings.join(" ")}`);
    return model;
  } catch (error) {
    signal.throwIfAborted();
    throw assetError(file, error);
  }
}

async function load(url: string, file: string, options: LoadOptions): Promise<Model> {
  const { signal, onProgress, isCandle = false, decoderBase } = options;
  const address = addressOf(url, window.location.href);
  let base = address.href;
  const bytes = await fetchBytes(address, {
    signal,
    onAddress: (answered) => {
      base = answered;
    },
    onProgress: (progress) => onProgress(progress * FILE_SHARE),
  });
  const { json, binary } = openContainer(bytes);
  const document = readDocument(json);
  const decoders = new Decoders(new URL(decoderBase));
  const resolve = (uri: string) => addressOf(uri, base);
  const shared = options.sharedImages ?? new Map();
  const sources = { file, binary, decoders, resolve, signal, shared };
  const readView = viewReader(document, sources);
  const images = new TextureImages(document, readView, sources);
  const used = usedMaterials(document);
  const report = stages(used.length, onProgress);
  try {
    const warnings = new Set(readWarnings(document, isCandle));
    const [materials, scene] = await orAborted(
      Promise.all([
        readMaterials(document, used, { images, warnings, report }),
        buildScene(document, readView, decoders).finally(report),
      ]),
      signal,
    );
    const read = readScene(scene, materials, warnings, isCandle);
    onProgress(1);
    signal.throwIfAborted();
    return { ...read, warnings: [...warnings, ...images.warnings] };
  } catch (error) {
    images.close();
    throw error;
  } finally {
    decoders.dispose();
  }
}

async function readMaterials(
  document: GltfDocument,
  used: readonly number[],
  to: { images: TextureImages; warnings: Set<string>; report: () => void },
): Promise<Map<string, PlacedMaterial>> {
  const materials = new Map<string, PlacedMaterial>();
  const readOne = async (index: number) => {
    const entry = document.materials[index];
    if (entry) {
      materials.set(String(index), await readMaterial(document, entry, to.images, to.warnings));
    }
    to.report();
  };
  await Promise.all(used.map(readOne));
  return materials;
}

/** Those of the scene that is shown. */
function usedMaterials({ meshes, nodes, shown }: GltfDocument): number[] {
  const primitives = shown.flatMap((node) => meshes[nodes[node]?.mesh ?? -1]?.primitives ?? []);
  const used = new Set(primitives.map(({ material }) => material));
  return [...used].filter((material) => material !== undefined);
}

/** Progress after the file's share: a step for each material, and one for the geometry. */
function stages(materials: number, onProgress: (progress: number) => void): () => void {
  const count = materials + 2;
  let done = 0;
  return () => {
    done++;
    onProgress(FILE_SHARE + (1 - FILE_SHARE) * (done / count));
  };
}

/** Rejects as soon as the signal aborts, since decoders cannot be stopped. */
function orAborted<Value>(work: Promise<Value>, signal: AbortSignal): Promise<Value> {
  return new Promise((resolve, reject) => {
    const abort = () => reject(signal.reason);
    if (signal.aborted) abort();
    signal.addEventListener("abort", abort, { once: true });
    work.then(resolve, reject).finally(() => signal.removeEventListener("abort", abort));
  });
}

function addressOf(url: string, base: string): URL {
  try {
    return new URL(url, base);
  } catch (cause) {
    throw new Flaw(`has an address that is none: ${url.slice(0, 80)}`, { cause });
  }
}

function fileName(url: string): string {
  if (/^(data|blob):/.test(url)) return "The model";
  const path = url.split(/[?#]/)[0] ?? "";
  const last = path.split("/").filter(Boolean).pop() ?? url;
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}
