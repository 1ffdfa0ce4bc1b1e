import { CASE_LIMITS, compare, type Difference, meanOf } from "./compare.ts";
import { type Finding, READY, type Survey } from "./survey.ts";

/** A case in a pair, and what is wrong with it. */
export interface Verdict {
  readonly name: string;
  readonly ready: number | null;
  readonly difference: Difference | null;
  readonly faults: readonly string[];
}

/** What of a page's pixels are brighter than black, at least, of 255 in the mean. */
const DARKEST = 2;

/** Judges what a pair made of each case, beside the reference's pictures. */
export async function judge(survey: Survey, reference: Survey): Promise<Verdict[]> {
  const { pair, renderer, findings } = survey;
  const isExpected = pair.expected.test(renderer);
  const identity: Verdict = {
    name: "draws by what it says",
    ready: null,
    difference: null,
    faults: isExpected ? [] : [`the renderer is "${renderer}", not ${pair.expected}`],
  };
  const verdicts = findings.map((finding) => {
    const other = reference.findings.find(({ name }) => name === finding.name);
    return judgeCase(finding, survey === reference ? null : (other ?? null), survey === reference);
  });
  return [identity, ...(await Promise.all(verdicts))];
}

async function judgeCase(
  finding: Finding,
  other: Finding | null,
  isReference: boolean,
): Promise<Verdict> {
  const { name, ready, complaints, failure, sight } = finding;
  const faults = [...(failure ? [failure] : []), ...complaints];
  if (ready !== null && ready > READY) faults.push(`ready after ${ready.toFixed(1)} s`);
  let difference: Difference | null = null;
  if (sight) {
    if (sight.blocks.length === 0 || isReference) {
      const mean = await meanOf(sight.png);
      if (mean < DARKEST)
        faults.push(`the picture is black: ${mean.toFixed(2)} of 255 in the mean`);
    } else if (other?.sight) {
      difference = await compare(other.sight, sight);
      faults.push(...excess(name, difference));
    } else {
      faults.push("there is no picture of the reference to compare with");
    }
  }
  return { name, ready, difference, faults };
}

const MEASURES = ["mean", "flip", "block"] as const;
type Measure = (typeof MEASURES)[number];

const TITLES: Readonly<Record<Measure, string>> = {
  mean: "the mean difference",
  flip: "FLIP",
  block: "the worst block's difference",
};

function excess(title: string, difference: Difference): string[] {
  const limits = CASE_LIMITS.find(({ cases }) => cases.test(title))?.limits;
  if (!limits) throw new Error(`There are no limits for ${title}.`);
  return MEASURES.filter((name) => !(difference[name] <= limits[name])).map((name) => {
    const where = name === "block" ? ` (${difference.where})` : "";
    return `${TITLES[name]} is ${written(name, difference)}, not ${written(name, limits)}${where}`;
  });
}

/** A difference as one reads it. */
export function written(name: Measure, difference: Readonly<Record<Measure, number>>): string {
  const value = difference[name];
  if (name === "block") return `${(value * 100).toFixed(1)} %`;
  return value.toFixed(name === "mean" ? 2 : 3);
}
