import { scratches } from "../metal.mjs";
import { cellular, clamp, smoothstep, tiledNoise } from "../noise.mjs";
import { glaze, pigment, scale, set } from "../pigment.mjs";

/** Morocco for bookbinding, nearly neutral so that a base colour can dye it: grain, rubbed and cracked by use. */

const TILE = 400;

const SKIN = pigment(0xd3d4d1);
const WEAR = [1.12, 1.08, 1.02];
const HANDLED = [0.72, 0.7, 0.68];

function sampler(seed) {
  const scuffs = scratches(60, TILE, seed, 10, 80);
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    const u = (x / TILE) * 170 + 0.5 * everywhere(x, y, 60, 1, 2);
    const v = (y / TILE) * 170 + 0.5 * everywhere(x, y, 60, 2, 2);
    const grain = cellular(u, v, seed + 3, 170, 170, 0.95);
    const valley = 1 - smoothstep(0, 0.32, grain.second - grain.nearest);
    const pebble = ((grain.id & 255) / 255 - 0.5) * 0.5;
    const stretched = smoothstep(-0.3, 0.5, everywhere(x, y, 5, 4, 3));
    const rubbed = smoothstep(0.1, 0.7, everywhere(x, y, 4, 5, 5));
    const fine = everywhere(x, y, 190, 6, 1);
    const scuff = scuffs(x, y);

    texel.height =
      (0.1 * pebble - 0.2 * valley) * (1 - 0.45 * rubbed) * (0.65 + 0.35 * stretched) +
      0.02 * fine +
      0.3 * everywhere(x, y, 8, 7, 3) -
      0.1 * scuff;
    const color = texel.albedo;
    set(color, SKIN);
    scale(
      color,
      1 +
        0.16 * everywhere(x, y, 6, 8, 5) +
        0.1 * pebble +
        0.05 * fine -
        0.3 * valley * (1 - 0.4 * rubbed),
    );
    glaze(color, WEAR, clamp(0.8 * rubbed + 0.7 * scuff));
    glaze(color, HANDLED, 0.7 * smoothstep(0.15, 0.8, everywhere(x, y, 3, 9, 5)));
    texel.roughness =
      0.52 +
      0.14 * valley -
      0.14 * rubbed +
      0.08 * everywhere(x, y, 14, 10, 4) +
      0.05 * fine +
      0.18 * scuff;
  };
}

export const leather = {
  name: "leather",
  size: 512,
  tile: 0.4,
  seed: 97,
  quality: { albedo: 50, normal: 75, orm: 58 },
  sampler,
  weathering: { radius: 1.5, depth: 0.5, dirt: [0.6, 0.58, 0.56], roughness: 0.08 },
};
