import { mkdirSync, writeFileSync } from "node:fs";
import sharp from "sharp";
import { CASE_LIMITS } from "./compare.ts";
import type { Missing } from "./drivers/find.ts";
import { type Verdict, written } from "./judge.ts";
import type { Result } from "./main.ts";
import { READY } from "./survey.ts";

const TABLE = "docs/engines.md";
const SHEET = "docs/shots/engines.jpg";
/** Pixels of a picture on the sheet, and of the line below it. */
const TILE = { width: 320, height: 180, line: 22 } as const;

/** Writes the matrix as Markdown, and the pairs' pictures side by side. */
export async function writeReport(
  results: readonly Result[],
  missing: readonly Missing[],
): Promise<void> {
  mkdirSync("docs/shots", { recursive: true });
  writeFileSync(TABLE, markdown(results, missing));
  await writeSheet(results);
}

function markdown(results: readonly Result[], missing: readonly Missing[]): string {
  const names = [...new Set(results.flatMap(({ verdicts }) => verdicts.map(({ name }) => name)))];
  const header = ["", ...results.map(({ pair }) => pair.title)];
  const rows = names.map((name) => [
    name,
    ...results.map(({ verdicts }) => cell(verdicts.find((one) => one.name === name))),
  ]);
  const faults = results.flatMap(({ pair, verdicts }) =>
    verdicts
      .filter(({ faults }) => faults.length > 0)
      .map(({ name, faults: [first = "", ...others] }) => {
        const more = others.length > 0 ? `, and ${others.length} more` : "";
        return `- ${pair.title}, ${name}: ${first.split("\n")[0]}${more}`;
      }),
  );
  return [
    "# Engines and drivers",
    "",
    "What `npm run test:engines` found, which writes this page. In each cell: seconds to the first frame with all",
    "assets, then how the image differs from that of Chromium on SwiftShader: the mean difference, of 255; the mean",
    "FLIP; and the largest difference of a block's radiance, of 16 x 9. What passes:",
    "",
    row(["", "mean", "FLIP", "block"]),
    row(["---", "---", "---", "---"]),
    ...CASE_LIMITS.map(({ title, limits }) => limitsRow(title, limits)),
    "",
    `The console must be empty, no exception may be thrown, and no wait may be longer than ${READY} s.`,
    "",
    ...results.map(({ pair, version, renderer }) => `- ${pair.title}: ${version}, ${renderer}`),
    ...missing.map(({ name, why }) => `- not tested: ${name} (${why})`),
    "",
    row(header),
    row(header.map(() => "---")),
    ...rows.map(row),
    ...(faults.length > 0 ? ["", "What fails:", "", ...faults] : []),
    "",
    `![One frame of each pair, side by side](${SHEET.replace("docs/", "")})`,
    "",
  ].join("\n");
}

const row = (cells: readonly string[]): string => `| ${cells.join(" | ")} |`;

const limitsRow = (
  what: string,
  limits: Readonly<Record<(typeof PARTS)[number], number>>,
): string => row([what, ...PARTS.map((name) => written(name, limits))]);

function cell(verdict: Verdict | undefined): string {
  if (!verdict) return "not tested";
  const { ready, difference, faults } = verdict;
  const numbers = [
    ...(ready === null ? [] : [`${ready.toFixed(1)} s`]),
    ...(difference ? PARTS.map((name) => written(name, difference)) : []),
  ].join(", ");
  const sign = faults.length > 0 ? "**fails**" : "";
  return [sign, numbers].filter(Boolean).join(" ") || "yes";
}

const PARTS = ["mean", "flip", "block"] as const;

/** Pairs across, cases down. */
async function writeSheet(results: readonly Result[]): Promise<void> {
  const names = [
    "physical, medium",
    "physical, low",
    "paper, medium",
    "original, medium",
    "four candles, medium",
    "advent wreath",
    "lone candle",
  ];
  const [across, down] = [TILE.width, TILE.height + TILE.line];
  const tiles = names.flatMap((name, y) =>
    results.map(async ({ pair, findings }, x) => {
      const sight = findings.find((finding) => finding.name === name)?.sight;
      const label = `<svg width="${TILE.width}" height="${TILE.line}"><text x="6" y="15"
        font-family="sans-serif" font-size="12" fill="#fff">${pair.title}: ${name}</text></svg>`;
      const [left, top] = [x * across, y * down];
      return [
        ...(sight ? [{ input: await tile(sight.png), left, top }] : []),
        { input: Buffer.from(label), left, top: top + TILE.height },
      ];
    }),
  );
  const size = {
    width: across * results.length,
    height: down * names.length,
    channels: 3,
  } as const;
  await sharp({ create: { ...size, background: "#222" } })
    .composite((await Promise.all(tiles)).flat())
    .jpeg({ quality: 80 })
    .toFile(SHEET);
}

function tile(png: Buffer): Promise<Buffer> {
  return sharp(png)
    .flatten({ background: "#fff" })
    .resize(TILE.width, TILE.height, { fit: "cover" })
    .png()
    .toBuffer();
}
