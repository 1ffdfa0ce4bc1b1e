import { join } from "node:path";
import sharp from "sharp";

/** The pictures of a set, by the suffix of their file names. */
export const CHANNELS = ["albedo", "normal", "orm"];

// Chroma is never subsampled: it carries slopes and roughness. A normal at less than 85 loses the
// finest strokes although the signal-to-noise ratio still looks well.
const AVIF_QUALITY = { albedo: 60, normal: 85, orm: 65 };
const JPEG_QUALITY = { albedo: 86, normal: 90, orm: 86 };

/** Writes one set as AVIF, and as JPEG for browsers that cannot read it. */
export async function writeTextures(folder, name, maps, quality = {}) {
  const raw = { width: maps.resolution, height: maps.resolution, channels: 3 };
  for (const channel of CHANNELS) {
    const image = sharp(maps[channel], { raw });
    const file = join(folder, `${name}-${channel}`);
    await image
      .clone()
      .avif({
        quality: quality[channel] ?? AVIF_QUALITY[channel],
        chromaSubsampling: "4:4:4",
        effort: 4,
      })
      .toFile(`${file}.avif`);
    await image
      .clone()
      .jpeg({ quality: JPEG_QUALITY[channel], chromaSubsampling: "4:4:4", mozjpeg: true })
      .toFile(`${file}.jpg`);
  }
}

/** Writes one set without loss, for tests and for looking at. */
export async function writeLossless(folder, name, maps) {
  const raw = { width: maps.resolution, height: maps.resolution, channels: 3 };
  for (const channel of CHANNELS) {
    await sharp(maps[channel], { raw })
      .png({ compressionLevel: 9 })
      .toFile(join(folder, `${name}-${channel}.png`));
  }
}
