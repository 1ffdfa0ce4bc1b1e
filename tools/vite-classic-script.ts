import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { basename, resolve } from "node:path";
import type { Plugin } from "vite";

const ROOT = resolve(import.meta.dirname, "..");

/**
 * A script that runs where it stands, first thing in the head of one page: Vite bundles modules only, which
 * wait until the page is parsed, and by then something may have been shown. A file rather than inline, for
 * pages under a strict policy.
 *
 * @param page and script, relative to the root
 */
export function classicScript(page: string, script: string): Plugin {
  const source = readFileSync(resolve(ROOT, script), "utf8");
  const hash = createHash("sha256").update(source).digest("base64url").slice(0, 8);
  const built = `code/${basename(script, ".js")}-${hash}.js`;
  return {
    name: "classic-script",
    generateBundle() {
      this.emitFile({ type: "asset", fileName: built, source });
    },
    transformIndexHtml(_, { filename, bundle }) {
      if (filename !== resolve(ROOT, page)) return [];
      const src = bundle ? `./${built}` : `/${script}`;
      return [{ tag: "script", attrs: { src }, injectTo: "head" }];
    },
  };
}
