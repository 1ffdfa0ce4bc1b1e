import { describe, expect, test } from "vitest";
import { filesIn, textOf } from "./sources.ts";

interface Row {
  readonly pass: string;
  readonly tiers: string;
  readonly costs: readonly string[];
}

const ROWS: readonly Row[] = textOf("docs/frame.md")
  .split("\n")
  .filter((line) => /^\| [a-z]+\//.test(line))
  .map((line) => {
    const [pass = "", tiers = "", , , , ...costs] = line
      .slice(1, -1)
      .split("|")
      .map((cell) => cell.trim());
    return { pass, tiers, costs };
  });

const SHADERS: ReadonlySet<string> = new Set(
  filesIn("shaders", /\.(frag|vert)$/).map((file) => file.replace(/^shaders\/|\.\w+$/g, "")),
);

/** Programs of the physical look, named by their shaders, and the files that make them. */
const PROGRAMS: ReadonlyMap<string, string> = new Map(
  filesIn("src/render", /\.ts$/)
    .filter((file) => !/paper-renderer|lone-candle|speed/.test(file))
    .flatMap((file) =>
      Array.from(
        textOf(file).matchAll(/"([\w-]+\/[\w-]+)"/g),
        ([, label = ""]) => [label, file] as const,
      ),
    )
    .filter(([label]) => SHADERS.has(label)),
);

interface Measured {
  readonly quality: string;
  readonly doing: string;
  readonly passes: readonly { readonly pass: string; readonly copies: number }[];
}

describe("docs/frame.md", () => {
  test("has a row for each program of the physical look, and no other", () => {
    expect(ROWS.map(({ pass }) => pass).toSorted()).toEqual([...PROGRAMS.keys()].toSorted());
  });

  test("gives passes that only one opaque stage makes to its tiers", () => {
    const quality = textOf("src/render/quality.ts");
    const tiersOf = (stage: string) =>
      Array.from(quality.matchAll(/name: "(\w+)"[\s\S]*?opaque: "(\w+)"/g))
        .filter(([, , opaque]) => opaque === stage)
        .map(([, name]) => name)
        .join(", ");
    const expected = { deferred: tiersOf("deferred"), forward: tiersOf("forward") };
    for (const { pass, tiers } of ROWS) {
      const file = PROGRAMS.get(pass) ?? "";
      const stage = /gbuffer\/|deferred-stage|lighting-pass|composite-display/.test(file)
        ? "deferred"
        : /forward-stage/.test(file)
          ? "forward"
          : null;
      if (stage) expect.soft(tiers, pass).toBe(`${stage}: ${expected[stage]}`);
    }
  });

  test("quotes the costs that the bench has measured", () => {
    const measured = JSON.parse(textOf("docs/bench/passes.json")) as Measured[];
    const columns = [
      ["low", "walks"],
      ["medium", "stands"],
      ["high", "stands"],
    ] as const;
    for (const { pass, costs } of ROWS) {
      const expected = columns.map(([quality, doing]) => {
        const frame = measured.find((run) => run.quality === quality && run.doing === doing);
        const copies = frame?.passes.find((entry) => entry.pass === pass)?.copies;
        return copies === undefined ? "–" : copies.toFixed(1);
      });
      expect.soft(costs, pass).toEqual(expected);
    }
  });

  test("follows a renderer whose frame fits on one screen", () => {
    const renderer = textOf("src/render/physical-renderer.ts");
    const [body = ""] = /^ {2}\*#draw\([\s\S]*?^ {2}\}/m.exec(renderer) ?? [];
    expect(body.split("\n").length).toBeLessThanOrEqual(40);
    const order = [
      "#opaque.fillGBuffer",
      "#captures.update",
      "#opaque.shade",
      "#composite(",
      "#updatePost",
      "#present",
    ];
    const places = order.map((call) => body.indexOf(call));
    expect(places).not.toContain(-1);
    expect(places).toEqual(places.toSorted((a, b) => a - b));
  });
});
