// npm run package:list: what the package ships, as the table of docs/performance.md. Needs `npm run build`.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const pack = "npm pack --dry-run --ignore-scripts --json --loglevel=error";
const [tarball] = JSON.parse(execFileSync(pack, { shell: true, encoding: "utf8" }));
const kB = (bytes) => (bytes / 1000).toLocaleString("en", { maximumFractionDigits: 1 });

/** Code file by file, everything else folder by folder. */
const rows = new Map();
for (const { path, size } of tarball.files) {
  const [, folder] = /^dist\/([^/]+)\//.exec(path) ?? [];
  const name = folder ? `${folder}/` : path.replace(/^dist\//, "");
  const row = rows.get(name) ?? { files: 0, size: 0, gzip: 0 };
  row.files++;
  row.size += size;
  row.gzip += gzipSync(readFileSync(path), { level: 9 }).length;
  rows.set(name, row);
}
console.log("| in the package | files | kB | gzip, kB |\n|---|---|---|---|");
for (const [name, { files, size, gzip }] of [...rows].sort(([, a], [, b]) => b.size - a.size)) {
  console.log(`| \`${name}\` | ${files} | ${kB(size)} | ${kB(gzip)} |`);
}
console.log(
  `| the tarball | ${tarball.files.length} | ${kB(tarball.unpackedSize)} | ${kB(tarball.size)} |`,
);
