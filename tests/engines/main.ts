import { mkdirSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { type Case, LONG, SHORT } from "./cases.ts";
import { findPairs, PAIRS, type PairName } from "./drivers/find.ts";
import { type Served, serveBuilt } from "./drivers/serve.ts";
import { interact, WHILE_LOADING } from "./interactions.ts";
import { judge, type Verdict, written } from "./judge.ts";
import { writeReport } from "./report.ts";
import { caseMarkup, Session, type Survey, survey } from "./survey.ts";

const REFERENCE: PairName = "chromium-swiftshader";
/** Where draws or queries block the page for longest; the short run tries out keys there. */
const SLOW_DRIVERS: readonly PairName[] = ["chromium-gl", "webkit"];
/**
 * In the matrix each visit is a first one, without the programs that Mesa compiled before. Not in `npm test`: beside
 * other load, compiling alone takes longer than the trial of keys allows.
 */
const COLD = { MESA_SHADER_CACHE_DISABLE: "true", MESA_GLSL_CACHE_DISABLE: "true" };
/** Browsers at work at a time: in the matrix one, since its times are those of a visitor with two cores. */
const LANES = { short: 2, long: 1 } as const;

export interface Options {
  /** The case list of `npm test`, and of the interactions keys while the page loads. */
  readonly isShort: boolean;
  /** What the names of pairs contain; all without one. */
  readonly only?: string | undefined;
  /** What the names of cases match, as a regular expression. */
  readonly cases?: string | undefined;
  /** A file for the numbers of passed and failed cases. */
  readonly counts?: string | undefined;
}

export interface Result extends Survey {
  readonly verdicts: readonly Verdict[];
}

/** Surveys every pair, judges, tells; @returns whether nothing failed */
export async function main({ isShort, only = "", cases = "", counts }: Options): Promise<boolean> {
  if (!isShort) Object.assign(process.env, COLD);
  const wanted = PAIRS.filter((name) => name.includes(only));
  if (wanted.length === 0) throw new Error(`No pair's name has ${only}: ${PAIRS.join(", ")}.`);
  const { pairs, missing } = await findPairs(
    PAIRS.filter((name) => name === REFERENCE || wanted.includes(name)),
  );
  const chosen = (isShort ? SHORT : LONG).filter(({ name }) => new RegExp(cases).test(name));
  const served = await serveBuilt(caseMarkup);
  const sessions = pairs.map((pair) => new Session(pair));
  let surveys: Survey[];
  const trials = new Map<PairName, readonly Verdict[]>();
  try {
    surveys = await inLanes(isShort ? LANES.short : LANES.long, sessions, async (session) => {
      // In the reference's browser `npm test` opens the pages anyway.
      const hasPages = !isShort || session.pair.name !== REFERENCE;
      const own = chosen.filter(({ kind }) => hasPages || kind === "element");
      const found = await surveyOf(session, own, served);
      await session.close();
      return found;
    });
    // Some trials are timed: no other browser works meanwhile.
    for (const session of sessions) {
      const { name } = session.pair;
      if (!wanted.includes(name) || (isShort && !SLOW_DRIVERS.includes(name))) continue;
      const filters = isShort ? [cases, WHILE_LOADING] : [cases];
      trials.set(name, await interact(session, served, filters));
      await session.close();
    }
  } finally {
    await Promise.all(sessions.map((session) => session.close()));
    await served.close();
  }
  const reference = surveys.find(({ pair }) => pair.name === REFERENCE);
  if (!reference) throw new Error("There is no Chromium to compare with.");
  const results: Result[] = [];
  for (const one of surveys.filter(({ pair }) => wanted.includes(pair.name))) {
    const verdicts = [...(await judge(one, reference)), ...(trials.get(one.pair.name) ?? [])];
    results.push({ ...one, verdicts });
    tell(one, verdicts);
  }
  for (const { name, why } of missing) console.log(`not tested: ${name} (${why})`);
  const all = results.flatMap(({ verdicts }) => verdicts);
  const failed = all.filter(({ faults }) => faults.length > 0).length;
  const passed = all.length - failed;
  if (counts) {
    mkdirSync(dirname(counts), { recursive: true });
    writeFileSync(counts, JSON.stringify({ passed, failed }));
  }
  const isWhole = !isShort && !only && !cases;
  if (isWhole) await writeReport(results, missing);
  console.log(`${passed} passed, ${failed} failed`);
  // Beside what each pair is: nothing had the name that was asked for, or could be had.
  const isIdle = results.every(({ verdicts }) => verdicts.length === 1);
  if (isIdle) console.log("Nothing was tested.");
  return failed === 0 && !isIdle;
}

async function surveyOf(session: Session, cases: readonly Case[], served: Served): Promise<Survey> {
  const { pair } = session;
  const begin = performance.now();
  const seconds = () => `${((performance.now() - begin) / 1000).toFixed(1)} s`;
  try {
    const { version, renderer } = await session.use(async (visitor) => ({
      version: visitor.version,
      renderer: await pair.renderer(visitor),
    }));
    console.log(`${pair.name}: ${version}, ${renderer} (${seconds()})`);
    const findings = await survey(session, cases, served, ({ name }) =>
      console.log(`  ${pair.name}: ${name} (${seconds()})`),
    );
    return { pair, version, renderer, findings };
  } catch (error) {
    const failure = String(error);
    const nothing = { ready: null, complaints: [], failure, sight: null };
    const findings = cases.map(({ name }) => ({ name, ...nothing }));
    return { pair, version: "", renderer: failure, findings };
  }
}

function tell({ pair }: Survey, verdicts: readonly Verdict[]): void {
  for (const { name, ready, difference, faults } of verdicts) {
    const numbers = [
      ...(ready === null ? [] : [`ready ${ready.toFixed(1)} s`]),
      ...(difference
        ? [
            `mean ${written("mean", difference)}`,
            `FLIP ${written("flip", difference)}`,
            `block ${written("block", difference)}`,
          ]
        : []),
    ];
    console.log(
      `${faults.length > 0 ? "FAIL" : "ok  "} ${pair.name}: ${[name, ...numbers].join(", ")}`,
    );
    for (const fault of faults) console.log(`       ${fault}`);
  }
}

/** Does something with each, so many at a time; results are in order. */
async function inLanes<Item, Result>(
  lanes: number,
  items: readonly Item[],
  run: (item: Item) => Promise<Result>,
): Promise<Result[]> {
  const results: Result[] = [];
  const queue = [...items.entries()];
  const lane = async () => {
    for (let next = queue.shift(); next; next = queue.shift()) {
      const [i, item] = next;
      results[i] = await run(item);
    }
  };
  await Promise.all(Array.from({ length: lanes }, lane));
  return results;
}
