/** The tables of docs/performance.md, as Markdown: the bench writes them, and a test compares them. */
import type { Ladder } from "./ladder.ts";
import type { Doing, Passes } from "./passes.ts";
import type { Scaling } from "./scaling.ts";

/** Rows of the table, and the beginnings of the passes' labels: a pass counts towards the first that fits. */
const ROWS: Readonly<Record<string, readonly string[]>> = {
  "shadow map": ["shadow/"],
  "irradiance probes": ["gi/"],
  "G-buffer": ["gbuffer/"],
  "opaque: composite": [
    "opaque/forward-composite",
    "opaque/composite",
    "opaque/reproject",
    "opaque/representative",
    "opaque/upsample",
  ],
  "opaque: forward": ["opaque/forward", "opaque/checkerboard", "mesh/depth", "resolve"],
  "opaque: lighting": [
    "opaque/lighting",
    "opaque/moon-lighting",
    "opaque/sum-lighting",
    "opaque/gather",
  ],
  "volumetric: flame, smoke, haze, particles": ["volumetric/"],
  bloom: ["post/bloom"],
  "temporal upsampling": ["opaque/motion", "opaque/temporal", "post/fxaa", "post/upscale"],
  "exposure, display transform": ["post/"],
};
const TITLES: Readonly<Record<Doing, string>> = {
  stands: "at rest",
  walks: "in motion",
  smokes: "smoke",
};

const row = (cells: readonly string[]) => `| ${cells.join(" | ")} |`;

function table(head: readonly string[], rows: readonly (readonly string[])[]): string {
  return [row(head), `|${"---|".repeat(head.length)}`, ...rows.map(row)].join("\n");
}

export function ladderTable({ steps }: Ladder): string {
  return table(
    ["the paper's Table 1", "ms", "multiple", "the paper's multiple"],
    steps.map(({ name, frameMs, multiple, paperMultiple }) => [
      name,
      frameMs.toFixed(1),
      multiple.toFixed(2),
      paperMultiple.toFixed(2),
    ]),
  );
}

const written = (copies: number) => copies.toFixed(copies < 100 ? 1 : 0);

/** The row that a pass counts towards. */
export function rowOf(pass: string): string {
  const row = Object.entries(ROWS).find(([, begins]) =>
    begins.some((begin) => pass.startsWith(begin)),
  );
  if (!row) throw new Error(`${pass} counts towards no row of the table.`);
  return row[0];
}

/** Passes down, tiers across, in copies. */
export function passTable(scenes: readonly Passes[]): string {
  const rows = Object.keys(ROWS).map((title) => [
    title,
    ...scenes.map(({ passes }) => {
      const ours = passes.filter(({ pass }) => rowOf(pass) === title);
      const sum = ours.reduce((sum, { copies }) => sum + copies, 0);
      return ours.length > 0 ? written(sum) : "";
    }),
  ]);
  return table(
    ["copies", ...scenes.map(({ quality, doing }) => `${quality}, ${TITLES[doing]}`)],
    [
      ...rows,
      ["the frame", ...scenes.map(({ frame }) => written(frame.copies))],
      ["the most expensive frame", ...scenes.map(({ worst }) => written(worst))],
    ],
  );
}

/** Frames of real GPUs, 1920 x 1080. */
export function gpuTable(scenes: readonly Passes[]): string {
  const sum = ({ passes }: Passes, titles: readonly string[]) =>
    passes
      .filter(({ pass }) => titles.includes(rowOf(pass)))
      .reduce((sum, { gpuMs }) => sum + (gpuMs ?? 0), 0);
  const opaque = Object.keys(ROWS).filter((title) => title.startsWith("opaque"));
  return table(
    ["GPU", "frame", "GPU, ms", "at most", "of it opaque", "script, ms", "draws", "memory, MB"],
    scenes.map((scene) => [
      gpuName(scene.renderer),
      [scene.quality, TITLES[scene.doing], scene.lights].filter(Boolean).join(", "),
      scene.frame.gpuMs?.toFixed(2) ?? "",
      scene.worstGpuMs?.toFixed(2) ?? "",
      sum(scene, opaque).toFixed(2),
      scene.scriptMs.toFixed(1),
      String(scene.draws),
      (scene.gpuBytes / 1e6).toFixed(0),
    ]),
  );
}

/** Chromium's name without what is ANGLE's: `ANGLE (vendor, renderer, driver)`. */
function gpuName(renderer: string): string {
  return /^ANGLE \([^,]*, (.*), [^,]*\)$/.exec(renderer)?.[1] ?? renderer;
}

export function scalingTable(cells: readonly Scaling[]): string {
  const [first] = cells;
  return table(
    ["particles", ...(first?.peers.map(({ name }) => name) ?? []), "script, ms", "at best"],
    cells.map(({ count, pixels, peers }) => [
      `${count.toLocaleString("en")} of ${pixels} px`,
      ...peers.map(({ ratio }) => ratio.toFixed(2)),
      (peers[0]?.scriptMs ?? Number.NaN).toFixed(3),
      (peers[0]?.bestScriptMs ?? Number.NaN).toFixed(3),
    ]),
  );
}

/** The page with a table in place of the one whose first cell is the same. */
export function withTable(page: string, table: string): string {
  const begin = page.indexOf(table.slice(0, table.indexOf(" | ", 2) + 3));
  if (begin < 0) throw new Error(`The page has no table for\n${table}`);
  return page.slice(0, begin) + table + page.slice(page.indexOf("\n\n", begin));
}
