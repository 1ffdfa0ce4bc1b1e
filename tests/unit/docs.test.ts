import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, posix } from "node:path";
import sharp from "sharp";
import { describe, expect, test } from "vitest";
import { gpuTable, ladderTable, passTable, rowOf, scalingTable } from "../bench/tables.ts";
import { ANISOTROPIC_LIMITS, DECODED_LIMITS, ULTRA_LIMITS } from "../engines/compare.ts";

const read = (file: string): string => readFileSync(file, "utf8");

const PAGES = [
  ...readdirSync(".").filter((file) => file.endsWith(".md")),
  ...readdirSync("docs", { recursive: true, encoding: "utf8" })
    .filter((file) => file.endsWith(".md"))
    .map((file) => posix.join("docs", file)),
  "public/LICENSES.md",
];

/** What is neither code nor the address of a link. */
const proseOf = (text: string): string =>
  text
    .replaceAll(/^```[\s\S]*?^```/gm, "")
    .replaceAll(/`[^`\n]*`/g, "")
    .replaceAll(/\]\([^)]*\)/g, "]");

/** The tables of a page, as cells; the second row, of dashes, is left out. */
function tablesOf(text: string): string[][][] {
  const blocks = text.match(/^\|.*\|\n\|[-| ]*\|\n(\|.*\|\n?)*/gm) ?? [];
  return blocks.map((block) =>
    block
      .trim()
      .split("\n")
      .filter((_, i) => i !== 1)
      .map((row) =>
        row
          .slice(1, -1)
          .split("|")
          .map((cell) => cell.trim()),
      ),
  );
}

/** An anchor as GitHub makes it of a heading. */
const anchorOf = (heading: string): string =>
  heading
    .toLowerCase()
    .replaceAll(/[^\p{L}\p{N}\- ]/gu, "")
    .replaceAll(" ", "-");

const headingsOf = (text: string): string[] =>
  [...text.matchAll(/^#+ (.*)$/gm)].map(([, heading = ""]) => heading);

test.each(PAGES)("%s links to what there is", (page) => {
  const text = read(page).replaceAll(/^```[\s\S]*?^```/gm, "");
  for (const [, link = ""] of text.matchAll(/\]\(([^)\s]+)\)/g)) {
    if (/^https?:/.test(link)) continue;
    const [path = "", anchor] = link.split("#");
    const file = path === "" ? page : join(dirname(page), path);
    expect.soft(existsSync(file), `${link} in ${page}`).toBe(true);
    if (anchor) expect.soft(headingsOf(read(file)).map(anchorOf), page).toContain(anchor);
  }
});

test.each(["docs/embedding.md", "docs/testing.md"])(
  "%s says that a removal rejects `ready`",
  (page) => {
    expect(read(page).replaceAll(/\s+/g, " ")).toMatch(
      /`ready`[^|]* rejects with an `AbortError`[^.]*, without (an `error`|that) event/,
    );
  },
);

/** Words of our own for what has a name, and words for people that mean none. */
const PRIVATE_WORDS =
  /\b(who walks|what is seen|who plays|pictures?|(re)?paint(s|ed|ing)?|told|guessed|glimpses?|echo(es)?)\b/gi;

test.each(PAGES)("%s uses the terms of the glossary", (page) => {
  const prose = proseOf(read(page)).replaceAll("largest contentful paint", "");
  expect(prose.match(PRIVATE_WORDS) ?? []).toEqual([]);
});

describe("README.md", () => {
  const readme = read("README.md");

  test("is short, with one image and one loop of at most 1.5 MB", () => {
    expect(readme.split("\n").length).toBeLessThanOrEqual(201);
    const images = [...readme.matchAll(/!\[[^\]]*\]\(([^)]*)\)/g)].map(([, file]) => file);
    expect(images).toEqual(["docs/shots/loop.webp", "docs/shots/cabin-table.jpg"]);
    expect(statSync("docs/shots/loop.webp").size).toBeLessThanOrEqual(1_500_000);
  });

  test("has a loop of six seconds that repeats for ever", async () => {
    const { delay = [], loop } = await sharp("docs/shots/loop.webp").metadata();
    expect(delay.reduce((sum, milliseconds) => sum + milliseconds, 0)).toBe(6000);
    expect(loop).toBe(0);
  });

  test("has a row for each demand of the paper, and its tests exist", () => {
    const rows =
      tablesOf(readme)
        .find(([head]) => head?.[0] === "id")
        ?.slice(1) ?? [];
    const ids = "P1 P2 P3 P4 P5 P6 P7 L1 L2 L3 C1 C2 C3 R1 I1 I2 V1 T1 T2 F1 F2 F3 F4 F5";
    expect(rows.map(([id]) => id).toSorted()).toEqual(ids.split(" ").toSorted());
    for (const [id, , files = "", tests = ""] of rows) {
      expect.soft(files, id).not.toBe("");
      let folder = "";
      for (const name of tests.replaceAll(/\([^)]*\)|`[^`]*`/g, "").split(/[,;]/)) {
        const path = name.trim();
        if (path === "") continue;
        if (path.includes("/")) folder = dirname(path);
        const file = `tests/${path.includes("/") ? path : `${folder}/${path}`}`;
        const ends = ["", ".test.ts", ".spec.ts"];
        expect
          .soft(
            ends.some((end) => existsSync(file + end)),
            `${id}: ${file}`,
          )
          .toBe(true);
      }
    }
  });

  test("names the engines that docs/engines.md has figures of", () => {
    const engines = read("docs/engines.md");
    const [head = []] = tablesOf(readme).find(([head]) => head?.[1]?.startsWith("Chromium")) ?? [];
    expect(head).toHaveLength(5);
    for (const engine of head.slice(1)) {
      const [, name = "", version = ""] = /^(\w+)(?: ESR)? ([\d.]+)/.exec(engine) ?? [];
      expect.soft(engines, engine).toMatch(new RegExp(`^- .*: ${name} ${version}\\.`, "m"));
    }
  });

  test("and docs/embedding.md name the oldest browsers of package.json", () => {
    const { browserslist } = JSON.parse(read("package.json")) as { browserslist: string[] };
    for (const page of ["README.md", "docs/embedding.md"]) {
      for (const browser of browserslist.filter((line) => !line.startsWith("ios"))) {
        const [, name, version] = /^(\w+) >= ([\d.]+)$/.exec(browser) ?? [];
        expect.soft(read(page), page).toMatch(new RegExp(`${name} ${version}\\b`, "i"));
      }
    }
  });
});

describe("what is measured", () => {
  const results = JSON.parse(read("docs/bench/results.json"));
  const page = read("docs/performance.md");

  test("the bench's table has a row for each pass of the frame", () => {
    const folders = ["gbuffer", "gi", "opaque", "post", "shadow", "volumetric"];
    const passes = folders.flatMap((folder) =>
      readdirSync(join("shaders", folder))
        .filter((file) => file.endsWith(".frag"))
        .map((file) => `${folder}/${file.replace(".frag", "")}`),
    );
    expect(passes.length).toBeGreaterThan(40);
    for (const pass of passes) expect(() => rowOf(pass), pass).not.toThrow();
  });

  test("docs/performance.md has the tables of docs/bench/*.json", () => {
    expect(page).toContain(ladderTable(results.ladder));
    expect(page).toContain(scalingTable(results.scaling));
    expect(page).toContain(passTable(JSON.parse(read("docs/bench/passes.json"))));
    expect(page).toContain(gpuTable(JSON.parse(read("docs/bench/gpus.json"))));
  });

  test("a multiple printed beside times is that of the times", () => {
    const isTimed = ([head]: string[][]) => head?.includes("ms") && head.includes("multiple");
    const tables = PAGES.flatMap((file) => tablesOf(read(file))).filter(isTimed);
    expect(tables).toHaveLength(1);
    for (const [head = [], ...rows] of tables) {
      const column = (name: string) => rows.map((row) => Number(row[head.indexOf(name)]));
      const [times, multiples] = [column("ms"), column("multiple")];
      for (const [i, time] of times.entries()) {
        const [first = Number.NaN] = times;
        const error = Math.abs((multiples[i] ?? Number.NaN) - time / first);
        // Times are rounded to 0.1, multiples to 0.01.
        expect.soft(error).toBeLessThanOrEqual(0.005 + (0.05 * (1 + time / first)) / first);
      }
    }
  });

  test("limits in prose are those of the tests", () => {
    const numbers = (file: string, pattern: RegExp) => (pattern.exec(read(file)) ?? []).slice(1);
    const [median, high, flip] = numbers(
      "tests/visual/reference.spec.ts",
      /LIMITS = \{ median: ([\d.]+), high: ([\d.]+), flip: ([\d.]+) \}/,
    ).map(Number);
    const limits = tablesOf(read("docs/realism.md")).find(([head]) => head?.[2]?.includes("limit"));
    expect(limits?.slice(1).map((row) => row[2])).toEqual([
      `${100 * (median ?? Number.NaN)} %`,
      `${100 * (high ?? Number.NaN)} %`,
      `${flip}`,
    ]);
    const [code, tarball] = numbers(
      "tools/package-size.mjs",
      /LIMIT = ([\d_]+);\nconst TARBALL_LIMIT = ([\d_]+)/,
    ).map((text) => Number(text.replaceAll("_", "")));
    expect(page).toContain(`below ${(code ?? 0) / 1000} kB gzipped`);
    expect(page).toContain(`below ${(tarball ?? 0) / 1e6} MB`);
  });
});

describe("DECISIONS.md", () => {
  const text = read("DECISIONS.md");
  const entries = text
    .split(/^## /m)
    .slice(1)
    .map((entry) => {
      const [title = "", ...body] = entry.split(/^# /m)[0]?.trim().split("\n") ?? [];
      return { title, body };
    });

  test("has an index of every entry, once", () => {
    const index = text.slice(0, text.indexOf("\n# ", 2));
    const links = [...index.matchAll(/\]\(#([^)]*)\)/g)].map(([, anchor]) => anchor);
    expect(entries.length).toBeGreaterThan(60);
    expect(links).toEqual(entries.map(({ title }) => anchorOf(title)));
  });

  test("has entries of at most eight lines", () => {
    for (const { title, body } of entries) {
      expect.soft(body.length, title).toBeGreaterThanOrEqual(1);
      expect.soft(body.length, title).toBeLessThanOrEqual(8);
      for (const line of body) expect.soft(line.length, title).toBeLessThanOrEqual(128);
    }
  });

  test("gives the limits between engines that the tests have", () => {
    const entry = entries.find(({ title }) => title === "How far engines may differ");
    const prose = entry?.body.join(" ") ?? "";
    expect(prose).toContain(`FLIP may be ${DECODED_LIMITS.flip} `);
    expect(prose).toContain(`FLIP of ${ANISOTROPIC_LIMITS.flip} `);
    expect(prose).toContain(`so ${100 * ULTRA_LIMITS.block} % pass there`);
  });
});
