import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright/test";
import { SETTINGS } from "../../src/settings.ts";
import { resolveShader } from "../../tools/vite-glsl.ts";
import type { Drawn, ProgramReport } from "../support/programs.ts";
import { serveSmallTextures } from "../support/small-textures.ts";
import { openSources } from "../support/sources.ts";
import { expect, test } from "../support/test.ts";

type Programs = typeof import("../support/programs.ts");
const PROGRAMS = "/tests/support/programs.ts";
const SHADERS = "shaders";

/** Files that are a stage of their own, but for those of a refined image and of `auto`, whose own specs draw them. */
function stages(): string[] {
  return readdirSync(SHADERS, { recursive: true, encoding: "utf8" })
    .filter((file) => /\.(vert|frag)$/.test(file) && !/^(refinement|speed)\//.test(file))
    .sort();
}

function reportPrograms(page: Page, drawn: Drawn): Promise<ProgramReport[]> {
  return page.evaluate(
    async ({ module, drawn }) => {
      const { reportPrograms }: Programs = await import(module);
      return reportPrograms(drawn);
    },
    { module: PROGRAMS, drawn },
  );
}

/** Three numbers for each pixel of a square that a fragment shader draws, row by row. */
function drawnBy(page: Page, fragment: string, size: number): Promise<number[]> {
  return page.evaluate(
    async ({ module, vertex, fragment, size }) => {
      const { furnace }: typeof import("../support/furnace.ts") = await import(module);
      return furnace(vertex, fragment, size);
    },
    {
      module: "/tests/support/furnace.ts",
      vertex: resolveShader(join(SHADERS, "post/fullscreen.vert")),
      fragment: resolveShader(fragment),
      size,
    },
  );
}

interface Spread {
  readonly mean: number;
  readonly variance: number;
}

/** What the compiler says of the room's program with one line of one of its files replaced. */
function complaintAbout(page: Page, file: string, line: string, replacement: string) {
  const vertex = resolveShader(join(SHADERS, "paper/mesh.vert"));
  const fragment = resolveShader(join(SHADERS, "paper/room.frag"));
  const broken = { ...fragment, source: fragment.source.replace(line, replacement) };
  expect(broken.source, `${file} reads “${line}”`).not.toBe(fragment.source);
  return page.evaluate(
    async ({ module, vertex, broken }) => {
      const { complaintOf }: Programs = await import(module);
      return complaintOf(vertex, broken);
    },
    { module: PROGRAMS, vertex, broken },
  );
}

function lineNumber(file: string, line: string): number {
  return readFileSync(join(SHADERS, file), "utf8").split("\n").indexOf(line) + 1;
}

let page: Page;
test.beforeAll(async ({ browser }) => {
  page = await browser.newPage();
  await serveSmallTextures(page);
  await openSources(page);
});
test.afterAll(() => page.close());

test("Every shader compiles and links without warnings, and each of its uniforms is set", async () => {
  const views: readonly Drawn[] = [
    ...SETTINGS.look.choices.map((look) => ({ look })),
    { quality: "low" },
    { look: "paper", quality: "low" },
    { scene: "candle" },
    { scene: "candle", src: "/models/wreath.glb", quality: "low" },
    { scene: "candle", src: "/models/jar.glb" },
  ];
  const reports: ProgramReport[] = [];
  for (const view of views) reports.push(...(await reportPrograms(page, view)));
  // Made beforehand, but not drawn while nothing was refined.
  const drawn = reports.filter(({ label }) => !label.startsWith("refinement/"));
  for (const { label, log, unset, set } of drawn) {
    expect.soft({ label, log, unset }).toEqual({ label, log: "", unset: [] });
    expect.soft(set, label).toBeGreaterThan(0);
  }
  const compiled = new Set(drawn.flatMap((report) => report.stages));
  expect([...compiled].sort(), "no file lies idle").toEqual(stages());
});

for (const look of ["physical", "paper"] as const) {
  test(`A mistake in any shader of the ${look} look is reported by its file and line`, async () => {
    const breakages = await page.evaluate(
      async ({ module, look }) => {
        const { breakPrograms }: Programs = await import(module);
        return breakPrograms(look);
      },
      { module: PROGRAMS, look },
    );
    expect(breakages.length).toBeGreaterThan(6);
    for (const { file, complaint } of breakages) {
      const lines = readFileSync(join(SHADERS, file), "utf8").split("\n").length;
      expect.soft(complaint, file).toContain(`: shaders/${file}:${lines}: 'surplus'`);
    }
  });
}

test("A mistake in an included file is reported by that file's own name and line", async () => {
  const line = "  float peak = max(max(linear.r, linear.g), linear.b);";
  const complaint = await complaintAbout(page, "lib/srgb.glsl", line, "  float peak = maxx(1);");
  expect(complaint).toContain("ShaderError: broken SAMPLES=4 CUTOUT=0: ");
  expect(complaint).toContain(`shaders/lib/srgb.glsl:${lineNumber("lib/srgb.glsl", line)}: 'maxx'`);
});

test("A mistake after the includes is reported by the shader's own name and line", async () => {
  const line = "  vec3 normal = surfaceNormal();";
  const complaint = await complaintAbout(page, "paper/room.frag", line, "  vec3 normal = 1;");
  expect(complaint).toContain(`shaders/paper/room.frag:${lineNumber("paper/room.frag", line)}: '`);
});

test("Stages that do not fit together are reported by the program's name", async () => {
  const line = "in vec2 vUv;";
  const complaint = await complaintAbout(page, "paper/room.frag", line, "flat in vec2 vUv;");
  expect(complaint).toMatch(/^ShaderError: broken SAMPLES=4 CUTOUT=0: .*vUv/s);
});

test("Of several broken programs the first is reported, once", async () => {
  const vertex = resolveShader(join(SHADERS, "paper/mesh.vert"));
  const fragment = resolveShader(join(SHADERS, "paper/room.frag"));
  const broken = { ...fragment, source: `${fragment.source}surplus;` };
  const refusals = await page.evaluate(
    async ({ module, vertex, broken }) => {
      const { refusalsOf }: Programs = await import(module);
      return refusalsOf(vertex, broken);
    },
    { module: PROGRAMS, vertex, broken },
  );
  expect(refusals).toEqual([expect.stringContaining("broken SAMPLES=1 CUTOUT=0: "), ""]);
});

test("Relief finer than a pixel widens a highlight instead of making it sparkle", async () => {
  const [tiles, tile] = [4, 16];
  const size = tiles * tile;
  const found = await drawnBy(page, "tests/support/sparkle.frag", size);
  /** Over shifts by less than a pixel: mean variance of the pixels, and their mean. */
  const [widened, plain, truth] = [0, 1, 2].map((channel) => {
    const pixels: Spread[] = [];
    // At a tile's edge the next pixel belongs to another shift.
    for (let y = 2; y < tile - 2; y++) {
      for (let x = 2; x < tile - 2; x++) {
        const shifted = Array.from({ length: tiles * tiles }, (_, n) => {
          const row = Math.floor(n / tiles) * tile + y;
          const column = (n % tiles) * tile + x;
          return found[(row * size + column) * 3 + channel] ?? 0;
        });
        const mean = shifted.reduce((a, b) => a + b) / shifted.length;
        const variance = shifted.reduce((sum, v) => sum + (v - mean) ** 2, 0) / shifted.length;
        pixels.push({ mean, variance });
      }
    }
    const average = (of: "mean" | "variance") =>
      pixels.reduce((sum, pixel) => sum + pixel[of], 0) / pixels.length;
    return { mean: average("mean"), variance: average("variance") };
  }) as [Spread, Spread, Spread];
  console.log(`sparkle: ${JSON.stringify({ widened, plain, truth })}`);
  expect(plain.variance / plain.mean ** 2, "it would sparkle").toBeGreaterThan(1);
  expect(widened.variance).toBeLessThan(0.02 * plain.variance);
  expect(widened.mean / truth.mean, "as much light as there is").toBeGreaterThan(0.5);
  expect(widened.mean / truth.mean).toBeLessThan(2);
});

test("Where normals and tangents cancel there is a normal still", async () => {
  const [up = 0, length = 0] = await drawnBy(page, "tests/support/cancelled.frag", 1);
  expect(up).toBe(1);
  expect(length).toBeGreaterThan(0.5);
});

test("A normal map's scale multiplies its slopes", async () => {
  const cosines = await drawnBy(page, "tests/support/slopes.frag", 1);
  for (const [i, slope] of [1, 2, 0.5].entries()) {
    expect(cosines[i]).toBeCloseTo(Math.cos(Math.atan(slope)), 2);
  }
});

test("Surfaces in light from all around give back all that they get: a white furnace", async () => {
  const size = 12;
  const found = await drawnBy(page, "tests/support/furnace.frag", size);
  expect(found.length).toBe(size * size * 3);
  const errors = { metal: 0, matt: 0, lost: 0 };
  for (let i = 0; i < found.length; i += 3) {
    errors.metal = Math.max(errors.metal, Math.abs((found[i] ?? 0) - 1));
    errors.matt = Math.max(errors.matt, Math.abs((found[i + 1] ?? 0) - 1));
    errors.lost = Math.max(errors.lost, 1 - (found[i + 2] ?? 0));
  }
  console.log(`furnace: ${JSON.stringify(errors)}`);
  expect(errors.metal).toBeLessThan(0.02);
  expect(errors.matt).toBeLessThan(0.02);
  // Without what bounces between facets it would be a grey furnace.
  expect(errors.lost).toBeGreaterThan(0.3);
});

test("A rough mirror reflects all of a flame's light, however near, and no image brighter than it", async () => {
  const size = 6;
  const found = await drawnBy(page, "tests/support/highlight.frag", size);
  expect(found.length).toBe(size * size * 3);
  const shares = found.filter((_, i) => i % 3 < 2);
  const brightest = Math.max(...found.filter((_, i) => i % 3 === 2));
  const [least, most] = [Math.min(...shares), Math.max(...shares)];
  console.log(`highlight: ${JSON.stringify({ least, most, brightest })}`);
  // Least where the flame stands 7 cm above what is rough.
  expect(least).toBeGreaterThan(0.82);
  expect(most).toBeLessThan(1.13);
  expect(brightest).toBeLessThan(1);
});
