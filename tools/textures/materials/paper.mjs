import { clamp, noise, random, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/**
 * An old book. u from 0 to 1/2 is a printed page, 128 by 196 mm from the upper left corner of the tile,
 * and below it blank paper; u from 1/2 to 1 is the edge of the block, leaves lying along u.
 */

const TILE = 300;
const PAGE = { width: 128, height: 196 };
const TEXT = { left: 17, right: 111, top: 20, bottom: 172 };
const LEADING = 4.6;

const PAPER = pigment(0xd6cdb8);
const PALE = pigment(0xe0dac9);
const BROWNED = [0.84, 0.74, 0.57];
const FOXING = [0.78, 0.64, 0.46];
const INK = pigment(0x4a4540);
const EDGE_DARK = pigment(0x8f8169);

/**
 * How much ink lies at a point of the page: words of random length, made of upright strokes of which only
 * the grey is left at arm's length.
 */
function print(x, y, seed) {
  if (x < TEXT.left || x > TEXT.right || y < TEXT.top || y > TEXT.bottom) return 0;
  const line = Math.floor((y - TEXT.top) / LEADING);
  const fromTop = (y - TEXT.top) / LEADING - line;
  const paragraphEnds = random(line, 0, seed) < 0.14;
  const paragraphStarts = line === 0 || random(line - 1, 0, seed) < 0.14;
  if (paragraphStarts && x < TEXT.left + 6) return 0;
  if (paragraphEnds && x > TEXT.left + (TEXT.right - TEXT.left) * random(line, 1, seed)) return 0;
  // Words: cells of 2.4 mm, each of which may be a space.
  const cell = Math.floor(x / 2.4 + 7 * random(line, 2, seed));
  const cellStart = x / 2.4 + 7 * random(line, 2, seed) - cell;
  if (random(cell, line + 10, seed) < 0.28 && cellStart < 0.55) return 0;
  const letter = Math.floor(x / 0.85);
  const tall = random(letter, line + 90, seed);
  const top = tall < 0.25 ? 0.22 : 0.4;
  const foot = tall > 0.9 ? 0.92 : 0.76;
  const body =
    smoothstep(top - 0.06, top + 0.06, fromTop) * smoothstep(foot + 0.06, foot - 0.06, fromTop);
  const strokes = 0.62 + 0.38 * Math.cos((2 * Math.PI * x) / 0.85 + 5 * random(letter, line, seed));
  return body * strokes * (0.8 + 0.2 * noise(x / 9, y / 9, seed + 4));
}

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);

  function page(x, y, texel) {
    const fibre = everywhere(x, y, 140, 1, 2);
    // Wires of the mould: fine laid lines, and chains an inch apart.
    const laid = Math.cos((2 * Math.PI * y * 200) / TILE);
    const chain = Math.max(0, Math.cos((2 * Math.PI * x * 12) / TILE)) ** 24;
    const ink = print(x, y, seed + 2);
    const margin = Math.min(x, PAGE.width - x, y, PAGE.height - y);
    const onPage = y < PAGE.height && x < PAGE.width;
    texel.height =
      0.5 * everywhere(x, y, 5, 3, 3) + 0.012 * laid + 0.02 * chain + 0.02 * fibre - 0.015 * ink;
    const color = texel.albedo;
    set(color, PAPER);
    cover(color, PALE, clamp(0.5 + 0.5 * everywhere(x, y, 6, 4)));
    scale(color, 1 + 0.03 * fibre - 0.02 * laid);
    if (onPage)
      glaze(
        color,
        BROWNED,
        0.75 * Math.exp(-Math.max(0, margin + 2 * everywhere(x, y, 20, 5)) / 6),
      );
    const spot = everywhere(x, y, 26, 6, 3);
    glaze(
      color,
      FOXING,
      0.7 * smoothstep(0.5, 0.68, spot) * smoothstep(0, 0.4, everywhere(x, y, 4, 7, 2)),
    );
    glaze(color, BROWNED, 0.4 * smoothstep(0.1, 0.8, everywhere(x, y, 3, 8, 5)));
    cover(color, INK, 0.72 * ink);
    texel.roughness = 0.84 + 0.04 * fibre + 0.05 * everywhere(x, y, 12, 9) - 0.06 * ink;
  }

  function block(x, y, texel) {
    // Gatherings of eight leaves; each a little forward or back.
    const bowed = y + 0.35 * everywhere(x, y, 4, 10, 3);
    const gathering = Math.floor((bowed / TILE) * 90);
    const within = (bowed / TILE) * 90 - gathering;
    const forward = random(((gathering % 90) + 90) % 90, 1, seed);
    const leaf = noise((x / TILE) * 3, (bowed / TILE) * 360, seed + 11, 3, 360);
    const fine = noise((x / TILE) * 9, (bowed / TILE) * 256, seed + 12, 9, 256);
    const parted = smoothstep(0.1, 0.02, Math.min(within, 1 - within)) * (0.4 + 0.6 * forward);
    texel.height = 0.25 * leaf + 0.18 * fine + 0.3 * (forward - 0.5) - 0.5 * parted;
    const color = texel.albedo;
    set(color, PAPER);
    cover(color, EDGE_DARK, clamp(0.35 - 0.5 * leaf - 0.3 * fine + 0.45 * parted));
    scale(color, 0.9 + 0.14 * (forward - 0.5));
    glaze(color, BROWNED, 0.6 + 0.5 * everywhere(x, y, 6, 13, 5));
    texel.roughness = 0.88 + 0.05 * fine;
  }

  return (x, y, texel) => {
    if (x < TILE / 2) page(x, y, texel);
    else block(x, y, texel);
  };
}

export const paper = {
  name: "paper",
  size: 1024,
  tile: 0.3,
  seed: 101,
  sampler,
};
