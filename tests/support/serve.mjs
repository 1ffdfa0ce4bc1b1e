// node tests/support/serve.mjs PAGE LIBRARY SOURCES: serves the page and the package as built, and the sources, on these
// ports. In one process they are there in the time of one.
import { createServer, preview } from "vite";

const [page, library, sources] = process.argv
  .slice(2)
  .map((port) => ({ port: Number(port), strictPort: true }));
const [server] = await Promise.all([
  createServer({ server: sources }),
  preview({ preview: page }),
  preview({ build: { outDir: "dist" }, preview: library }),
]);
await server.listen();
