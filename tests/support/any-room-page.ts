import { loadModel } from "../../src/assets/load-model.ts";
import { closeModel, type Model, type Part, type TextureImage } from "../../src/assets/model.ts";
import { pcg } from "../../src/world/random.ts";

/** What tests in Node see of a model loaded in the page: all arrays as plain numbers. */
export interface LoadedPart {
  readonly name: string;
  readonly positions: number[];
  readonly normals: number[];
  readonly tangents: number[];
  readonly uvs: number[];
  readonly colors: number[] | null;
  readonly indices: number[];
  readonly material: LoadedMaterial;
}

type Maps = "albedo" | "normal" | "occlusionRoughnessMetallic";
export type LoadedMaterial = Omit<Part["material"], Maps> & Record<Maps, LoadedPicture | null>;

/** A picture by two of its pixels. */
export interface LoadedPicture {
  readonly width: number;
  readonly height: number;
  readonly kind: string;
  readonly left: number[];
  readonly right: number[];
}

export type Loaded = Omit<Model, "parts"> & {
  readonly parts: LoadedPart[];
  readonly shares: number[];
};

export interface Failure {
  readonly name: string;
  readonly message: string;
}

const openBitmaps = new Set<ImageBitmap>();
const decode = window.createImageBitmap.bind(window) as (...all: unknown[]) => Promise<ImageBitmap>;
window.createImageBitmap = (async (...all: unknown[]) => {
  const bitmap = await decode(...all);
  openBitmaps.add(bitmap);
  return bitmap;
}) as typeof window.createImageBitmap;
const close = ImageBitmap.prototype.close;
ImageBitmap.prototype.close = function (this: ImageBitmap) {
  openBitmaps.delete(this);
  close.call(this);
};

const strays: string[] = [];
window.addEventListener("unhandledrejection", ({ reason }) => strays.push(`promise: ${reason}`));
window.addEventListener("error", ({ message }) => strays.push(`error: ${message}`));

/** Pictures that nobody has closed, and errors that nobody has caught. */
export async function leftovers(): Promise<{ bitmaps: number; strays: string[] }> {
  await new Promise((resolve) => setTimeout(resolve)); // unhandled rejections are told a task later
  return { bitmaps: openBitmaps.size, strays };
}

const DECODERS = new URL("/decoders/", window.location.href);
const never = new AbortController().signal;

export async function load(url: string, decoderBase = DECODERS.href): Promise<Loaded | Failure> {
  const shares: number[] = [];
  try {
    const onProgress = (share: number) => shares.push(share);
    const model = await loadModel(url, { signal: never, onProgress, decoderBase });
    const parts = await Promise.all(model.parts.map(summary));
    closeModel(model);
    return { ...model, parts, shares };
  } catch (error) {
    return failure(error);
  }
}

const failure = (error: unknown): Failure => {
  const { name, message } = error instanceof Error ? error : new Error(String(error));
  return { name, message };
};

async function summary(part: Part): Promise<LoadedPart> {
  const { material, colors } = part;
  const [albedo, normal, occlusionRoughnessMetallic] = [
    pixels(material.albedo),
    pixels(material.normal),
    pixels(material.occlusionRoughnessMetallic),
  ];
  return {
    name: part.name,
    positions: [...part.positions],
    normals: [...part.normals],
    tangents: [...part.tangents],
    uvs: [...part.uvs],
    colors: colors && [...colors],
    indices: [...part.indices],
    material: { ...material, albedo, normal, occlusionRoughnessMetallic },
  };
}

function pixels(picture: TextureImage | null): LoadedPicture | null {
  if (!picture) return null;
  const { width, height } = picture;
  const data = "data" in picture ? picture.data : drawn(picture);
  const at = (x: number) => {
    const pixel = (Math.floor(height / 2) * width + Math.floor(x)) * 4;
    return [...data.subarray(pixel, pixel + 4)];
  };
  const kind = "data" in picture ? "pixels" : "bitmap";
  return { width, height, kind, left: at(width / 4), right: at((3 * width) / 4) };
}

function drawn(picture: ImageBitmap): Uint8ClampedArray {
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("no 2D canvas");
  context.drawImage(picture, 0, 0);
  return context.getImageData(0, 0, picture.width, picture.height).data;
}

/** Names of a model's glossy materials, in order. */
export async function glossyMaterials(url: string): Promise<string[]> {
  const model = await loadModel(url, { signal: never, onProgress() {}, decoderBase: DECODERS });
  closeModel(model);
  const glossy = model.parts.filter(({ material }) => material.isGlossy);
  return [...new Set(glossy.map(({ material }) => material.name))].toSorted();
}

/** Begins to load, aborts at a moment of its progress, and tells what the promise then said. */
export async function loadAndAbort(url: string, atShare: number): Promise<Failure | "loaded"> {
  const controller = new AbortController();
  const abort = () => controller.abort(new Error("changed my mind"));
  if (atShare === 0) window.setTimeout(abort, 20);
  try {
    const onProgress = (share: number) => {
      if (atShare > 0 && share >= atShare) abort();
    };
    await loadModel(url, { signal: controller.signal, onProgress, decoderBase: DECODERS });
    return "loaded";
  } catch (error) {
    return failure(error);
  }
}

export interface FuzzReport {
  readonly loaded: number;
  readonly refused: number;
  /** Milliseconds of the slowest. */
  readonly slowest: number;
  /** Rejections that are no AssetError, and sentences that do not read as one. */
  readonly odd: string[];
}

/** Loads damaged copies of a .glb: cut short, with bytes changed, with lies in its JSON. */
export async function fuzz(url: string, seed: number, count: number): Promise<FuzzReport> {
  const original = new Uint8Array(await (await fetch(url)).arrayBuffer());
  const report = { loaded: 0, refused: 0, slowest: 0, odd: [] as string[] };
  for (let i = 0; i < count; i++) {
    const address = URL.createObjectURL(new Blob([damaged(original, seed, i)]));
    const { refusal, milliseconds } = await attempt(address);
    if (!refusal) report.loaded++;
    else {
      report.refused++;
      const { name, message } = refusal;
      if (name !== "AssetError" || !/^The (model|texture) .*\.$/.test(message)) {
        report.odd.push(`${i}: ${name}: ${message}`);
      }
    }
    let least = milliseconds;
    // What is slow is slow each time; other programs may have had the processor this time.
    for (let again = 0; again < 2 && least > report.slowest; again++) {
      least = Math.min(least, (await attempt(address)).milliseconds);
    }
    report.slowest = Math.max(report.slowest, least);
    URL.revokeObjectURL(address);
  }
  return report;
}

async function attempt(
  address: string,
): Promise<{ refusal: Failure | null; milliseconds: number }> {
  const begin = performance.now();
  const options = { signal: never, onProgress: () => {}, decoderBase: DECODERS };
  let refusal: Failure | null = null;
  try {
    closeModel(await loadModel(address, options));
  } catch (error) {
    refusal = failure(error);
  }
  return { refusal, milliseconds: performance.now() - begin };
}

type Random = (draw: number, below: number) => number;

function damaged(original: Uint8Array<ArrayBuffer>, seed: number, i: number) {
  const random: Random = (draw, below) => pcg(seed + i * 64 + draw) % below;
  if (i % 4 === 0) return original.slice(0, random(0, original.length));
  if (i % 4 === 1) {
    const bytes = original.slice(0, 20 + random(0, original.length - 20));
    new DataView(bytes.buffer).setUint32(8, bytes.length, true);
    return bytes;
  }
  if (i % 4 === 2) {
    const bytes = original.slice();
    for (let flip = 0; flip <= random(1, 8); flip++) {
      bytes[random(2 + flip * 2, bytes.length)] = random(3 + flip * 2, 256);
    }
    return bytes;
  }
  return withLies(original, random);
}

const LIES = [null, true, -1, 0, 1, 3, 5123, 0.5, 1e9, 1e300, "", "a", [], [0], [1e9], {}, [{}]];

/** A .glb with a few values of its JSON replaced, and true lengths. */
function withLies(glb: Uint8Array<ArrayBuffer>, random: Random): Uint8Array<ArrayBuffer> {
  const length = new DataView(glb.buffer).getUint32(12, true);
  const json: object = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
  for (let lie = 0; lie <= random(1, 2); lie++) {
    const places = placesIn(json);
    const [object, key] = places[random(2 + lie * 2, places.length)] ?? [{}, ""];
    object[key] = structuredClone(LIES[random(3 + lie * 2, LIES.length)]);
  }
  const text = JSON.stringify(json);
  const chunk = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
  const rest = glb.subarray(20 + length);
  const bytes = new Uint8Array(20 + chunk.length + rest.length);
  bytes.set(glb.subarray(0, 20));
  bytes.set(chunk, 20);
  bytes.set(rest, 20 + chunk.length);
  new DataView(bytes.buffer).setUint32(8, bytes.length, true);
  new DataView(bytes.buffer).setUint32(12, chunk.length, true);
  return bytes;
}

function placesIn(value: unknown): [Record<string, unknown>, string][] {
  if (typeof value !== "object" || value === null) return [];
  const object = value as Record<string, unknown>;
  return Object.keys(object).flatMap((key) => [[object, key], ...placesIn(object[key])]);
}
