import { readdirSync, readFileSync } from "node:fs";
import { dirname, posix, resolve } from "node:path";

const ROOT = resolve(import.meta.dirname, "../..");

/** Files under a folder of the project, by their path in it. */
export function filesIn(folder: string, ending: RegExp): string[] {
  return readdirSync(resolve(ROOT, folder), { recursive: true, encoding: "utf8" })
    .map((name) => posix.join(folder, name.replaceAll("\\", "/")))
    .filter((name) => ending.test(name))
    .toSorted();
}

export function textOf(file: string): string {
  return readFileSync(resolve(ROOT, file), "utf8");
}

/** The text without comments; strings stay. */
export function codeOf(file: string): string {
  return textOf(file).replace(
    /("(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`)|\/\/.*$|\/\*[\s\S]*?\*\//gm,
    (_, string?: string) => string ?? "",
  );
}

export interface Import {
  readonly from: string;
  /** A file of the project, or a package. */
  readonly to: string;
  readonly isType: boolean;
  /** `import()`: fetched when needed. */
  readonly isLazy: boolean;
}

/** What a module imports or re-exports. */
export function importsOf(file: string): Import[] {
  const code = codeOf(file);
  const statements = code.matchAll(
    /^(?:import|export)\s+(type\b)?([^;"'=()]*?)\bfrom\s+["']([^"']+)["']|^import\s+["']([^"']+)["']/gm,
  );
  const found = [...statements].map(([, type, names = "", to = "", effect]) => ({
    from: file,
    to: target(file, effect ?? to),
    isType: type !== undefined || isListOfTypes(names),
    isLazy: false,
  }));
  const calls = code.matchAll(/\bimport\(\s*["']([^"']+)["']/g);
  const lazy = [...calls].map(([, to = ""]) => ({
    from: file,
    to: target(file, to),
    isType: false,
    isLazy: true,
  }));
  return [...found, ...lazy];
}

function isListOfTypes(names: string): boolean {
  const list = /^\s*\{([\s\S]*)\}\s*$/.exec(names)?.[1]?.split(",") ?? [];
  const named = list.map((name) => name.trim()).filter((name) => name !== "");
  return named.length > 0 && named.every((name) => name.startsWith("type "));
}

function target(file: string, specifier: string): string {
  if (!specifier.startsWith(".")) return specifier;
  return posix.join(dirname(file), specifier).replace(/\?.*$/, "").replace(/\.js$/, ".ts");
}
