import { existsSync, readdirSync, readFileSync } from "node:fs";
import { posix } from "node:path";
import { describe, expect, test } from "vitest";
import { filesIn, importsOf, textOf } from "./sources.ts";

/** Packages that three copies under another name, by that name. */
const COPIES: Readonly<Record<string, string>> = { meshopt_decoder: "meshoptimizer" };

const NOTICES = textOf("public/LICENSES.md");

/** Package of a module in `node_modules`; three has copies of others among its examples. */
function packageOf(module: string): string {
  const [, copy] = /^three\/examples\/jsm\/libs\/([\w-]+)/.exec(module) ?? [];
  return copy ? (COPIES[copy] ?? copy) : (module.split("/")[0] ?? "");
}

/** Packages whose code the sources import, directly or through modules of three. */
function bundledPackages(): string[] {
  const imports = filesIn("src", /\.ts$/).flatMap(importsOf);
  const modules = new Set(
    imports.filter(({ to, isType }) => !isType && /^[a-z]/.test(to)).map(({ to }) => to),
  );
  for (const module of modules) {
    if (!module.endsWith(".js")) continue;
    const code = readFileSync(posix.join("node_modules", module), "utf8");
    for (const [, path = ""] of code.matchAll(/\bfrom\s+["'](\.[^"']+)["']/g)) {
      modules.add(posix.join(posix.dirname(module), path));
    }
  }
  return [...new Set([...modules].filter((name) => !/^(src|shaders)\//.test(name)).map(packageOf))];
}

/** The package's own licence; null where only three's copy of its code is installed. */
function licenceOf(name: string): string | null {
  const folder = posix.join("node_modules", name);
  const file = existsSync(folder) && readdirSync(folder).find((one) => /^licen[cs]e/i.test(one));
  return file ? readFileSync(posix.join(folder, file), "utf8") : null;
}

const words = (text: string): string => text.replaceAll(/\s+/g, " ").trim();

describe("public/LICENSES.md, which ships with the code,", () => {
  const bundled = bundledPackages();

  test("is compared with all that is bundled", () => {
    const expected = ["gl-matrix", "ktx-parse", "meshoptimizer", "three", "zstddec"];
    expect(bundled.toSorted()).toEqual(expected);
  });

  // What Vite and Rolldown add is no import.
  test.each([...bundled, "vite", "rolldown"])("has the copyright of %s", (name) => {
    const [, holder] =
      new RegExp(`^\\| ${name} \\|.*\\| (Copyright .+) \\|$`, "m").exec(NOTICES) ?? [];
    expect(holder).toMatch(/\d{4}.* \w+/);
    const licence = licenceOf(name);
    if (licence) expect(words(licence)).toContain(holder);
  });

  test("has the text that all of them are under", () => {
    const [, text = ""] =
      /^(Permission is hereby granted[\s\S]*)/m.exec(licenceOf("three") ?? "") ?? [];
    expect(text).toContain("copyright notice and this permission notice shall be included");
    expect(words(NOTICES)).toContain(words(text));
  });

  test("has the notice of Zstandard, whose decoder is in zstddec", () => {
    expect(NOTICES).toMatch(
      /Zstandard, Copyright \(c\) 2016-present, Yann Collet, Facebook, Inc\./,
    );
    expect(NOTICES).toContain(
      "Redistributions in binary form must reproduce the above copyright notice",
    );
  });
});
