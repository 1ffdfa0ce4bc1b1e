import { resolve } from "node:path";
import { defineConfig } from "vite";
import { glsl } from "../../tools/vite-glsl.ts";

// The bench's page is built as the hosted page is, so that what is measured is what ships.
export default defineConfig({
  root: import.meta.dirname,
  publicDir: resolve(import.meta.dirname, "../../public"),
  plugins: [glsl({ minify: true })],
  build: {
    target: "es2022",
    outDir: resolve(import.meta.dirname, "../../work/bench"),
    emptyOutDir: true,
    assetsDir: "code",
  },
  preview: {
    host: "127.0.0.1",
    // An isolated page has a clock of 5 µs; any other, of 100 µs.
    headers: {
      "Cross-Origin-Opener-Policy": "same-origin",
      "Cross-Origin-Embedder-Policy": "require-corp",
    },
  },
});
