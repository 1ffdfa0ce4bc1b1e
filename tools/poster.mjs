// npm run poster: the pictures that the hosted page opens on, of its own first view, drawn by the page
// itself as it is built. `node tools/poster.mjs wide` makes that one alone.
import { writeFile } from "node:fs/promises";
import sharp from "sharp";
import { makePoster } from "../bin/poster.mjs";
import { serveBuilt } from "./built-site.mjs";
import { chosenNames } from "./chosen-names.mjs";
import { findBrowser } from "./find-browser.mjs";

/**
 * The view is as high as the window, or as wide where that is upright (src/render/camera.ts), so a window shows
 * a part of any poster that is longer. Five, since the exposure follows the frame: of a window half as
 * long a poster would be too bright. index.html says which is when.
 */
const POSTERS = [
  { name: "landscape", width: 1600, height: 900 },
  { name: "wide", width: 2400, height: 900 },
  { name: "short", width: 1200, height: 900 },
  { name: "upright", width: 960, height: 1440 },
  { name: "portrait", width: 900, height: 2000 },
];
/** Bytes */
const MOST = 90_000;
const QUALITIES = [60, 55, 50, 45, 40, 35];

/** The best that is small enough. */
async function compressed(picture) {
  for (const quality of QUALITIES) {
    const file = await sharp(picture)
      .removeAlpha()
      .avif({ quality, effort: 5, chromaSubsampling: "4:2:0" })
      .toBuffer();
    if (file.length <= MOST) return { file, quality };
  }
  throw new Error(`No quality makes it smaller than ${MOST} bytes.`);
}

const wanted = chosenNames(POSTERS.map(({ name }) => name));
const { path } = await findBrowser();
const server = await serveBuilt();
for (const { name, width, height } of POSTERS) {
  if (!wanted.includes(name)) continue;
  const picture = await makePoster({
    url: server.url,
    size: `${width}x${height}`,
    out: "poster.png",
    browser: path,
  });
  const { file, quality } = await compressed(picture);
  await writeFile(`src/page/posters/${name}.avif`, file);
  console.log(`${name}: ${width} x ${height}, ${(file.length / 1000).toFixed(1)} kB at ${quality}`);
}
await server.close();
