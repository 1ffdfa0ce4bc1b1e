import { latheLines, scratches, smudges } from "../metal.mjs";
import { cellular, clamp, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, pigment, scale, set } from "../pigment.mjs";

/** Spun pewter gone soft and grey: knife marks, small dents, a skin of oxide rubbed through by hands. */

const TILE = 300;

const PEWTER = pigment(0xc2c0bb);
const OXIDE = pigment(0x9d9c99);
const DARK = pigment(0x7a7a79);

function sampler(seed) {
  const scratch = scratches(220, TILE, seed, 6, 70);
  const everywhere = tiledNoise(TILE, seed);
  return (x, y, texel) => {
    const turned = latheLines(x, y, TILE, seed + 1);
    const finger = smudges(x, y, TILE, seed + 3);
    const dull = smoothstep(-0.35, 0.45, everywhere(x, y, 5, 20, 5));
    const bloom = smoothstep(0.15, 0.75, everywhere(x, y, 30, 30, 5));
    const grain = everywhere(x, y, 150, 40, 2);
    const line = scratch(x, y);
    const hit = cellular((x / TILE) * 14, (y / TILE) * 14, seed + 44, 14, 14);
    const dent = hit.id % 100 < 22 ? smoothstep(0.3, 0, hit.nearest) : 0;

    texel.height =
      0.018 * turned + 0.2 * everywhere(x, y, 7, 45, 2) + 0.004 * grain - 0.03 * line - 0.3 * dent;
    const color = texel.albedo;
    set(color, PEWTER);
    cover(color, OXIDE, clamp(0.75 * dull + 0.15 * turned - 0.25 * line));
    cover(color, DARK, 0.5 * bloom);
    scale(color, 1 + 0.04 * turned + 0.05 * grain);
    texel.roughness =
      0.3 + 0.15 * dull + 0.06 * finger + 0.14 * bloom + 0.04 * turned + 0.05 * grain - 0.08 * line;
    texel.metallic = 1 - 0.15 * bloom;
  };
}

export const pewter = {
  name: "pewter",
  size: 512,
  tile: 0.3,
  seed: 71,
  quality: { normal: 95 },
  sampler,
};
