import { join } from "node:path";
import sharp from "sharp";

/** The pictures of a set, by the suffix of their file names. */
export const CHANNELS = ["albedo", "normal", "orm"];

// Chroma is never subsampled: it carries slopes and roughness. A normal at less than 85 loses the
// finest strokes although the signal-to-noise ratio still looks well.
const AVIF_QUALITY = { albedo: 60, normal: 85, orm: 65 };

/** Texels along an edge of a map of occlusion, roughness and metal: they change more slowly than colour. */
const LARGEST_ORM = 512;

/** Half as many texels along each edge: the mean of four. */
function halved(pixels, size) {
  const half = size / 2;
  const means = new Uint8Array(3 * half * half);
  for (let i = 0; i < means.length; i++) {
    const texel = Math.floor(i / 3);
    const first = 6 * (size * Math.floor(texel / half) + (texel % half)) + (i % 3);
    const below = first + 3 * size;
    const sum = pixels[first] + pixels[first + 3] + pixels[below] + pixels[below + 3];
    means[i] = Math.round(sum / 4);
  }
  return means;
}

/** Texels, and how many lie along an edge. */
function mapOf(maps, channel) {
  const { resolution } = maps;
  return channel === "orm" && resolution > LARGEST_ORM
    ? { pixels: halved(maps.orm, resolution), size: resolution / 2 }
    : { pixels: maps[channel], size: resolution };
}

/** Writes one set as AVIF. */
export async function writeTextures(folder, name, maps, quality = {}) {
  for (const channel of CHANNELS) {
    const { pixels, size } = mapOf(maps, channel);
    const image = sharp(pixels, { raw: { width: size, height: size, channels: 3 } });
    await image
      .avif({
        quality: quality[channel] ?? AVIF_QUALITY[channel],
        chromaSubsampling: "4:4:4",
        effort: 4,
      })
      .toFile(join(folder, `${name}-${channel}.avif`));
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
