// node tests/embed/consumer.mjs <tarball>: the package in a project that has nothing else. Its types need no other
// package, and a bundler keeps what `candle-flame/define` defines.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "vite";

const OPTIONS = ["--noEmit", "--strict", "--module", "preserve", "--target", "es2022"];

// Outside of this project, whose own packages would be found.
const folder = mkdtempSync(join(tmpdir(), "consumer-"));
try {
  const installed = join(folder, "node_modules/candle-flame");
  mkdirSync(installed, { recursive: true });
  const tarball = resolve(process.argv[2]);
  execFileSync("tar", ["-xzf", tarball, "-C", installed, "--strip-components", "1"]);
  const main = join(folder, "main.ts");
  writeFileSync(main, 'import "candle-flame/define";\nexport type * from "candle-flame";\n');
  const compiler = resolve("node_modules/typescript/bin/tsc");
  const words = [compiler, ...OPTIONS, main];
  execFileSync(process.execPath, words, { cwd: folder, stdio: "inherit" });
  await build({
    root: folder,
    configFile: false,
    logLevel: "error",
    build: {
      modulePreload: false,
      rolldownOptions: { input: main, output: { entryFileNames: "main.js" } },
    },
  });
  const defined = [];
  globalThis.customElements = { get: () => undefined, define: (name) => defined.push(name) };
  await import(pathToFileURL(join(folder, "dist/main.js")));
  assert.deepEqual(defined, ["candle-flame"], "what a bundler keeps of `candle-flame/define`");
  console.log("Types and bundles in a project without other packages.");
} finally {
  rmSync(folder, { recursive: true });
}
