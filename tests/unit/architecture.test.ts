import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { describe, expect, test } from "vitest";
import { codeOf, filesIn, importsOf, textOf } from "./sources.ts";

const ROOT = resolve(import.meta.dirname, "../..");
const MODULES = filesIn("src", /\.ts$/);
const IMPORTS = MODULES.flatMap(importsOf);

/** What each folder may import, beside itself. A name that ends in `:types` is for types alone. */
const ALLOWED: Readonly<Record<string, readonly string[]>> = {
  "src/gl": ["shaders/post/fullscreen.vert"],
  "src/world": ["gl-matrix", "src/settings.ts"],
  "src/light": ["src/world", "src/settings.ts"],
  "src/input": ["src/world", "src/window-of.ts"],
  "src/assets": ["three", "@gltf-transform/core:types"],
  "src/render": [
    "gl-matrix",
    "src/gl",
    "src/light",
    "src/world",
    "src/assets:types",
    "src/settings.ts",
    "shaders",
  ],
  "src/scenes": [
    "src/gl",
    "src/render",
    "src/light",
    "src/world",
    "src/assets",
    "src/settings.ts",
    "src/window-of.ts",
  ],
  "src/element": [
    "src/candle-flame.ts",
    "src/create-candle.ts",
    "src/gl/gpu-object.ts",
    "src/gl/next-task.ts",
    "src/key-names.ts",
    "src/input",
    "src/scenes",
    "src/world",
    "src/settings.ts",
    "src/window-of.ts",
  ],
  "src/page": [
    "src/define.ts",
    "src/settings.ts",
    "src/key-names.ts",
    "src/candle-flame-element.ts:types",
  ],
};

/** What a frame passes through, from the world to the screen. */
const FRAME = ["src/world", "src/light", "src/render", "src/gl"];

const isIn = (path: string, folder: string) => path === folder || path.startsWith(`${folder}/`);

const isInFrame = (path: string) => FRAME.some((folder) => isIn(path, folder));

describe("the house's imports run down only", () => {
  test("all of them are seen", () => {
    expect(MODULES.length).toBeGreaterThan(25);
    expect(IMPORTS.length).toBeGreaterThan(60);
    const kinds = (from: string, to: string) =>
      IMPORTS.filter((one) => one.from === from && one.to === to).map((one) =>
        one.isType ? "type" : one.isLazy ? "lazy" : "value",
      );
    expect(kinds("src/scenes/canvas-target.ts", "src/gl/gpu.ts")).toEqual(["value"]);
    expect(kinds("src/world/player/player.ts", "src/world/player/intent.ts")).toEqual(["type"]);
    expect(kinds("src/scenes/room-models.ts", "src/assets/load-model.ts")).toEqual(["lazy"]);
    expect(kinds("src/define.ts", "src/candle-flame-element.ts")).toEqual(["value"]);
  });

  test.each(Object.entries(ALLOWED))(
    "%s imports what it may, and nothing else",
    (folder, allowed) => {
      const strays = IMPORTS.filter(({ from, to, isType }) => {
        if (!isIn(from, folder) || isIn(to, folder) || /\.(css|html|svg)$/.test(to)) return false;
        return !allowed.some((name) => {
          const [path = "", typesOnly] = name.split(":");
          return isIn(to, path) && (!typesOnly || isType);
        });
      });
      expect(strays).toEqual([]);
    },
  );

  test("every folder has its rule", () => {
    const folders = new Set(MODULES.map((name) => name.split("/").slice(0, 2).join("/")));
    const ruled = [...folders].filter((folder) => !folder.endsWith(".ts"));
    expect(ruled.toSorted()).toEqual(Object.keys(ALLOWED).toSorted());
  });

  test("only assets/ knows three", () => {
    const knowing = IMPORTS.filter(({ to }) => isIn(to, "three")).map(({ from }) => from);
    expect(knowing.length).toBeGreaterThan(0);
    for (const file of knowing) expect(file).toMatch(/^src\/assets\//);
  });

  test("three is fetched when it is needed, not with the element", () => {
    const reached = new Set(["src/define.ts"]);
    for (const file of reached) {
      for (const { from, to, isType, isLazy } of IMPORTS) {
        if (from === file && !isType && !isLazy) reached.add(to);
      }
    }
    expect(reached).toContain("src/world/world.ts");
    expect([...reached].filter((name) => isIn(name, "three"))).toEqual([]);
  });

  test("what is imported exists", () => {
    const ours = IMPORTS.filter(({ to }) => /^(src|shaders)\//.test(to));
    for (const { to } of ours) expect(existsSync(resolve(ROOT, to)), to).toBe(true);
    expect(ours.length).toBeGreaterThan(50);
  });
});

describe("world/ and light/ run in Node", () => {
  test("their types need neither DOM nor Node", () => {
    const files = MODULES.filter((name) => isIn(name, "src/world") || isIn(name, "src/light"));
    expect(files.length).toBeGreaterThan(10);
    const compiler = resolve(ROOT, "node_modules/typescript/bin/tsc");
    const options = "--noEmit --strict --target ES2022 --lib ES2023 --module ESNext";
    const resolution = "--moduleResolution bundler --skipLibCheck --ignoreConfig";
    const { status, stdout } = spawnSync(
      process.execPath,
      [compiler, ...options.split(" "), ...resolution.split(" "), "--types", "", ...files],
      { cwd: ROOT, encoding: "utf8" },
    );
    expect(stdout).toBe("");
    expect(status).toBe(0);
  });
});

describe("nothing is left to chance or to the clock", () => {
  const offenders = (pattern: RegExp, files: readonly string[]) =>
    files.filter((name) => pattern.test(codeOf(name)));

  test("there is no Math.random and no date anywhere", () => {
    expect(offenders(/\bMath\.random\b|\bcrypto\b|\bDate\b/, MODULES)).toEqual([]);
  });

  test("a frame is made without looking at a clock", () => {
    const clock = /\bperformance\.|\brequestAnimationFrame\b|\bset(Timeout|Interval)\b/;
    const watching = offenders(clock, MODULES);
    expect(watching).toContain("src/candle-flame.ts");
    expect(watching.filter(isInFrame)).toEqual([]);
  });

  test("only gl/ calls gl.", () => {
    const calling = offenders(/\bgl\.[a-zA-Z]|WebGL2?[A-Z]|getContext\(\s*["']webgl/, MODULES);
    expect(calling).toContain("src/gl/gpu.ts");
    const messengers = calling.filter((name) => !isIn(name, "src/gl"));
    // The element tells one error by its name; the page asks what a context of its own can do.
    expect(messengers).toEqual(["src/element/events.ts", "src/page/drawn-look.ts"]);
    expect(codeOf("src/element/events.ts")).not.toMatch(/\bgl\.[a-zA-Z]|WebGL2|getContext/);
  });

  test("a frame is made without the document it is shown in", () => {
    const knowing = offenders(/(?<![.#\w])(document|window)\.[a-zA-Z]/, MODULES);
    expect(knowing).toContain("src/element/lifecycle.ts");
    expect(knowing.filter(isInFrame)).toEqual([]);
  });
});

test("No file of src is longer than 350 lines", () => {
  for (const file of filesIn("src", /\.(ts|css|html)$/)) {
    expect.soft(textOf(file).split("\n").length - 1, file).toBeLessThanOrEqual(350);
  }
});
