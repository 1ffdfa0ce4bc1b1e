import { readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import sharp from "sharp";
import { makePoster } from "../../bin/poster.mjs";
import { GlbBuilder } from "../models/glb-builder.mjs";

/**
 * Draws a texture set on a wall by candlelight, to be looked at before it is accepted. Needs `npm run build`.
 *
 *     node tools/textures/preview.mjs logs [folder of images] [their extension]
 *
 * writes NAME-preview.png to the temporary folder: the wall from an angle, close under grazing light, and
 * many tiles from afar, where seams and repetition show.
 */

const [name, folder, extension = "avif"] = process.argv.slice(2);
const textures = folder ?? fileURLToPath(new URL("../../public/textures/", import.meta.url));

/** Of the wall, whose 4 x 4 tiles are as large in every set. Metres. */
const HALF_WIDTH = 3.2;
/** Camera from which the candle is put down, and camera of the image: position, yaw and pitch. */
const VIEWS = [
  ["0.3 1.6 1.3 0 -1", "1.4 1.3 1.5 0.6 -0.15"],
  ["0 1.6 0.95 0 -1.2", "0.35 0.6 0.6 0.5 -0.2"],
  ["0 1.6 2.6 0 -1", "0 1.6 3.1 0 0"],
];

/** A wall of the set, and a plain floor before it. */
function room() {
  const builder = new GlbBuilder();
  const texture = (channel) => {
    const bytes = readFileSync(join(textures, `${name}-${channel}.${extension}`));
    const image = { bufferView: builder.view(bytes), mimeType: `image/${extension}` };
    return { index: builder.add("textures", { source: builder.add("images", image) }) };
  };
  const orm = texture("orm");
  const covered = builder.add("materials", {
    pbrMetallicRoughness: { baseColorTexture: texture("albedo"), metallicRoughnessTexture: orm },
    occlusionTexture: orm,
    normalTexture: texture("normal"),
  });
  const rectangle = (positions, normal, material) => {
    const floats = (values, size) => builder.accessor(Float32Array.from(values), size);
    const uvs = [0, 4, 4, 4, 4, 0, 0, 0];
    const attributes = {
      POSITION: floats(positions, 3),
      NORMAL: floats([...normal, ...normal, ...normal, ...normal], 3),
      TEXCOORD_0: floats(uvs, 2),
    };
    const indices = builder.accessor(Uint16Array.from([0, 1, 2, 0, 2, 3]), 1);
    const primitives = [{ attributes, indices, material }];
    builder.root({ mesh: builder.add("meshes", { primitives }) });
  };
  const [low, high] = [-HALF_WIDTH, HALF_WIDTH];
  rectangle([low, low, 0, high, low, 0, high, high, 0, low, high, 0], [0, 0, 1], covered);
  rectangle([low, 0, HALF_WIDTH, high, 0, HALF_WIDTH, high, 0, 0, low, 0, 0], [0, 1, 0]);
  return builder.glb();
}

const src = join(tmpdir(), `${name}-room.glb`);
writeFileSync(src, room());
const images = [];
for (const [candle, camera] of VIEWS) {
  const view = { candle, camera, seconds: "0.1", attributes: { src } };
  const input = await makePoster({ out: "view.png", size: "720x420", ...view });
  images.push({ input, left: 0, top: 420 * images.length });
}
const file = join(tmpdir(), `${name}-preview.png`);
await sharp({ create: { width: 720, height: 1260, channels: 3, background: "black" } })
  .composite(images)
  .png()
  .toFile(file);
console.log(file);
