import { bell, cellular, clamp, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, pigment, scale, set } from "../pigment.mjs";

/** A log after the fire, grain along x: char cracked into blocks, and ash where it went on glowing. */

const TILE = 300;
const BLOCKS = { along: 8, across: 19 };

const CHAR = pigment(0x1f1d1c);
const LUSTRE = pigment(0x35343a);
const BROWN = pigment(0x4b3527);
const ASH = pigment(0xa39d94);

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    const u = x / TILE;
    const v = y / TILE;
    const bend = 0.45 * everywhere(x, y, 7, 1, 3) + 0.08 * everywhere(x, y, 40, 2, 2);
    const sway = 0.35 * everywhere(x, y, 9, 3, 3) + 0.08 * everywhere(x, y, 40, 4, 2);
    const block = cellular(
      u * BLOCKS.along + bend,
      v * BLOCKS.across + sway,
      seed + 5,
      BLOCKS.along,
      BLOCKS.across,
      0.75,
    );
    const border = block.second - block.nearest;
    const open = 0.11 + 0.07 * everywhere(x, y, 6, 6, 2);
    const crack = smoothstep(open, 0.25 * open, border);
    const dome = smoothstep(0, 0.55, border);
    const lift = ((block.id % 100) / 100 - 0.5) * smoothstep(0.05, 0.2, border);
    const fine = everywhere(x, y, 70, 7, 3);
    const grain = everywhere(0.25 * x, y, 60, 8, 2);

    const burnt = smoothstep(
      0.05,
      0.5,
      everywhere(x, y, 3, 9, 4) + 0.25 * everywhere(x, y, 18, 10, 3),
    );
    const flakes = smoothstep(
      0.1,
      0.5,
      everywhere(x, y, 26, 11, 4) + 0.5 * bell(border - 0.16, 0.1),
    );
    const ash = clamp(burnt * (0.35 + 0.65 * flakes) + 0.12 * flakes * (1 - crack));

    texel.height = 2.2 * dome + 1.4 * lift - 2.4 * crack + 0.22 * fine + 0.12 * grain - 0.5 * burnt;
    const color = texel.albedo;
    set(color, CHAR);
    cover(color, LUSTRE, clamp(0.5 + 0.5 * grain + 0.3 * fine) * dome);
    cover(color, BROWN, 0.6 * smoothstep(0.25, 0.6, everywhere(x, y, 4, 12, 4)) * (1 - crack));
    cover(color, ASH, 0.85 * ash * (1 - 0.6 * crack));
    scale(color, 1 + 0.15 * fine);
    texel.roughness = clamp(0.62 - 0.12 * dome + 0.3 * ash + 0.06 * fine, 0.4, 0.97);
  };
}

export const char = {
  name: "char",
  size: 512,
  tile: 0.3,
  seed: 89,
  quality: { normal: 70 },
  sampler,
  weathering: { radius: 3, depth: 3, dirt: [0.4, 0.4, 0.4], roughness: 0.06 },
};
