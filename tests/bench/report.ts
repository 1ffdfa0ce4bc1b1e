import { mkdirSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import type { FullResult, Reporter, TestCase, TestResult } from "playwright/types/testReporter";
import { barChart } from "../../tools/chart.mjs";
import type { Ladder } from "./ladder.ts";
import type { PassCost, Passes } from "./passes.ts";
import type { Scaling } from "./scaling.ts";

const FOLDER = "docs/bench";

/** Prints what the bench measured, and keeps it as JSON and as charts. */
export default class Report implements Reporter {
  #ladder: Ladder | null = null;
  readonly #scaling: Scaling[] = [];
  readonly #passes: Passes[] = [];

  onTestEnd(_test: TestCase, { attachments }: TestResult): void {
    for (const { name, body } of attachments) {
      if (name === "ladder") this.#ladder = JSON.parse(String(body)) as Ladder;
      if (name === "passes") this.#passes.push(...(JSON.parse(String(body)) as Passes[]));
      if (name === "scaling") this.#scaling.push(JSON.parse(String(body)) as Scaling);
    }
  }

  onEnd({ startTime }: FullResult): void {
    this.#reportPasses();
    const ladder = this.#ladder;
    if (!ladder || this.#scaling.length === 0) return;
    mkdirSync(FOLDER, { recursive: true });
    const machine = {
      cores: cpus().length,
      model: cpus()[0]?.model,
      date: startTime.toISOString().slice(0, 10),
    };
    const results = { machine, ladder, scaling: this.#scaling };
    writeFileSync(`${FOLDER}/results.json`, `${JSON.stringify(results, null, 2)}\n`);
    const steps = ladder.steps.map(({ name, frameMs, multiple, paperMultiple }) => ({
      step: name,
      ms: Number(frameMs.toFixed(1)),
      multiple: Number(multiple.toFixed(2)),
      paper: Number(paperMultiple.toFixed(2)),
    }));
    console.table(steps);
    const rows = this.#scaling.map(({ count, pixels, peers }) => ({
      label: `${count.toLocaleString("en")} of ${pixels} px`,
      values: peers.map(({ ratio }) => ratio),
    }));
    console.table(
      this.#scaling.flatMap(({ count, pixels, peers }) =>
        peers.map(({ name, frameMs, ratio, scriptMs, bestScriptMs }) => ({
          particles: `${count} x ${pixels} px`,
          peer: name,
          "frame ms": Number(frameMs.toFixed(2)),
          ratio: Number(ratio.toFixed(2)),
          "script ms": Number(scriptMs.toFixed(3)),
          "at best": Number(bestScriptMs.toFixed(3)),
        })),
      ),
    );
    writeFileSync(
      `${FOLDER}/ladder.svg`,
      barChart({
        title: "What each technique costs",
        unit: "multiples of the room without particles",
        series: ["here", "the paper"],
        rows: steps.map(({ step, multiple, paper }) => ({
          label: step,
          values: [multiple, paper],
        })),
      }),
    );
    writeFileSync(
      `${FOLDER}/scaling.svg`,
      barChart({
        title: "Time of a frame of particles",
        unit: "ratio to the transform feedback control",
        series: this.#scaling[0]?.peers.map(({ name }) => name) ?? [],
        rows,
      }),
    );
  }

  /** Passes down, tiers across, in copies: as the README has it. */
  #reportPasses(): void {
    if (this.#passes.length === 0) return;
    mkdirSync(FOLDER, { recursive: true });
    writeFileSync(`${FOLDER}/passes.json`, `${JSON.stringify(this.#passes, null, 2)}\n`);
    const names = new Set(this.#passes.flatMap(({ passes }) => passes.map(({ pass }) => pass)));
    const cell = (cost: PassCost | undefined) => {
      if (!cost) return "";
      const { copies, gpuMs } = cost;
      return `${copies.toFixed(1)}${gpuMs === null ? "" : ` (${gpuMs.toFixed(2)} ms)`}`;
    };
    const head = this.#passes.map(({ quality, doing, width, height }) =>
      [quality, doing, `${width} x ${height}`].join(", "),
    );
    const rows = [...names].map((name) => [
      name,
      ...this.#passes.map(({ passes }) => cell(passes.find(({ pass }) => pass === name))),
    ]);
    const lines = [
      ["copies", ...head],
      head.concat("").map(() => "---"),
      ...rows,
      ["the frame", ...this.#passes.map(({ frame }) => cell(frame))],
      ["the dearest", ...this.#passes.map(({ worst }) => worst.toFixed(1))],
    ];
    console.log(lines.map((line) => `| ${line.join(" | ")} |`).join("\n"));
  }
}
