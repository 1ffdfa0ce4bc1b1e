import { mkdirSync } from "node:fs";
import sharp from "sharp";

export interface Tile {
  readonly name: string;
  readonly picture: Buffer;
}

/** Writes pictures of one size in rows, each with its name. */
export async function writeSheet(
  file: string,
  tiles: readonly Tile[],
  columns: number,
): Promise<void> {
  const { width = 0, height = 0 } = await sharp(tiles[0]?.picture).metadata();
  const rows = Math.ceil(tiles.length / columns);
  const overlays = tiles.flatMap(({ name, picture }, i) => {
    const [left, top] = [(i % columns) * width, Math.floor(i / columns) * height];
    const label = `<svg width="${width}" height="24"><text x="8" y="17" font-family="sans-serif"
      font-size="13" fill="#fff" stroke="#000" stroke-width="3" paint-order="stroke">${name}</text></svg>`;
    return [
      { input: picture, left, top },
      { input: Buffer.from(label), left, top: top + height - 24 },
    ];
  });
  const size = { width: width * columns, height: height * rows, channels: 3 } as const;
  mkdirSync("docs/shots", { recursive: true });
  await sharp({ create: { ...size, background: "#000" } })
    .composite(overlays)
    .jpeg({ quality: 86, chromaSubsampling: "4:4:4" })
    .toFile(file);
}
