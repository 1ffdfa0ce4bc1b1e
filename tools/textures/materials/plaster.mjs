import {
  bell,
  cellular,
  clamp,
  fractalNoise,
  mix,
  noise,
  randomStream,
  smoothstep,
  tiledNoise,
} from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/** Lime plaster laid on by hand and limewashed more than once: trowel strokes, brush marks, hairlines. */

const TILE = 2000;
const STROKES = 300;

const LIME = pigment(0xccc7ba);
const FRESH = pigment(0xd8d5cb);
const BARE = pigment(0xb5a993);
const STAIN = [0.8, 0.73, 0.6];
const SMOKE = [0.66, 0.64, 0.61];

/**
 * The coat as the trowel left it, on its own grid: each stroke a shallow tilted face with drag lines and
 * a burr of squeezed-out plaster along one edge, later strokes lying over earlier ones. `burnish` is how
 * hard the blade pressed, which closes the surface.
 */
function trowel(resolution, seed) {
  const texelSize = TILE / resolution;
  const coat = new Float32Array(resolution * resolution);
  const burnish = new Float32Array(resolution * resolution);
  for (let stroke = 0; stroke < STROKES; stroke++) {
    const next = randomStream(stroke, seed * 31);
    const centreX = next(0, TILE);
    const centreY = next(0, TILE);
    const angle = next(-1.1, 1.1) + (next() < 0.5 ? 0 : next(0, Math.PI / 2));
    const halfLength = next(140, 400);
    const halfWidth = next(38, 88);
    const bend = next(-0.7, 0.7) / halfLength;
    const depth = next(0.35, 0.95);
    const pressure = next(0.4, 1);
    const cosine = Math.cos(angle);
    const sine = Math.sin(angle);
    const reach = Math.hypot(halfLength, halfWidth * 1.2);
    const bow = Math.abs(bend) * halfLength * halfLength;
    const rows = Math.ceil((reach + bow) / texelSize);
    const column0 = Math.round(centreX / texelSize);
    const row0 = Math.round(centreY / texelSize);
    for (let row = row0 - rows; row <= row0 + rows; row++) {
      for (let column = column0 - rows; column <= column0 + rows; column++) {
        const dx = column * texelSize - centreX;
        const dy = row * texelSize - centreY;
        const s = dx * cosine + dy * sine;
        if (Math.abs(s) > halfLength) continue;
        const t = dy * cosine - dx * sine + bend * s * s;
        const across = t / halfWidth;
        if (Math.abs(across) > 1.2) continue;
        const wrapped =
          (((row % resolution) + resolution) % resolution) * resolution +
          (((column % resolution) + resolution) % resolution);
        const ends = 1 - smoothstep(0.55, 1, Math.abs(s) / halfLength);
        const face = 1 - smoothstep(0.8, 1, Math.abs(across));
        const drag =
          0.12 * noise(t / 3.4, s / 160, seed + stroke) +
          0.09 * noise(t / 7.5, s / 300, seed + stroke + 9);
        const burr =
          bell(across - 0.93, 0.05) * (0.5 + 0.5 * noise(s / 35, 1.5, seed + stroke + 500));
        coat[wrapped] = mix(
          coat[wrapped],
          depth * (0.35 + 0.35 * across) + drag,
          0.75 * face * ends,
        );
        coat[wrapped] += 0.42 * burr * ends;
        burnish[wrapped] = mix(burnish[wrapped], pressure, 0.6 * face * ends);
      }
    }
  }
  return {
    coat,
    burnish,
    at: (x, y) => bilinear(x / texelSize - 0.5, y / texelSize - 0.5, resolution),
  };
}

const tap = { indices: [0, 0, 0, 0], weights: [0, 0, 0, 0] };

function bilinear(column, row, size) {
  const x = Math.floor(column);
  const y = Math.floor(row);
  for (let k = 0; k < 4; k++) {
    tap.indices[k] = ((y + (k >> 1) + size) % size) * size + ((x + (k & 1) + size) % size);
    tap.weights[k] = (k & 1 ? column - x : 1 - column + x) * (k >> 1 ? row - y : 1 - row + y);
  }
  return tap;
}

function read(field, { indices, weights }) {
  let sum = 0;
  for (let k = 0; k < 4; k++) sum += weights[k] * field[indices[k]];
  return sum;
}

/** Hairline cracks: borders of a few large cells, with finer ones only beside them. */
function crackle(u, v, seed) {
  const bend =
    0.16 * fractalNoise(u * 9, v * 9, seed, 3, 9, 9) +
    0.02 * noise(u * 70, v * 70, seed + 1, 70, 70);
  const sway =
    0.16 * fractalNoise(u * 9, v * 9, seed + 2, 3, 9, 9) +
    0.02 * noise(u * 70, v * 70, seed + 3, 70, 70);
  const where = smoothstep(0.12, 0.42, fractalNoise(u * 3, v * 3, seed + 4, 3, 3, 3));
  if (where === 0) return 0;
  const thin = 0.55 + 0.45 * noise(u * 40, v * 40, seed + 5, 40, 40);
  const main = cellular(u * 4 + bend, v * 4 + sway, seed + 6, 4, 4, 1);
  const border = main.second - main.nearest;
  const fine = cellular(u * 11 + 2 * bend, v * 11 + 2 * sway, seed + 7, 11, 11, 1);
  const beside = smoothstep(0.16, 0.02, border);
  return (
    where *
    Math.max(
      smoothstep(0.007 * thin, 0.001, border),
      0.6 * beside * smoothstep(0.012 * thin, 0.002, fine.second - fine.nearest),
    )
  );
}

const PITS = [
  { cells: 40, share: 0.08, depth: 1 },
  { cells: 90, share: 0.11, depth: 0.6 },
  { cells: 170, share: 0.12, depth: 0.3 },
];

/** Burst air bubbles, in patches. */
function pitDepth(u, v, seed) {
  const where = smoothstep(-0.1, 0.4, fractalNoise(u * 5, v * 5, seed, 3, 5, 5));
  if (where === 0) return 0;
  let deepest = 0;
  for (const { cells, share, depth } of PITS) {
    const ragged = 0.2 * noise(u * cells * 2, v * cells * 2, seed + cells, cells * 2, cells * 2);
    const bubble = cellular(u * cells + ragged, v * cells - ragged, seed + cells + 1, cells, cells);
    const bits = bubble.id >>> 8;
    if ((bits % 1000) / 1000 > share) continue;
    const radius = 0.08 + 0.2 * ((bits >>> 10) / 16384) ** 2;
    deepest = Math.max(deepest, depth * smoothstep(radius, 0.35 * radius, bubble.nearest));
  }
  return deepest * where;
}

function sampler(seed, resolution) {
  const strokes = trowel(resolution, seed);
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    const u = x / TILE;
    const v = y / TILE;
    const bentU = u + 0.02 * fractalNoise(u * 4, v * 4, seed + 1, 3, 4, 4);
    const bentV = v + 0.02 * fractalNoise(u * 4, v * 4, seed + 2, 3, 4, 4);
    const bent = (cycles, offset, octaves) =>
      fractalNoise(bentU * cycles, bentV * cycles, seed + offset, octaves, cycles, cycles);

    const here = strokes.at(x, y);
    const coat = read(strokes.coat, here);
    const burnish = read(strokes.burnish, here);
    const crack = crackle(u, v, seed + 10);
    const pit = pitDepth(u, v, seed + 30);
    // The limewash brush: short crossed sweeps, each patch in its own direction.
    const turn = everywhere(x, y, 7, 40, 1) > 0 ? 1 : -1;
    const brush = noise((u + turn * v) * 260, (v - turn * u) * 22, seed + 41, 260, 22);
    const brushing = smoothstep(0, 0.4, Math.abs(everywhere(x, y, 7, 40, 1)));
    const sand = everywhere(x, y, 330, 6, 1) + 0.7 * everywhere(x, y, 170, 7, 1);
    const grit = cellular(u * 240, v * 240, seed + 8, 240, 240);
    const stone = grit.id % 100 < 5 ? smoothstep(0.34, 0.1, grit.nearest) : 0;
    // Where the wash has worn through or been knocked off, the sandy coat lies a little lower.
    const flaking = bent(6, 50, 5) + 0.25 * bent(40, 51, 3);
    const bare = smoothstep(0.62, 0.68, flaking) * (1 - 0.5 * burnish);

    texel.height =
      3.4 * everywhere(x, y, 3, 3, 3) +
      1.5 * bent(9, 4, 4) +
      2.3 * coat +
      0.45 * bent(28, 5, 4) +
      0.09 * sand * (1 + 1.2 * bare) +
      0.3 * stone +
      0.07 * brush * brushing -
      0.45 * bare -
      1.1 * pit -
      0.9 * crack;

    const color = texel.albedo;
    const low = everywhere(x, y, 2, 20, 5);
    const middle = bent(8, 21, 5);
    set(color, LIME);
    cover(color, FRESH, clamp(0.2 + 0.5 * bent(6, 24, 4) + 0.25 * brush * brushing));
    cover(color, BARE, 0.7 * bare);
    scale(color, 1 + 0.1 * low + 0.09 * middle + 0.035 * sand + 0.06 * (burnish - 0.4));
    glaze(color, STAIN, 0.45 * smoothstep(0.18, 0.9, everywhere(x, y, 3, 23, 5)));
    glaze(color, SMOKE, 0.7 * smoothstep(0.1, 0.9, everywhere(x, y, 2, 25, 5)));
    scale(color, (1 - 0.6 * crack) * (1 - 0.15 * pit) * (1 - 0.08 * stone));

    texel.roughness =
      0.88 - 0.17 * burnish + 0.06 * middle + 0.05 * sand + 0.05 * brush * brushing + 0.08 * bare;
  };
}

export const plaster = {
  name: "plaster",
  size: 1024,
  tile: 2,
  seed: 5,
  sampler,
  weathering: { radius: 12, depth: 2.2, dirt: [0.62, 0.58, 0.53], roughness: 0.05 },
};
