// npm run reference:sheet: ours, theirs and the difference, view by view, into docs/reference/.
import { readdirSync, readFileSync } from "node:fs";
import sharp from "sharp";
import { FIXTURES, height, readSource, width, withElement } from "./room.mjs";

const SHEET = new URL("../../docs/reference/sheet.jpg", import.meta.url);
const EXPOSURE = 5;
const GAP = 4;
/** Relative difference of luminance at which the colour is full. */
const FULL = 0.5;

const { adaptation, luma } = await readSource("/src/light/color.ts");
const { TAPER } = await readSource("/src/light/flame-light.ts");
const gains = adaptation(TAPER.color);

const half = (bits) => {
  const [exponent, fraction] = [(bits >> 10) & 31, bits & 0x3ff];
  return exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15);
};
const encode = (x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/** As shaders/physical/display.frag. */
function shown(color) {
  const seen = color.map((x, i) => x * gains[i] * EXPOSURE);
  const peak = Math.max(...seen, 1e-9);
  const level = 0.18 * (peak / 0.18) ** 1.35;
  const tone = 1 - Math.exp((-level / (1 + 0.22 * level)) * 1.05);
  const stops = Math.min(Math.max(Math.log2(peak) / 11, 0), 1);
  const bleach = 0.93 * stops * stops * (3 - 2 * stops);
  return seen.map((x) => encode(Math.max(x / peak, 1e-3) ** (1 - bleach) * tone));
}

/** Red where ours is brighter, blue where it is darker. */
function difference(ours, theirs, counts) {
  if (!counts) return [64, 64, 64];
  const share = (luma(ours) - luma(theirs)) / Math.max(luma(theirs), 1e-5) / FULL;
  const amount = Math.round(255 * (1 - Math.min(Math.abs(share), 1)));
  return share > 0 ? [255, amount, amount] : [amount, amount, 255];
}

const files = readdirSync(FIXTURES).filter((file) => file.endsWith(".json"));
const views = files.map((file) => JSON.parse(readFileSync(new URL(file, FIXTURES))));
const pictures = await withElement("high", async (evaluate) => {
  const pictures = [];
  for (const view of views) {
    const radiance = await evaluate((element, { place, camera, width, height }) => {
      element.reset();
      if (place) {
        element.camera = place;
        element.place();
      }
      element.camera = camera;
      element.step(0);
      return Array.from(element.readRadiance(0, 0, width, height));
    }, view);
    const bytes = readFileSync(new URL(`${view.name}.bin`, FIXTURES));
    const columns = [0, 1, 2].map(() => Buffer.alloc(width * height * 3));
    for (let i = 0; i < width * height; i++) {
      const ours = radiance.slice(i * 3, i * 3 + 3);
      const theirs = [0, 1, 2].map((k) => half(bytes.readUInt16LE(i * 6 + k * 2)));
      const counts = bytes.readUInt16LE(i * 6) < 0x8000;
      for (const [column, color] of [
        shown(ours),
        shown(theirs),
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
  .toFile(SHEET.pathname);
