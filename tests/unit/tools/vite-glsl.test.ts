import { readFileSync } from "node:fs";
import { relative, resolve } from "node:path";
import type { PluginContext } from "rolldown";
import { describe, expect, test } from "vitest";
import { glsl, resolveShader } from "../../../tools/vite-glsl.ts";

const ROOT = resolve(import.meta.dirname, "../../../shaders");
const FOLDER = resolve(import.meta.dirname, "shaders");
const MAIN = resolve(FOLDER, "main.frag");

interface Shader {
  readonly source: string;
  readonly files: readonly string[];
}

/** What an import of the file yields, and what is watched for its sake. */
function imported(file: string, minify: boolean): Shader & { readonly watched: string[] } {
  const watched: string[] = [];
  const { load } = glsl({ minify });
  if (typeof load !== "function") throw new Error("the plugin has no load hook");
  const context = { addWatchFile: (name: string) => watched.push(name) };
  const module = load.call(context as unknown as PluginContext, file, {} as never);
  const [, json] = /^export default (.*)$/s.exec(String(module)) ?? [];
  return { ...(JSON.parse(json ?? "") as Shader), watched };
}

/** File and line that a compiler of GLSL ES 3.00 would give for each line: `#line` numbers the next. */
function positions({ source, files }: Shader): { text: string; file: string; line: number }[] {
  let file = 0;
  let line = 0;
  return source.split("\n").flatMap((text) => {
    line++;
    const directive = /^#line (\d+) (\d+)$/.exec(text);
    if (!directive) return [{ text, file: files[file] ?? `unknown file ${file}`, line }];
    line = Number(directive[1]) - 1;
    file = Number(directive[2]);
    return [];
  });
}

const lineOf = (file: string, line: number) =>
  readFileSync(resolve(ROOT, file), "utf8").split("\n")[line - 1];

describe("shaders with includes", () => {
  test("hold each included file once, though three ask for it", () => {
    const { source, files } = resolveShader(MAIN);
    expect(source.match(/MARKER_IN_LEAF/g)).toHaveLength(1);
    expect(source).not.toContain("#include");
    expect(files.map((file) => relative(FOLDER, resolve(ROOT, file)))).toEqual([
      "main.frag",
      "branch.glsl",
      "leaf.glsl",
      "twig.glsl",
    ]);
  });

  test("put what is included before what needs it", () => {
    const { source } = resolveShader(MAIN);
    const order = ["LEAF", "BRANCH", "TWIG", "MAIN"].map((name) =>
      source.indexOf(`MARKER_IN_${name}`),
    );
    expect(order).toEqual(order.toSorted((a, b) => a - b));
    expect(order[0]).toBeGreaterThan(0);
  });

  test.each([
    ["main.frag", "MARKER_IN_MAIN", 9],
    ["main.frag", "MARKER_AT_END", 13],
    ["branch.glsl", "MARKER_IN_BRANCH", 4],
    ["twig.glsl", "MARKER_IN_TWIG", 3],
    ["leaf.glsl", "MARKER_IN_LEAF", 2],
  ])("let a compiler name %s for its marker %s, line %i", (file, marker, line) => {
    const found = positions(resolveShader(MAIN)).filter(({ text }) => text.includes(marker));
    expect(found).toHaveLength(1);
    expect(relative(FOLDER, resolve(ROOT, found[0]!.file))).toBe(file);
    expect(found[0]!.line).toBe(line);
  });

  test("name the file that asks for one that is missing", () => {
    expect(() => resolveShader(resolve(FOLDER, "missing.frag"))).toThrow(/no-such-file\.glsl/);
  });

  test.each(["paper/room.frag", "paper/particle.vert", "particles/update.vert"])(
    "map every line of %s back to where it was written",
    (name) => {
      const lines = positions(resolveShader(resolve(ROOT, name)));
      expect(lines.length).toBeGreaterThan(20);
      for (const { text, file, line } of lines) {
        const written = lineOf(file, line);
        expect(text).toBe(written?.startsWith("#include") ? "" : written);
      }
    },
  );
});

describe("importing a shader", () => {
  test("watches each of its files, so that an edit shows at once", () => {
    const { watched } = imported(MAIN, false);
    expect(watched.map((file) => relative(FOLDER, file)).toSorted()).toEqual([
      "branch.glsl",
      "leaf.glsl",
      "main.frag",
      "twig.glsl",
    ]);
  });

  test("leaves other files to others", () => {
    const { load } = glsl({ minify: false });
    const context = {} as unknown as PluginContext;
    expect(typeof load === "function" && load.call(context, "/src/settings.ts", {} as never)).toBe(
      null,
    );
  });

  test("ignores what follows a question mark", () => {
    expect(imported(`${MAIN}?import`, false).files).toEqual(imported(MAIN, false).files);
  });

  test.each([MAIN, resolve(ROOT, "paper/room.frag"), resolve(ROOT, "particles/update.vert")])(
    "without comments and blanks keeps every line in its place: %s",
    (file) => {
      const written = imported(file, false);
      const released = imported(file, true);
      expect(released.source).not.toMatch(/\/\/|\/\*|\*\//);
      expect(released.source.length).toBeLessThan(written.source.length);
      expect(released.files).toEqual(written.files);
      const code = (text: string) => text.replace(/\/\/.*$/, "").trim();
      const tokens = (text: string) =>
        text.replaceAll(" ", "").replace(/\d+\.\d*|\.\d+/g, (literal) => `${Number(literal)}`);
      const placed = (shader: Shader) =>
        new Map(positions(shader).map(({ text, file, line }) => [`${file}:${line}`, text]));
      const lines = placed(released);
      const whole = placed(written);
      for (const place of lines.keys()) expect([...whole.keys()]).toContain(place);
      for (const [place, original] of whole) {
        if (original.includes("*")) continue; // a product, or a comment of many lines
        const own = code(original);
        const text = lines.get(place) ?? "";
        const [, removed] = (text === "" && /^(?:const )?\w+ (\w+)(?:\(| = )/.exec(own)) || [];
        if (removed) expect(released.source).not.toMatch(new RegExp(`\\b${removed}\\b`));
        if (text === "" && !own.startsWith("#")) continue; // of what nothing names
        expect(tokens(text), place).toBe(tokens(own));
        if (own.startsWith("#")) expect(text).toBe(own);
        else expect(text).not.toMatch(/ [=({]|[;,] /);
      }
    },
  );

  test("has the shortest of each number", () => {
    const { source } = imported(resolve(ROOT, "candle/display.frag"), true);
    expect(source).toMatch(/\d\.(?!\d)/);
    expect(source.replace(/^#.*$/gm, "")).not.toMatch(/\b0\.\d|\d\.0\b/);
  });

  test("keeps blanks that part two operators", () => {
    const { source } = imported(MAIN, true);
    expect(source).toContain("r - -branch(");
  });

  test("without functions and constants that only they name themselves, and all else in its place", () => {
    const { source } = imported(resolve(FOLDER, "unused.frag"), true);
    expect(source).not.toMatch(/unused|UNUSED/);
    expect(source.match(/used|USED/g)).toHaveLength(4);
    const [last] = positions({ source, files: ["unused.frag"] })
      .filter(({ text }) => /used\(/.test(text))
      .slice(-1);
    expect(last?.line).toBe(28);
  });

  test("without comments still begins with its version", () => {
    expect(imported(MAIN, true).source).toMatch(/^#version 300 es\n/);
  });
});
