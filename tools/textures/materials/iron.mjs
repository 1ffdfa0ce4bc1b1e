import { cellular, clamp, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, pigment, scale, set } from "../pigment.mjs";

/** Iron from the smithy: hammer flats, fire scale that has flaked, a little rust in the hollows. */

const TILE = 500;

const BLACK = pigment(0x5b5a59);
const BRIGHT = pigment(0x82807d);
const SCALE = pigment(0x47484a);
const RUST = pigment(0x5f4a3c);

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);
  return (x, y, texel) => {
    const bentX = (x / TILE) * 26 + 0.25 * everywhere(x, y, 30, 1, 2);
    const bentY = (y / TILE) * 26 + 0.25 * everywhere(x, y, 30, 2, 2);
    const blow = cellular(bentX, bentY, seed + 3, 26, 26, 1);
    const level = (blow.id & 255) / 255 - 0.5;
    const flat =
      0.4 * level * smoothstep(0, 0.25, blow.second - blow.nearest) + 0.8 * blow.nearest ** 2;
    const flaked = smoothstep(0.05, 0.13, everywhere(x, y, 20, 4, 5));
    const pitting = everywhere(x, y, 90, 5, 3);
    const pit = smoothstep(0.45, 0.8, pitting);
    const grain = everywhere(x, y, 170, 6, 1);
    const rubbed = smoothstep(-0.1, 0.6, everywhere(x, y, 5, 7, 5)) * (1 - pit);
    const rust =
      smoothstep(0.15, 0.6, everywhere(x, y, 8, 8, 5) + 0.25 * pitting) * (0.5 + 0.5 * pit);

    texel.height =
      0.9 * flat +
      0.5 * everywhere(x, y, 7, 9, 2) -
      0.13 * flaked -
      0.18 * pit +
      0.02 * grain +
      0.08 * rust * pitting;
    const color = texel.albedo;
    set(color, BLACK);
    cover(color, SCALE, 0.7 * (1 - flaked));
    cover(color, BRIGHT, 0.5 * rubbed);
    cover(color, RUST, clamp(0.75 * rust));
    scale(color, 1 + 0.08 * grain + 0.1 * pitting - 0.2 * pit);
    texel.roughness =
      0.48 +
      0.1 * (1 - flaked) -
      0.13 * rubbed +
      0.14 * pit +
      0.3 * rust +
      0.07 * pitting +
      0.04 * grain;
    texel.metallic = 1 - 0.8 * clamp(rust);
  };
}

export const iron = {
  name: "iron",
  size: 512,
  tile: 0.5,
  seed: 67,
  sampler,
  weathering: { radius: 4, depth: 0.6, dirt: [0.6, 0.58, 0.57], roughness: 0.12 },
};
