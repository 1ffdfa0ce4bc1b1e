import { latheLines, scratches, smudges } from "../metal.mjs";
import { clamp, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, pigment, scale, set } from "../pigment.mjs";

/** Old turned brass, polished now and then: bright where it is handled, brown where the cloth never reaches. */

const TILE = 300;

const BRASS = pigment(0xe3cb95);
const PATINA = pigment(0xa88f5f);
const TARNISH = pigment(0x6d5a40);

function sampler(seed) {
  const scratch = scratches(150, TILE, seed, 8, 90);
  const everywhere = tiledNoise(TILE, seed);
  return (x, y, texel) => {
    const turned = latheLines(x, y, TILE, seed + 1);
    const finger = smudges(x, y, TILE, seed + 3);
    const dull = smoothstep(-0.3, 0.5, everywhere(x, y, 4, 20, 5));
    const spots =
      smoothstep(0.3, 0.75, everywhere(x, y, 38, 30, 4)) *
      smoothstep(0, 0.5, everywhere(x, y, 3, 35, 3));
    const grain = everywhere(x, y, 150, 40, 2);
    const line = scratch(x, y);
    const dented = everywhere(x, y, 9, 45, 2);

    texel.height = 0.02 * turned + 0.12 * dented + 0.002 * grain - 0.03 * line - 0.015 * spots;
    const color = texel.albedo;
    set(color, BRASS);
    cover(color, PATINA, clamp(0.55 * dull + 0.2 * finger + 0.1 * turned));
    cover(color, TARNISH, clamp(0.65 * spots));
    scale(color, 1 + 0.03 * turned + 0.03 * grain);
    texel.roughness =
      0.17 + 0.13 * dull + 0.1 * finger + 0.22 * spots + 0.045 * turned + 0.04 * grain + 0.2 * line;
    texel.metallic = 1 - 0.25 * spots;
  };
}

export const brass = {
  name: "brass",
  size: 512,
  tile: 0.3,
  seed: 61,
  quality: { normal: 95 },
  sampler,
};
