import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import type { FullResult, Reporter, TestCase, TestResult } from "playwright/types/testReporter";
import { barChart } from "../../tools/chart.mjs";
import type { Ladder } from "./ladder.ts";
import type { Passes } from "./passes.ts";
import type { Scaling } from "./scaling.ts";
import { gpuTable, ladderTable, passTable, scalingTable, withTable } from "./tables.ts";

const FOLDER = "docs/bench";
const PAGE = "docs/performance.md";

interface Results {
  readonly ladder: Ladder;
  readonly scaling: readonly Scaling[];
}

/** Writes what the bench measured as JSON, as charts and as tables, and prints the tables. */
export default class Report implements Reporter {
  #ladder: Ladder | null = null;
  readonly #scaling: Scaling[] = [];
  readonly #passes: Passes[] = [];
  readonly #onGpu: Passes[] = [];

  onTestEnd(_test: TestCase, { attachments }: TestResult): void {
    for (const { name, body } of attachments) {
      if (name === "ladder") this.#ladder = JSON.parse(String(body)) as Ladder;
      if (name === "passes") this.#passes.push(...(JSON.parse(String(body)) as Passes[]));
      if (name === "gpu") this.#onGpu.push(...(JSON.parse(String(body)) as Passes[]));
      if (name === "scaling") this.#scaling.push(JSON.parse(String(body)) as Scaling);
    }
  }

  onEnd({ startTime }: FullResult): void {
    mkdirSync(FOLDER, { recursive: true });
    this.#reportPasses();
    this.#reportGpu();
    this.#reportParticles(startTime);
  }

  #reportPasses(): void {
    if (this.#passes.length === 0) return;
    writeTables(passTable(update("passes.json", this.#passes, sceneOf)));
  }

  #reportGpu(): void {
    if (this.#onGpu.length === 0) return;
    writeTables(
      gpuTable(update("gpus.json", this.#onGpu, (one) => [one.renderer, ...sceneOf(one)])),
    );
  }

  /** What was not measured this time stays as it was. */
  #reportParticles(startTime: Date): void {
    if (!this.#ladder && this.#scaling.length === 0) return;
    const file = `${FOLDER}/results.json`;
    const before = JSON.parse(readFileSync(file, "utf8")) as Results;
    const ladder = this.#ladder ?? before.ladder;
    const scaling = merged(before.scaling, this.#scaling, ({ count, pixels }) => [count, pixels]);
    const machine = {
      cores: cpus().length,
      model: cpus()[0]?.model,
      date: startTime.toISOString().slice(0, 10),
    };
    writeFileSync(file, `${JSON.stringify({ machine, ladder, scaling }, null, 2)}\n`);
    writeTables(ladderTable(ladder), scalingTable(scaling));
    writeFileSync(
      `${FOLDER}/ladder.svg`,
      barChart({
        title: "What each technique costs",
        unit: "multiples of the room without particles",
        series: ["here", "the paper"],
        rows: ladder.steps.map(({ name, multiple, paperMultiple }) => ({
          label: name,
          values: [multiple, paperMultiple],
        })),
      }),
    );
    writeFileSync(
      `${FOLDER}/scaling.svg`,
      barChart({
        title: "Time of a frame of particles",
        unit: "ratio to the transform feedback control",
        series: scaling[0]?.peers.map(({ name }) => name) ?? [],
        rows: scaling.map(({ count, pixels, peers }) => ({
          label: `${count.toLocaleString("en")} of ${pixels} px`,
          values: peers.map(({ ratio }) => ratio),
        })),
      }),
    );
  }
}

const sceneOf = ({ quality, doing, lights }: Passes) => [quality, doing, lights];

/** What was measured, in its place among what was measured before. */
function merged<T>(before: readonly T[], measured: readonly T[], keyOf: (one: T) => unknown[]) {
  const all = [...before, ...measured].map((one) => [JSON.stringify(keyOf(one)), one] as const);
  return [...new Map(all).values()];
}

/** Writes the frames that were measured; all others of the file stay as they were. */
function update(name: string, measured: readonly Passes[], keyOf: (one: Passes) => unknown[]) {
  const file = `${FOLDER}/${name}`;
  const all = merged(JSON.parse(readFileSync(file, "utf8")) as Passes[], measured, keyOf);
  writeFileSync(file, `${JSON.stringify(all, null, 2)}\n`);
  return all;
}

function writeTables(...tables: readonly string[]): void {
  writeFileSync(PAGE, tables.reduce(withTable, readFileSync(PAGE, "utf8")));
  console.log(tables.join("\n\n"));
}
