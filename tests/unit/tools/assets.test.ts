import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import validator from "gltf-validator";
import sharp from "sharp";
import { describe, expect, test } from "vitest";
import { WORLD_SETUPS } from "../../../src/world/world-setup.ts";
import { openGlb } from "../../../tools/models/glb-builder.mjs";
import { textureSet } from "../../../tools/textures/texture-set.mjs";

interface Entry {
  readonly bytes: number;
  readonly sha256: string;
}

interface Manifest {
  readonly textures: Readonly<
    Record<string, { seed: number; size: number; tile: number; files: Record<string, Entry> }>
  >;
  readonly models: Readonly<
    Record<string, Entry & { readonly triangles: number; readonly reducedTriangles?: number }>
  >;
}

const PUBLIC = new URL("../../../public/", import.meta.url);
const FIXTURES = new URL("../../fixtures/", import.meta.url);
const CHANNELS = ["albedo", "normal", "orm"] as const;

const manifest: Manifest = JSON.parse(readFileSync(new URL("manifest.json", PUBLIC), "utf8"));
const textureFiles = Object.assign(
  {},
  ...Object.values(manifest.textures).map(({ files }) => files),
) as Record<string, Entry>;

/** What a file weighs, and its hash. */
function entryOf(file: URL): Entry {
  const bytes = readFileSync(file);
  return { bytes: bytes.length, sha256: createHash("sha256").update(bytes).digest("hex") };
}

/** Chroma subsampling of an AVIF picture: two bits of its `av1C` box (AV1-ISOBMFF 2.3.3). */
function chromaOf(file: URL): string {
  const bytes = readFileSync(file);
  const flags = bytes[bytes.indexOf("av1C", 0, "latin1") + 6] ?? 0xff;
  return (flags & 0b1100) === 0 ? "4:4:4" : "subsampled";
}

const namesIn = (folder: string) => readdirSync(new URL(folder, PUBLIC)).toSorted();

describe("A texture set made again", () => {
  const made = textureSet("plaster", 256);

  test.each(CHANNELS)("has the %s that it had", async (channel) => {
    const file = fileURLToPath(new URL(`plaster-256-${channel}.png`, FIXTURES));
    const { data, info } = await sharp(file).removeAlpha().raw().toBuffer({
      resolveWithObject: true,
    });
    expect([info.width, info.height]).toEqual([made.resolution, made.resolution]);
    expect(made[channel]).toHaveLength(data.length);
    // Sines and powers differ in their last bit between machines; a step of 8 bits hides no more.
    const errors = Array.from(data, (value, i) => Math.abs(value - (made[channel][i] ?? 0)));
    expect(errors.reduce((most, error) => Math.max(most, error), 0)).toBeLessThanOrEqual(3);
    expect(errors.reduce((sum, error) => sum + error, 0) / errors.length).toBeLessThan(0.05);
    expect(new Set(data).size, "values that occur").toBeGreaterThan(20);
  });

  test("is the same each time, and of another material another", () => {
    const stone = textureSet("stone", 64);
    expect(textureSet("stone", 64)).toEqual(stone);
    expect(textureSet("plaster", 64).normal).not.toEqual(stone.normal);
  });
});

describe("The manifest", () => {
  test("lists every texture and model that is shipped, and nothing else", () => {
    expect(Object.keys(textureFiles).toSorted()).toEqual(namesIn("textures/"));
    expect(Object.keys(manifest.models).toSorted()).toEqual(namesIn("models/"));
  });

  test.each(Object.keys(manifest.textures))("knows what the textures of %s weigh", (name) => {
    const { files, seed, size, tile } = manifest.textures[name] ?? { files: {} };
    const expected = CHANNELS.map((channel) => `${name}-${channel}.avif`);
    expect(Object.keys(files)).toEqual(expected);
    for (const [file, entry] of Object.entries(files)) {
      expect(entryOf(new URL(`textures/${file}`, PUBLIC)), file).toEqual(entry);
    }
    expect(Number.isInteger(seed)).toBe(true);
    expect([256, 512, 1024]).toContain(size);
    expect(tile).toBeGreaterThan(0.1);
  });

  test.each(Object.keys(manifest.models))("knows what %s weighs", (name) => {
    const { bytes, sha256 } = manifest.models[name] ?? {};
    expect(entryOf(new URL(`models/${name}`, PUBLIC))).toEqual({ bytes, sha256 });
  });
});

describe("What is shipped stays within its budget:", () => {
  const total = (names: readonly string[]) =>
    names.reduce((sum, name) => sum + (textureFiles[name]?.bytes ?? Number.NaN), 0);
  const avifs = Object.keys(textureFiles);

  test("2.4 MB of textures", () => {
    expect(avifs).toHaveLength(Object.keys(manifest.textures).length * CHANNELS.length);
    expect(total(avifs)).toBeLessThanOrEqual(2.4e6);
  });

  test("512 texels along an edge of what changes slowly, and a set's own size of all else", async () => {
    for (const file of Object.keys(textureFiles)) {
      const [, name = "", channel] = /^(.*)-(albedo|normal|orm)\./.exec(file) ?? [];
      const size = manifest.textures[name]?.size ?? 0;
      const { width, height } = await sharp(
        fileURLToPath(new URL(`textures/${file}`, PUBLIC)),
      ).metadata();
      const expected = channel === "orm" ? Math.min(size, 512) : size;
      expect([width, height], file).toEqual([expected, expected]);
    }
  });

  test("64 000 triangles in the room with its four candles", () => {
    const { "cabin.glb": cabin, "chamberstick.glb": candle } = manifest.models;
    const triangles = (cabin?.triangles ?? 0) + (candle?.triangles ?? 0);
    expect(cabin?.triangles).toBeGreaterThan(20_000);
    expect(triangles).toBeLessThanOrEqual(64_000);
  });

  test("the flame of the chamberstick where the carried candle burns", () => {
    const { json } = openGlb(readFileSync(new URL("models/chamberstick.glb", PUBLIC)));
    const flame = json.nodes.find(({ name }: { name: string }) => name === "flame");
    for (const [axis, at] of WORLD_SETUPS.physical.wick.entries()) {
      expect(flame.translation[axis]).toBeCloseTo(at, 4);
    }
  });

  test("half of the triangles in their lower level of detail", () => {
    for (const name of ["cabin.glb", "chamberstick.glb"]) {
      const { triangles = 0, reducedTriangles = triangles } = manifest.models[name] ?? {};
      expect(reducedTriangles).toBeLessThan(triangles / 2);
      expect(reducedTriangles).toBeGreaterThan(triangles / 20);
    }
  });

  test("colours at full resolution in whatever carries slopes or roughness", () => {
    const carriers = Object.keys(textureFiles).filter((name) => /-(normal|orm)\./.test(name));
    expect(carriers.length).toBeGreaterThan(0);
    for (const name of carriers) {
      expect(chromaOf(new URL(`textures/${name}`, PUBLIC)), name).toBe("4:4:4");
    }
  });
});

describe("The glTF validator finds no error in", () => {
  test.each(Object.keys(manifest.models))(
    "%s",
    async (name) => {
      const file = new URL(`models/${name}`, PUBLIC);
      const used: string[] = [];
      const { issues, info } = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
        uri: name,
        externalResourceFunction: async (uri) => {
          const resource = new URL(uri, file);
          if (!existsSync(resource)) throw new Error(`${uri} is missing`);
          used.push(uri);
          return new Uint8Array(readFileSync(resource));
        },
      });
      const problems = issues.messages.filter(({ severity }) => severity === 0);
      expect(problems).toEqual([]);
      expect(issues.numErrors).toBe(0);
      expect(info.totalTriangleCount).toBe(manifest.models[name]?.triangles);
      for (const uri of used) expect(Object.keys(textureFiles)).toContain(uri.split("/").at(-1));
    },
    60_000,
  );
});
