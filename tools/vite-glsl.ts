import { readFileSync } from "node:fs";
import { relative, resolve } from "node:path";
import type { Plugin } from "vite";

const ROOT = resolve(import.meta.dirname, "../shaders");

/** One shader stage after its includes, with the files that `#line` numbers refer to. */
interface Resolved {
  source: string;
  files: string[];
}

/** Without functions and constants that a shader names nowhere else. Its lines keep their numbers. */
function withoutUnused(source: string): string {
  const used = source.replace(
    /^\w+(?: \w+)? (\w+)(?:\([^)]*\) \{\n[\s\S]*?^\}|(?:\[\w*\])? = [^;]*;)$/gm,
    (definition, name) =>
      name === "main" || source.split(new RegExp(`\\b${name}\\b`)).length > 2
        ? definition
        : definition.replace(/^#line.*\n|[^\n]/gm, ""),
  );
  return used === source ? source : withoutUnused(used);
}

// Comments and blanks go, line breaks stay: an error of a released build still names the right line. Directives stay as
// they are, and so do blanks between two signs, which may be another operator. Beside `#line`, which says where the next
// line is, empty lines go too.
function minified(source: string): string {
  const code = source
    .replace(/\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ""))
    .replace(/[ \t]*\/\/.*$/gm, "");
  return withoutUnused(code)
    .replace(/^[ \t]+/gm, "")
    .replace(/^[^#\n].*$/gm, (line) =>
      line
        .replace(/ ([+/-]) (?![+-])| ([+/-]=)/g, "$1$2")
        .replace(/ *([=(){},;*?:<>|&^]) */g, "$1")
        .replace(/\b(\d+\.)0\b|\b0(\.\d)/g, "$1$2"),
    )
    .replace(/(\n(#line \d+ \d+)?)+(?=\n#line )/g, "")
    .replace(
      /^#line (\d+) (\d+)\n(\n*)/gm,
      (_, line, file, { length }) => `#line ${Number(line) + length} ${file}\n`,
    );
}

/**
 * Expands `#include "lib/noise.glsl"`, from the shaders' root, each file once.
 *
 * `#line 1 n` before and after each included text makes the compiler say `n:line`, which the program
 * turns back into a file name. In GLSL ES 3.00 `#line` numbers the line after it. A branch that is not
 * taken skips it as well, so it is said again where the branch ends.
 */
export function resolveShader(file: string, files: string[] = []): Resolved {
  const index = files.push(relative(ROOT, file)) - 1;
  const source = readFileSync(file, "utf8")
    .split("\n")
    .map((line, number) => {
      const include = /^\s*#include\s+"([^"]+)"/.exec(line)?.[1];
      const place = `#line ${number + 2} ${index}`;
      if (include === undefined) return /^\s*#(else|endif)/.test(line) ? `${line}\n${place}` : line;
      const path = resolve(ROOT, include);
      if (files.includes(relative(ROOT, path))) return "";
      const included = files.length;
      return `#line 1 ${included}\n${resolveShader(path, files).source}\n${place}`;
    })
    .join("\n");
  return { source, files };
}

/** Imports `.vert`, `.frag` and `.glsl` files as `{ source, files }`. */
export function glsl({ minify }: { minify: boolean }): Plugin {
  return {
    name: "glsl",
    enforce: "pre",
    load(id) {
      const file = id.split("?")[0] ?? id;
      if (!/\.(vert|frag|glsl)$/.test(file)) return null;
      const { source, files } = resolveShader(file);
      for (const name of files) this.addWatchFile(resolve(ROOT, name));
      return `export default ${JSON.stringify({ source: minify ? minified(source) : source, files })}`;
    },
  };
}
