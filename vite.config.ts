/// <reference types="vitest/config" />
import { cpSync } from "node:fs";
import { type BuildOptions, defineConfig, type Plugin } from "vite";
import { glsl } from "./tools/vite-glsl.ts";

const shared: BuildOptions = { target: "es2022", sourcemap: true };

/** `vite build` makes the hosted page; `vite build --mode lib` makes the package. */
const builds: Record<string, BuildOptions> = {
  // Hashed code beside the page in its own folder: `assets/` is ours, for models and textures.
  page: { ...shared, outDir: "dist-page", assetsDir: "code" },
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
    rolldownOptions: { output: { chunkFileNames: "[name].js" } },
  },
};

// The element looks for its models and textures beside its own module.
const shipAssets: Plugin = {
  name: "ship-assets",
  apply: (_, { mode }) => mode === "lib",
  closeBundle() {
    cpSync("public", "dist", { recursive: true });
  },
};

export default defineConfig(({ mode }) => ({
  base: "./",
  plugins: [glsl({ minify: mode === "production" || mode === "lib" }), shipAssets],
  build: builds[mode] ?? builds.page ?? {},
  server: { host: "127.0.0.1", port: 5173 },
  preview: { host: "127.0.0.1", port: 4173 },
  test: { environment: "node", include: ["tests/unit/**/*.test.ts"] },
}));
