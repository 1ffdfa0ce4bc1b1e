// All checks, in the order in which a mistake is cheapest to find. Ends with "N passed, N failed".
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync } from "node:fs";

const REPORTS = "test-results/reports";
const VITEST = `${REPORTS}/unit.json`;
const PLAYWRIGHT = `${REPORTS}/visual.json`;

const passes = (report) => JSON.parse(readFileSync(report, "utf8"));
const STAGES = [
  { name: "lint and import rules", command: "npx biome ci ." },
  { name: "types", command: "npx tsc -p ." },
  {
    name: "unit",
    command: `npx vitest run --reporter=default --reporter=json --outputFile=${VITEST}`,
    count: () => {
      const { numPassedTests, numFailedTests } = passes(VITEST);
      return { passed: numPassedTests, failed: numFailedTests };
    },
  },
  { name: "build", command: "npm run --silent build" },
  { name: "package", command: "npm run --silent test:package" },
  {
    name: "browser",
    command: "npm run --silent test:visual -- --reporter=list,json",
    env: { PLAYWRIGHT_JSON_OUTPUT_NAME: PLAYWRIGHT },
    count: () => {
      const { expected, unexpected, flaky } = passes(PLAYWRIGHT).stats;
      return { passed: expected, failed: unexpected + flaky };
    },
  },
];

rmSync(REPORTS, { recursive: true, force: true });
mkdirSync(REPORTS, { recursive: true });
const total = { passed: 0, failed: 0 };
for (const { name, command, env = {}, count } of STAGES) {
  console.log(`\n— ${name}: ${command}`);
  const begin = Date.now();
  const { status } = spawnSync(command, {
    shell: true,
    stdio: "inherit",
    env: { ...process.env, ...env },
  });
  let result = { passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1 };
  try {
    if (count) result = count();
    // A runner that dies outside of its tests fails, whatever it counted.
    if (status !== 0 && result.failed === 0) result.failed = 1;
  } catch {
    result = { passed: 0, failed: 1 };
  }
  total.passed += result.passed;
  total.failed += result.failed;
  const seconds = ((Date.now() - begin) / 1000).toFixed(1);
  console.log(`— ${name}: ${result.passed} passed, ${result.failed} failed in ${seconds} s`);
  // Later stages would test the wrong thing.
  if (name === "build" && status !== 0) break;
}
console.log(`\n${total.passed} passed, ${total.failed} failed`);
process.exit(total.failed > 0 ? 1 : 0);
