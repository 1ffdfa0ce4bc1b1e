/// <reference types="vitest/config" />
import { cpSync, writeFileSync } from "node:fs";
import { type BuildOptions, defineConfig, type Plugin } from "vite";
import { BUILD_TARGET } from "./tools/oldest-browsers.ts";
import { classicScript } from "./tools/vite-classic-script.ts";
import { glsl } from "./tools/vite-glsl.ts";

const shared: BuildOptions = { target: BUILD_TARGET };

/** `vite build` makes the hosted page; `vite build --mode lib` makes the package. */
const builds: Record<string, BuildOptions> = {
  // Hashed code beside the page in its own folder: `assets/` is ours, for models and textures.
  page: {
    ...shared,
    outDir: "dist-page",
    sourcemap: true,
    assetsDir: "code",
    rolldownOptions: { input: ["index.html", "use.html", "how.html"] },
  },
  lib: {
    ...shared,
    outDir: "dist",
    copyPublicDir: false,
    lib: {
      entry: {
        "candle-flame-element": "src/candle-flame-element.ts",
        define: "src/define.ts",
      },
      formats: ["es"],
    },
    rolldownOptions: {
      output: {
        chunkFileNames: "[name].js",
        minify: true,
        // Each module has side effects or is needed: there is nothing for a user's bundler to drop.
        comments: { annotation: false },
        // What the element always needs is one chunk: many small ones compress worse. Defining it is not in it:
        // package.json tells bundlers that `define.js` alone has side effects.
        codeSplitting: {
          groups: [
            {
              name: "candle-flame-element",
              tags: ["$initial"],
              test: (id) => !id.endsWith("src/define.ts"),
            },
          ],
        },
      },
    },
  },
};

// three's loaders name decoders of their own, which a library build would inline: almost a megabyte that
// is never used, since ours are fetched from `decoders/`.
const withoutBundledDecoders: Plugin = {
  name: "without-bundled-decoders",
  enforce: "pre",
  transform: {
    filter: { id: /three\/examples\/jsm\/loaders\/(DRACO|KTX2)Loader\.js/ },
    handler: (code) => ({
      code: code.replaceAll(/new URL\( '\.\.\/libs\/[^']+', import\.meta\.url \)/g, "''"),
      map: null,
    }),
  },
};

// The element's style is a template string, which no minifier looks into.
const minifiedStyle: Plugin = {
  name: "minified-style",
  transform: {
    filter: { id: /src\/element\/style\.ts/ },
    handler: (code) => ({
      code: code.replace(/`[^`]+`/, (css) =>
        css
          .replaceAll(/\s*\n\s*/g, "")
          .replaceAll(
            /;?\s*([{};])\s*|([:,]) | ([*/]) | (?=!)|"(\w+)"(?=])|\b0(?=\.)/g,
            "$1$2$3$4",
          ),
      ),
      map: null,
    }),
  },
};

// The element looks for its models and textures beside its own module.
const shipAssets: Plugin = {
  name: "ship-assets",
  apply: (_, { mode }) => mode === "lib",
  async closeBundle() {
    // Here alone: the analyzer brings a TypeScript of its own.
    const { manifest } = await import("./tools/elements-manifest.ts");
    cpSync("public", "dist", { recursive: true });
    cpSync("frameworks", "dist/frameworks", { recursive: true });
    writeFileSync("dist/custom-elements.json", `${JSON.stringify(await manifest(), null, 2)}\n`);
  },
};

/** Unit tests that count the processor's time, which is that of all threads of a process. */
const ALONE = ["tests/unit/world/room/floor-plan.test.ts"];

export default defineConfig(({ mode }) => ({
  base: "./",
  plugins: [
    glsl({ minify: mode === "production" || mode === "lib" }),
    withoutBundledDecoders,
    mode === "lib" && minifiedStyle,
    shipAssets,
    mode !== "lib" && classicScript("index.html", "src/page/other-view.js"),
  ],
  build: builds[mode] ?? builds.page ?? {},
  server: { host: "127.0.0.1", port: 5173 },
  preview: { host: "127.0.0.1", port: 4173 },
  // A world of ten seconds with its air takes some of them on a busy machine.
  test: {
    environment: "node",
    testTimeout: 30_000,
    // No test leaves anything behind, so that files may share what they import.
    isolate: false,
    projects: [
      {
        extends: true,
        test: {
          name: "unit",
          include: ["tests/unit/**/*.test.ts"],
          exclude: ALONE,
          pool: "threads",
        },
      },
      { extends: true, test: { name: "timed", include: ALONE, pool: "forks" } },
    ],
    // All cores: the default leaves one out, which of two is half.
    maxWorkers: "100%",
  },
}));
