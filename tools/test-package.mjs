// npm run test:package, after a build: packs the package as it would be published, and checks what is in it.
import { execSync } from "node:child_process";
import { mkdirSync, rmSync } from "node:fs";

const FOLDER = "test-results/package";

rmSync(FOLDER, { recursive: true, force: true });
mkdirSync(FOLDER, { recursive: true });
// Without scripts: they would build once more.
const pack = `npm pack --ignore-scripts --json --loglevel=error --pack-destination ${FOLDER}`;
const [{ filename }] = JSON.parse(execSync(pack, { encoding: "utf8" }));
for (const command of [
  `npx publint run ${FOLDER}/${filename} --strict`,
  `npx attw ${FOLDER}/${filename} --profile esm-only --exclude-entrypoints ./custom-elements.json ./package.json -q`,
  `node tools/package-size.mjs ${FOLDER}/${filename}`,
  `node tests/embed/consumer.mjs ${FOLDER}/${filename}`,
]) {
  try {
    execSync(command, { stdio: "inherit" });
  } catch {
    console.error(`Failed: ${command}`);
    process.exit(1);
  }
}
rmSync(FOLDER, { recursive: true });
