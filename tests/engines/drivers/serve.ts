import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";
import { serveBuilt as serveFolder } from "../../../tools/built-site.mjs";
import { RECORDER } from "./recorder.ts";

const HTML = /^\/(?:[\w-]+\.html)?$/;

export interface Served {
  /** The hosted page, as built. */
  readonly page: string;
  /** The package, as built. */
  readonly library: string;
  close(): Promise<void>;
}

/**
 * Serves what is built, at ports that are free; every page begins with the recorder.
 *
 * @param pages more of the package's pages: the markup for a URL, or null
 */
export async function serveBuilt(pages: (url: URL) => string | null): Promise<Served> {
  const page = await serve("dist-page", ({ pathname }) => {
    if (!HTML.test(pathname)) return null;
    return readFileSync(join("dist-page", pathname === "/" ? "index.html" : pathname), "utf8");
  });
  const library = await serve("dist", pages);
  return {
    page: page.url,
    library: library.url,
    close: async () => {
      await Promise.all([page.close(), library.close()]);
    },
  };
}

function serve(outDir: string, pages: (url: URL) => string | null) {
  const recorded: Plugin = {
    name: "recorded-pages",
    configurePreviewServer: ({ middlewares }) => {
      middlewares.use((request, response, next) => {
        const url = new URL(request.url ?? "/", "http://127.0.0.1");
        const isRecorder = url.pathname === "/recorder.js";
        const html = isRecorder ? null : pages(url);
        if (!isRecorder && html === null) {
          next();
          return;
        }
        response.setHeader("content-type", isRecorder ? "text/javascript" : "text/html");
        response.end(isRecorder ? RECORDER : html?.replace(/<head>/i, `$&${SCRIPT}`));
      });
    },
  };
  return serveFolder(outDir, { plugins: [recorded] });
}

const SCRIPT = `<script src="/recorder.js"></script>`;
