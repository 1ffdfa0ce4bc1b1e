import { clamp, noise, random, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/** A flat-woven wool rug: the weft, along u, hides the warp; stripes of blue-green and undyed wool. */

const TILE = 1000;
const WARPS = 160;
const ROWS = 320;
const WARP_PITCH = TILE / WARPS;
const ROW_PITCH = TILE / ROWS;

const CREAM = pigment(0xb9b09f);
const GREY = pigment(0x8a847a);
const BLUE_GREEN = pigment(0x56716f);
const DEEP = pigment(0x3d5053);
const DIRT = [0.62, 0.58, 0.53];

/** Rows of weft in each stripe, from the top of the tile. */
const STRIPES = [
  [58, BLUE_GREEN],
  [4, CREAM],
  [6, DEEP],
  [4, CREAM],
  [30, GREY],
  [3, CREAM],
  [8, BLUE_GREEN],
  [3, CREAM],
  [66, CREAM],
  [5, DEEP],
  [3, CREAM],
  [12, BLUE_GREEN],
  [3, CREAM],
  [5, DEEP],
  [60, CREAM],
  [3, GREY],
  [7, DEEP],
  [3, GREY],
  [29, GREY],
  [4, CREAM],
  [4, DEEP],
];
const yarns = STRIPES.flatMap(([rows, yarn]) => Array.from({ length: rows }, () => yarn));

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    const wavy = y + 2.2 * everywhere(x, y, 5, 1, 3) + 0.5 * everywhere(x, y, 34, 2, 2);
    const place = wavy / ROW_PITCH;
    const row = ((Math.floor(place) % ROWS) + ROWS) % ROWS;
    const beaten = 0.12 * noise((x / TILE) * 90, row * 3.7, seed + 3, 90);
    const fromRow = place - Math.floor(place) - 0.5 + beaten;
    // Each row goes over the warps that the last went under.
    const phase = (x + 0.7 * everywhere(x, y, 30, 4, 2)) / WARP_PITCH + 0.5 * (row % 2);
    const hump = 0.5 - 0.5 * Math.cos(2 * Math.PI * phase);
    const thickness = 0.48 + 0.1 * (random(row, 1, seed) - 0.5);
    const round = Math.sqrt(Math.max(0, 1 - (fromRow / (thickness + 0.04)) ** 2));
    const ply = noise((x + 1.6 * fromRow * ROW_PITCH) / 2.1, fromRow * 3 + row * 5.3, seed + 5);
    const fuzz = everywhere(x, y, 300, 6, 1) + 0.6 * everywhere(x, y, 150, 7, 2);
    const worn = smoothstep(0.1, 0.7, everywhere(x, y, 4, 8, 5));

    texel.height =
      (0.75 + 0.75 * hump) * round * (1 - 0.3 * worn) +
      0.12 * ply +
      0.16 * fuzz +
      1.4 * everywhere(x, y, 6, 9, 3);
    const color = texel.albedo;
    set(color, yarns[row]);
    // Small dye lots: the colour drifts from skein to skein.
    const skein = Math.floor(row / 7);
    scale(color, 1 + 0.16 * (random(skein, 2, seed) - 0.5) + 0.1 * (random(row, 3, seed) - 0.5));
    scale(color, 1 + 0.16 * ply + 0.13 * fuzz);
    cover(color, GREY, 0.1 * worn);
    glaze(
      color,
      DIRT,
      clamp(0.75 * (1 - round * (0.55 + 0.45 * hump)) + 0.3 * everywhere(x, y, 5, 10, 4)),
    );
    texel.roughness = 0.93 + 0.05 * fuzz - 0.04 * worn;
  };
}

export const wool = {
  name: "wool",
  size: 1024,
  tile: 1,
  seed: 89,
  quality: { albedo: 50, normal: 60, orm: 46 },
  sampler,
};
