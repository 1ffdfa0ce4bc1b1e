import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import sharp from "sharp";
import { cross, dot, normalized, subtract } from "../models/lathe.mjs";
import { linearFromSrgb, srgbFromLinear } from "./pigment.mjs";

/**
 * Lights a texture set by one small warm lamp, to be looked at before it is accepted:
 *
 *     node tools/textures/preview.mjs logs [folder of pictures]
 *
 * writes NAME-preview.png to the temporary folder: the wall from an angle, a close crop under grazing
 * light, and 2 × 2 tiles in even light, where seams and repetition show.
 */

const textures = fileURLToPath(new URL("../../public/textures/", import.meta.url));

/** CIE illuminant A in linear Rec. 709: candlelight as an adapted eye sees it. */
const LAMP = [1, 0.448, 0.126].map((x) => x / 0.542);
const CHANNELS = 9;

async function pixels(file) {
  const { data, info } = await sharp(file)
    .removeAlpha()
    .raw()
    .toBuffer({ resolveWithObject: true });
  return { data, size: info.width };
}

/** Albedo, normal, occlusion, roughness, metalness interleaved, as a pyramid of halved sizes. */
async function readSet(folder, name, extension) {
  const [albedo, normal, orm] = await Promise.all(
    ["albedo", "normal", "orm"].map((c) => pixels(join(folder, `${name}-${c}.${extension}`))),
  );
  const size = albedo.size;
  const base = new Float32Array(CHANNELS * size * size);
  for (let i = 0; i < size * size; i++) {
    for (let c = 0; c < 3; c++) {
      base[CHANNELS * i + c] = linearFromSrgb(albedo.data[3 * i + c] / 255);
      base[CHANNELS * i + 3 + c] = normal.data[3 * i + c] / 127.5 - 1;
      base[CHANNELS * i + 6 + c] = orm.data[3 * i + c] / 255;
    }
  }
  const levels = [{ size, values: base }];
  while (levels.at(-1).size > 8) levels.push(halved(levels.at(-1)));
  return levels;
}

function halved({ size, values }) {
  const half = size / 2;
  const out = new Float32Array(CHANNELS * half * half);
  for (let row = 0; row < half; row++) {
    for (let column = 0; column < half; column++) {
      for (let c = 0; c < CHANNELS; c++) {
        const at = (r, k) => values[CHANNELS * ((2 * row + r) * size + 2 * column + k) + c];
        out[CHANNELS * (row * half + column) + c] = (at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1)) / 4;
      }
    }
  }
  return { size: half, values: out };
}

const texel = new Float32Array(CHANNELS);

function fetchTexel(levels, u, v, footprint) {
  const level = Math.max(
    0,
    Math.min(levels.length - 1, Math.round(Math.log2(footprint * levels[0].size))),
  );
  const { size, values } = levels[level];
  const x = (u - Math.floor(u)) * size - 0.5;
  const y = (v - Math.floor(v)) * size - 0.5;
  const column = Math.floor(x);
  const row = Math.floor(y);
  const fx = x - column;
  const fy = y - row;
  texel.fill(0);
  for (let k = 0; k < 4; k++) {
    const i = (row + (k >> 1) + size) % size;
    const j = (column + (k & 1) + size) % size;
    const weight = (k & 1 ? fx : 1 - fx) * (k >> 1 ? fy : 1 - fy);
    for (let c = 0; c < CHANNELS; c++) texel[c] += weight * values[CHANNELS * (i * size + j) + c];
  }
  return texel;
}

/** GGX with Schlick's Fresnel and the correlated Smith term (Heitz 2014), one lamp of 1 cd. */
function shade(surface, point, eye, lamp, ambient, out) {
  const normal = normalized(surface.subarray(3, 6));
  const toLamp = subtract(lamp, point);
  const distanceSquared = dot(toLamp, toLamp);
  const light = normalized(toLamp);
  const view = normalized(subtract(eye, point));
  const halfway = normalized([light[0] + view[0], light[1] + view[1], light[2] + view[2]]);
  const NoL = Math.max(0, dot(normal, light));
  const NoV = Math.max(1e-3, dot(normal, view));
  const NoH = Math.max(0, dot(normal, halfway));
  const LoH = Math.max(0, dot(light, halfway));
  const a2 = Math.max(1e-3, surface[7] ** 4);
  const distribution = a2 / (Math.PI * (NoH * NoH * (a2 - 1) + 1) ** 2);
  const visibility =
    0.5 /
    (NoL * Math.sqrt(NoV * NoV * (1 - a2) + a2) +
      NoV * Math.sqrt(NoL * NoL * (1 - a2) + a2) +
      1e-5);
  for (let c = 0; c < 3; c++) {
    const f0 = 0.04 + (surface[c] - 0.04) * surface[8];
    const fresnel = f0 + (1 - f0) * (1 - LoH) ** 5;
    const diffuse = ((1 - surface[8]) * surface[c]) / Math.PI;
    const direct = ((diffuse + distribution * visibility * fresnel) * NoL) / distanceSquared;
    const indirect = (diffuse + 0.5 * f0 * surface[8]) * ambient * surface[6];
    out[c] = LAMP[c] * (direct + indirect);
  }
}

/** The plane z = 0 textured all over, x to the right, y up, in tiles of `tile` metres. */
function render(
  levels,
  tile,
  { width, height, eye, target, fieldOfView, lamp, ambient, exposure },
) {
  const forward = normalized(subtract(target, eye));
  const right = normalized(cross(forward, [0, 1, 1e-4]));
  const up = cross(right, forward);
  const reach = Math.tan((fieldOfView * Math.PI) / 360);
  const picture = Buffer.alloc(3 * width * height);
  const radiance = [0, 0, 0];
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const sum = [0, 0, 0];
      for (let k = 0; k < 4; k++) {
        const sx = (2 * (column + 0.25 + 0.5 * (k & 1))) / width - 1;
        const sy = (1 - (2 * (row + 0.25 + 0.5 * (k >> 1))) / height) * (height / width);
        const ray = forward.map((f, i) => f + reach * (sx * right[i] + sy * up[i]));
        if (ray[2] >= -1e-3) continue;
        const along = -eye[2] / ray[2];
        const point = [eye[0] + along * ray[0], eye[1] + along * ray[1], 0];
        const cosine = -ray[2] / Math.hypot(...ray);
        const footprint = (0.5 * along * 2 * reach) / width / Math.sqrt(cosine) / tile;
        const surface = fetchTexel(levels, point[0] / tile, -point[1] / tile, footprint);
        shade(surface, point, eye, lamp, ambient, radiance);
        for (let c = 0; c < 3; c++) sum[c] += radiance[c] / 4;
      }
      for (let c = 0; c < 3; c++) {
        const x = sum[c] * exposure;
        picture[3 * (row * width + column) + c] = Math.round(255 * srgbFromLinear(filmic(x)));
      }
    }
  }
  return { input: picture, raw: { width, height, channels: 3 } };
}

/** A shoulder that leaves the lower two thirds alone. */
const filmic = (x) => (x < 0.5 ? x : 1 - 0.5 / (1 + (x - 0.5) / 0.5));

export async function preview(name, tile, folder = textures, extension = "avif") {
  const levels = await readSet(folder, name, extension);
  const view = { width: 720, height: 420, fieldOfView: 60 };
  const t = tile;
  const wall = render(levels, t, {
    ...view,
    eye: [0.9 * t, -0.25 * t, 0.95 * t],
    target: [0.35 * t, -0.45 * t, 0],
    lamp: [0.3 * t, -0.55 * t, 0.22 * t],
    ambient: 0.9 / (t * t),
    exposure: 0.42 * t * t,
  });
  const close = render(levels, t, {
    ...view,
    eye: [0.5 * t, -0.62 * t, 0.28 * t],
    target: [0.5 * t, -0.5 * t, 0],
    fieldOfView: 55,
    lamp: [0.38 * t, -0.34 * t, 0.07 * t],
    ambient: 2 / (t * t),
    exposure: 0.17 * t * t,
  });
  const tiled = render(levels, t, {
    width: 720,
    height: 720,
    fieldOfView: 20,
    eye: [t, -t, 5.67 * t],
    target: [t, -t, 0],
    lamp: [-2 * t, 3 * t, 5 * t],
    ambient: 0.03 / (t * t),
    exposure: 75 * t * t,
  });
  const file = join(tmpdir(), `${name}-preview.png`);
  await sharp({ create: { width: 1440, height: 840, channels: 3, background: "black" } })
    .composite([
      { ...wall, left: 0, top: 0 },
      { ...close, left: 0, top: 420 },
      { ...tiled, left: 720, top: 60 },
    ])
    .png()
    .toFile(file);
  return file;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [name, folder, extension] = process.argv.slice(2);
  const { materialNamed } = await import("./materials.mjs");
  const { tile } = materialNamed(name);
  console.log(await preview(name, tile, folder ?? textures, extension ?? "avif"));
}
