// node tools/package-size.mjs <tarball>: what the package costs. A page with a lone candle, the code that
// `scene="candle"` reaches, gzipped, as the package ships it; an installation, the tarball.
import { execFileSync } from "node:child_process";
import { readFileSync, statSync } from "node:fs";
import { resolve } from "node:path";
import { gzipSync } from "node:zlib";

const LIMIT = 60_000;
const TARBALL_LIMIT = 8_000_000;
/** Chunks that are fetched for `scene="candle"`: the element's own, and this one. */
const ENTRIES = ["define.js", "candle-scene.js"];

const reached = new Map();
function reach(name) {
  if (reached.has(name)) return;
  const code = readFileSync(resolve("dist", name), "utf8");
  reached.set(name, { code, bytes: gzipSync(code, { level: 9 }).length });
  // Static ones alone: what is imported by a call is fetched when it is needed.
  for (const [, path] of code.matchAll(
    /(?:^|[;}\n])(?:import|export)[^"'`;()]*["'`]\.\/([^"'`]+)["'`]/g,
  ))
    reach(path);
}
for (const name of ENTRIES) reach(name);

let total = 0;
for (const [name, { bytes }] of reached) {
  total += bytes;
  console.log(`${String(bytes).padStart(7)}  ${name}`);
}
console.log(`${String(total).padStart(7)}  bytes of ${LIMIT}`);
const strangers = [...reached].filter(
  ([name, { code }]) =>
    /room|load-model|Loader/.test(name) || /BufferGeometry|\beval\(|new Function/.test(code),
);
for (const [name] of strangers) console.error(`${name} has no business in a lone candle`);
const { size } = statSync(process.argv[2]);
console.log(`${String(size).padStart(7)}  bytes of ${TARBALL_LIMIT} in the tarball`);
const page = readFileSync("docs/performance.md", "utf8");
const [, stated] = /\| the tarball \|.*\| ([\d,.]+) \|/.exec(page) ?? [];
const rowsOf = (text) => {
  const table = text.slice(text.indexOf("| in the package |"), text.indexOf("| the tarball |"));
  return [...table.matchAll(/^\| (`.*?`)/gm)]
    .map(([, name]) => name)
    .toSorted()
    .join(", ");
};
const list = execFileSync(process.execPath, ["tools/package-list.mjs"], { encoding: "utf8" });
const isStated =
  Math.abs(size / 1000 / Number(stated?.replaceAll(",", "")) - 1) < 0.05 &&
  rowsOf(page) === rowsOf(list);
if (!isStated) console.error("docs/performance.md has another table: run npm run package:list");
const isTooMuch = total > LIMIT || size > TARBALL_LIMIT;
// Fewer chunks than this would mean that imports were not found.
if (isTooMuch || !isStated || strangers.length > 0 || reached.size < 4) process.exit(1);
