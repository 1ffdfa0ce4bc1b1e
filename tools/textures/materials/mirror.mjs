import { cellular, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, pigment, set } from "../pigment.mjs";

/**
 * An old looking-glass, all of it in one tile: its silvering gone at the edges and in spots, dust on it. The glass is not square:
 * the tile is stretched to it.
 */

const TILE = 380;
const WIDTH = 256;

const SILVER = [0.6, 0.6, 0.56];
const TARNISH = pigment(0x4a4136);
const BARE = pigment(0x2c2721);

/** Spots where damp has eaten the silvering: how many cells, the share of them that have one, the radius in cells. */
const SPOTS = [
  { cells: 9, share: 14, radius: 0.3 },
  { cells: 22, share: 12, radius: 0.36 },
  { cells: 55, share: 5, radius: 0.4 },
];

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);

  return (u, y, texel) => {
    const x = (u / TILE) * WIDTH;
    const ragged = 22 * everywhere(u, y, 7, 1, 5);
    const edge = Math.min(x, WIDTH - x, y, TILE - y) + ragged;
    // Damp rises from below.
    const low = smoothstep(0.45 * TILE, TILE, y);
    let eaten = smoothstep(14 + 10 * low, -2, edge);
    const damp = smoothstep(60 + 60 * low, 0, edge);
    for (const { cells, share, radius } of SPOTS) {
      const bend = 0.3 * everywhere(u, y, 60, cells, 2);
      const spot = cellular(
        (u / TILE) * cells + bend,
        (y / TILE) * cells - bend,
        seed + cells,
        cells,
        cells,
      );
      if (spot.id % 100 >= share * (0.4 + 1.6 * damp)) continue;
      const size = radius * (0.35 + (0.65 * ((spot.id >>> 8) % 100)) / 100);
      eaten = Math.max(eaten, smoothstep(size, 0.5 * size, spot.nearest));
    }
    const gone = smoothstep(0, 0.4, eaten);
    const cloud = smoothstep(-0.35, 0.6, everywhere(u, y, 3, 3, 5) + 0.5 * damp);
    const wiped = everywhere(u, y, 30, 4, 3);

    const color = texel.albedo;
    set(color, SILVER);
    cover(color, TARNISH, 0.1 + 0.3 * cloud * damp);
    cover(color, BARE, gone);
    // Panes cast by hand are not flat.
    texel.height = 0.22 * everywhere(u, y, 4, 5, 2);
    texel.roughness = 0.19 + 0.06 * cloud + 0.015 * wiped + 0.2 * eaten ** 3;
    // Bare spots count as a metal, too: half-way to a dielectric their rims would be bright.
    texel.metallic = 0.87 - 0.05 * cloud;
  };
}

export const mirror = {
  name: "mirror",
  size: 256,
  tile: 0.38,
  seed: 83,
  sampler,
};
