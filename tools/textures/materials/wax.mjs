import { cellular, clamp, fractalNoise, noise, smoothstep } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/**
 * Bleached beeswax, dipped by hand: nearly no colour of its own (the glow comes from within), long soft
 * runs along v, a dull bloom rubbed bright where fingers were.
 */

const TILE = 200;

const IVORY = pigment(0xf0e7d3);
const BLOOM = pigment(0xf5f1e7);
const TALLOW = [0.94, 0.88, 0.76];

function sampler(seed) {
  const waves = (x, y, across, down, offset, octaves = 3) =>
    fractalNoise((x / TILE) * across, (y / TILE) * down, seed + offset, octaves, across, down);

  return (x, y, texel) => {
    const runs = waves(x, y, 9, 2, 1, 3);
    const dips = waves(x, y, 3, 11, 2, 2);
    const skin = waves(x, y, 30, 22, 3, 4);
    const grain = noise((x / TILE) * 220, (y / TILE) * 220, seed + 4, 220, 220);
    const bubble = cellular((x / TILE) * 34, (y / TILE) * 34, seed + 5, 34, 34);
    const pit =
      bubble.id % 100 < 3
        ? smoothstep(0.07 + 0.002 * ((bubble.id >>> 8) % 60), 0.03, bubble.nearest)
        : 0;
    const bloom = smoothstep(-0.25, 0.5, waves(x, y, 5, 4, 6, 5));
    const line = Math.abs(waves(x + y, y - x, 5, 5, 7, 1));
    const scratch = smoothstep(0.012, 0.003, line) * smoothstep(0.2, 0.5, waves(x, y, 6, 6, 8, 2));

    texel.height =
      0.35 * runs + 0.12 * dips + 0.06 * skin + 0.008 * grain - 0.09 * pit - 0.03 * scratch;
    const color = texel.albedo;
    set(color, IVORY);
    cover(color, BLOOM, 0.6 * bloom);
    glaze(color, TALLOW, clamp(0.35 - 0.5 * runs + 0.25 * waves(x, y, 3, 3, 9)));
    scale(color, 1 + 0.012 * skin - 0.06 * pit);
    texel.roughness = 0.36 + 0.16 * bloom + 0.07 * skin + 0.04 * grain + 0.1 * scratch + 0.1 * pit;
  };
}

export const wax = {
  name: "wax",
  size: 512,
  tile: 0.2,
  seed: 17,
  sampler,
};
