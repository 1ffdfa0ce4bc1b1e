// All checks, in the order in which a mistake is cheapest to find. Ends with "N passed, N failed".
import { spawn } from "node:child_process";
import { mkdirSync, readFileSync, rmSync } from "node:fs";

const REPORTS = "test-results/reports";
const VITEST = `${REPORTS}/unit.json`;
const PLAYWRIGHT = `${REPORTS}/visual.json`;
const COUNTS = `${REPORTS}/engines.json`;

const passes = (report) => JSON.parse(readFileSync(report, "utf8"));
const LINT = { name: "lint and import rules", command: "npx biome ci ." };
const TYPES = { name: "types", command: "npx tsc -p ." };
const UNIT = {
  name: "unit",
  command: `npx vitest run --reporter=default --reporter=json --outputFile=${VITEST}`,
  count: () => {
    const { numPassedTests, numFailedTests } = passes(VITEST);
    return { passed: numPassedTests, failed: numFailedTests };
  },
};
const BUILD = { name: "build", command: "npm run --silent build" };
const PACKAGE = { name: "package", command: "npm run --silent test:package" };
const BROWSER = {
  name: "browser",
  command: "npm run --silent test:visual -- --reporter=list,json",
  env: { PLAYWRIGHT_JSON_OUTPUT_NAME: PLAYWRIGHT },
  count: () => {
    const { expected, unexpected, flaky } = passes(PLAYWRIGHT).stats;
    return { passed: expected, failed: unexpected + flaky };
  },
};
/** Few looks in other engines and drivers: `npm run test:engines` has them all. */
const ENGINES = {
  name: "engines",
  command: `npm run --silent test:engines -- --short --counts ${COUNTS}`,
  count: () => passes(COUNTS),
};
/** One after the other; what stands side by side runs so, for few of these use both cores. */
const STAGES = [[[LINT], [TYPES]], [[UNIT], [BUILD, PACKAGE]], [[BROWSER]], [[ENGINES]]];

/** Runs a command, and gives its status and what it said, unless that is said at once. */
function run({ command, env = {} }, isAloud) {
  const child = spawn(command, {
    shell: true,
    stdio: isAloud ? "inherit" : ["ignore", "pipe", "pipe"],
    env: { ...process.env, ...env },
  });
  let said = "";
  for (const stream of [child.stdout, child.stderr]) {
    stream?.setEncoding("utf8").on("data", (text) => {
      said += text;
    });
  }
  return new Promise((resolve) => {
    child.on("error", (error) => resolve({ status: 1, said: `${said}${error}\n` }));
    child.on("close", (status) => resolve({ status, said }));
  });
}

function resultOf({ count }, status) {
  try {
    const result = count?.() ?? { passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1 };
    // A runner that dies outside of its tests fails, whatever it counted.
    return status !== 0 && result.failed === 0 ? { ...result, failed: 1 } : result;
  } catch {
    return { passed: 0, failed: 1 };
  }
}

const total = { passed: 0, failed: 0 };
/** @returns whether it is of use to go on: later stages would test the wrong thing after a failed build */
async function check(stage, isAloud) {
  const { name, command } = stage;
  const title = `\n— ${name}: ${command}`;
  if (isAloud) console.log(title);
  const begin = Date.now();
  const { status, said } = await run(stage, isAloud);
  if (!isAloud) console.log(`${title}\n${said}`);
  const { passed, failed } = resultOf(stage, status);
  total.passed += passed;
  total.failed += failed;
  const seconds = ((Date.now() - begin) / 1000).toFixed(1);
  console.log(`— ${name}: ${passed} passed, ${failed} failed in ${seconds} s`);
  return stage !== BUILD || status === 0;
}

async function checkInTurn(stages, isAloud) {
  for (const stage of stages) if (!(await check(stage, isAloud))) return false;
  return true;
}

rmSync(REPORTS, { recursive: true, force: true });
mkdirSync(REPORTS, { recursive: true });
for (const tracks of STAGES) {
  // One speaks as it goes, the others when they end.
  const goesOn = await Promise.all(tracks.map((stages, track) => checkInTurn(stages, track === 0)));
  if (goesOn.includes(false)) break;
}
console.log(`\n${total.passed} passed, ${total.failed} failed`);
process.exit(total.failed > 0 ? 1 : 0);
