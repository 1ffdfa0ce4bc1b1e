// npm run reference:sheet: ours, theirs and the difference, view by view, into docs/reference/ or REFERENCES.
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import sharp from "sharp";
import { half } from "./half.mjs";
import { FIXTURES, height, inEachRoom, readSource, width } from "./room.mjs";
import { stageView } from "./stage.mjs";

const SHEET = process.env.REFERENCES
  ? new URL("sheet.jpg", FIXTURES)
  : new URL("../../docs/reference/sheet.jpg", import.meta.url);
const GAP = 4;
/** Relative difference of luminance at which the colour is full. */
const FULL = 0.5;

const { luma } = await readSource("/src/light/color.ts");
const { meteredExposure, shown } = await readSource("/tests/support/display-transform.ts");

/** As the settled eye sees our picture, 8-bit sRGB. */
const displayed = (color, exposure) => shown(color.map((x) => x * exposure)).map(encode);
const encode = (x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/** Red where ours is brighter, blue where it is darker. */
function difference(ours, theirs, counts) {
  if (!counts) return [64, 64, 64];
  const share = (luma(ours) - luma(theirs)) / Math.max(luma(theirs), 1e-5) / FULL;
  const amount = Math.round(255 * (1 - Math.min(Math.abs(share), 1)));
  return share > 0 ? [255, amount, amount] : [amount, amount, 255];
}

const traced = readdirSync(FIXTURES).filter((file) => file.endsWith(".bin"));
const views = traced.map((file) =>
  JSON.parse(readFileSync(new URL(file.replace(".bin", ".json"), FIXTURES))),
);
const pictures = await inEachRoom("high", views, async (views, evaluate) => {
  const pictures = [];
  for (const view of views) {
    await evaluate(stageView, view);
    const radiance = await evaluate(
      (element, { width, height }) => Array.from(element.readRadiance(0, 0, width, height)),
      view,
    );
    const bytes = readFileSync(new URL(`${view.name}.bin`, FIXTURES));
    const exposure = meteredExposure({ width, height, radiance });
    const columns = [0, 1, 2].map(() => Buffer.alloc(width * height * 3));
    for (let i = 0; i < width * height; i++) {
      const ours = radiance.slice(i * 3, i * 3 + 3);
      const theirs = [0, 1, 2].map((k) => half(bytes.readUInt16LE(i * 6 + k * 2) & 0x7fff));
      const counts = bytes.readUInt16LE(i * 6) < 0x8000;
      for (const [column, color] of [
        displayed(ours, exposure),
        displayed(theirs, exposure),
        difference(ours, theirs, counts),
      ].entries()) {
        columns[column].set(color, i * 3);
      }
    }
    pictures.push(columns);
  }
  return pictures;
});

await sharp({
  create: {
    width: 3 * width + 2 * GAP,
    height: pictures.length * (height + GAP) - GAP,
    channels: 3,
    background: "#fff",
  },
})
  .composite(
    pictures.flatMap((columns, row) =>
      columns.map((input, column) => ({
        input,
        raw: { width, height, channels: 3 },
        left: column * (width + GAP),
        top: row * (height + GAP),
      })),
    ),
  )
  .jpeg({ quality: 90 })
  .toFile(fileURLToPath(SHEET));
