import { readFileSync } from "node:fs";
import { type ConsoleMessage, expect, type Page } from "playwright/test";
import { openGlb, packGlb } from "../../tools/models/glb-builder.mjs";
import type { Failure, Loaded, LoadedPart } from "./any-room-page.ts";
import { openSources, SOURCES } from "./sources.ts";

type InPage = typeof import("./any-room-page.ts");
const IN_PAGE = "/tests/support/any-room-page.ts";
const FIXTURES = new URL("../fixtures/models/", import.meta.url);

/** A file as some server gives it. */
export interface Served {
  readonly body: Uint8Array | string;
  readonly status?: number;
  readonly contentType?: string;
}

/** A page that loads models as the element does, and what it says meanwhile. */
export class AnyRoom {
  readonly page: Page;
  readonly console: { readonly type: string; readonly text: string }[] = [];
  /** Names of the decoders' files that were fetched. */
  readonly decoders: string[] = [];

  constructor(page: Page) {
    this.page = page;
    page.on("console", (message: ConsoleMessage) =>
      this.console.push({ type: message.type(), text: message.text() }),
    );
    page.on("request", (request) => {
      const [, file] = request.url().split("/decoders/");
      if (file) this.decoders.push(file);
    });
  }

  static async open(page: Page, policy?: string): Promise<AnyRoom> {
    // The empty page comes from no address, so that Chromium takes other servers here for foreign.
    await page.context().grantPermissions(["local-network-access"]);
    await openSources(page, policy);
    return new AnyRoom(page);
  }

  /** Loads a model that must be readable. */
  async load(url: string): Promise<Loaded> {
    const loaded = await this.try(url);
    if (!("parts" in loaded)) throw new Error(`${loaded.name}: ${loaded.message}`);
    return loaded;
  }

  /** Loads a model, or tells why not. */
  try(url: string, decoderBase?: string): Promise<Loaded | Failure> {
    return this.page.evaluate(
      async ({ module, url, decoderBase }) => {
        const { load }: InPage = await import(module);
        return load(url, decoderBase);
      },
      { module: IN_PAGE, url, decoderBase },
    );
  }

  glossyMaterials(url: string): Promise<string[]> {
    return this.page.evaluate(
      async ({ module, url }) => {
        const { glossyMaterials }: InPage = await import(module);
        return glossyMaterials(url);
      },
      { module: IN_PAGE, url },
    );
  }

  /** The sentence that a file is refused with. */
  async refusal(url: string, decoderBase?: string): Promise<string> {
    const result = await this.try(url, decoderBase);
    return "message" in result ? `${result.name}: ${result.message}` : "loaded";
  }

  loadAndAbort(url: string, atShare: number): Promise<Failure | "loaded"> {
    return this.page.evaluate(
      async ({ module, url, atShare }) => {
        const { loadAndAbort }: InPage = await import(module);
        return loadAndAbort(url, atShare);
      },
      { module: IN_PAGE, url, atShare },
    );
  }

  fuzz(url: string, seed: number, count: number) {
    return this.page.evaluate(
      async ({ module, url, seed, count }) => {
        const { fuzz }: InPage = await import(module);
        return fuzz(url, seed, count);
      },
      { module: IN_PAGE, url, seed, count },
    );
  }

  leftovers() {
    return this.page.evaluate(async (module) => {
      const { leftovers }: InPage = await import(module);
      return leftovers();
    }, IN_PAGE);
  }

  /** Asserts that every error was caught, every picture closed, and every decoder ended. */
  async expectTidy(): Promise<void> {
    const { bitmaps, strays } = await this.leftovers();
    expect(strays, "errors that nobody caught").toEqual([]);
    expect(bitmaps, "pictures that nobody closed").toBe(0);
    await expect.poll(() => this.page.workers().length, "decoders that nobody ended").toBe(0);
  }

  /** Puts a file on the server and gives its address. */
  async serve(name: string, { body, status = 200, contentType }: Served): Promise<string> {
    const url = `${SOURCES}rooms/${name}`;
    await this.page.unroute(url);
    await this.page.route(url, (route) =>
      route.fulfill({
        status,
        contentType: contentType ?? "model/gltf-binary",
        body: typeof body === "string" ? body : Buffer.from(body),
      }),
    );
    return url;
  }
}

export const fixtureUrl = (name: string) => `${SOURCES}tests/fixtures/models/${name}`;

export const fixture = (name: string): Buffer => readFileSync(new URL(name, FIXTURES));

// biome-ignore lint/suspicious/noExplicitAny: a file's JSON, to be spoilt in any way.
export type Json = any;

/** A .glb taken apart, to be changed. */
export function opened(name: string): { json: Json; binary: Buffer } {
  return openGlb(fixture(name));
}

/** A .glb with its JSON changed. */
export function edited(name: string, change: (json: Json) => void): Buffer {
  const { json, binary } = opened(name);
  change(json);
  return packGlb(json, binary);
}

/** All that a part says of the vertices at a place. */
export function verticesAt(part: LoadedPart, place: readonly number[], tolerance = 1e-3) {
  const vertices: { normal: number[]; tangent: number[]; uv: number[]; color: number[] | null }[] =
    [];
  for (let i = 0; i < part.positions.length / 3; i++) {
    const position = part.positions.slice(i * 3, i * 3 + 3);
    if (position.some((x, k) => Math.abs(x - (place[k] ?? 0)) > tolerance)) continue;
    vertices.push({
      normal: part.normals.slice(i * 3, i * 3 + 3),
      tangent: part.tangents.slice(i * 4, i * 4 + 4),
      uv: part.uvs.slice(i * 2, i * 2 + 2),
      color: part.colors?.slice(i * 4, i * 4 + 4) ?? null,
    });
  }
  return vertices;
}

/** Normals of the triangles themselves, by the order of their corners, each of length 1. */
export function facings({ positions, indices }: LoadedPart): number[][] {
  const at = (i: number) => positions.slice((indices[i] ?? 0) * 3, (indices[i] ?? 0) * 3 + 3);
  return Array.from({ length: indices.length / 3 }, (_, t) => {
    const [a, b, c] = [at(t * 3), at(t * 3 + 1), at(t * 3 + 2)];
    const [u, v] = [b, c].map((corner) => corner.map((x, k) => x - (a[k] ?? 0)));
    const cross = [0, 1, 2].map((k) => {
      const [m, n] = [(k + 1) % 3, (k + 2) % 3];
      return (u?.[m] ?? 0) * (v?.[n] ?? 0) - (u?.[n] ?? 0) * (v?.[m] ?? 0);
    });
    const length = Math.hypot(...cross);
    return cross.map((x) => x / length);
  });
}
