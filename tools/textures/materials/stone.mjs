import { clamp, smoothstep, tiledNoise } from "../noise.mjs";
import { glaze, scale } from "../pigment.mjs";
import { paintRock, rockFace } from "../rock.mjs";

/**
 * Faces of hearth stones without joints, for stones modelled one by one: limestone that shades into
 * gneiss and granite across the tile, so that each stone cut from another place is of another kind.
 */

const TILE = 1600;
const SOOT = [0.34, 0.33, 0.33];

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    const kind = {
      layered: 0.9 * smoothstep(0.05, 0.3, everywhere(x, y, 3, 1, 4)),
      speckled: 0.85 * smoothstep(0.28, 0.5, everywhere(x, y, 3, 2, 4)),
      warm: clamp(1.6 * everywhere(x, y, 3, 3, 3), -0.3, 1),
      tone: 0.98 + 0.42 * everywhere(x, y, 4, 4, 3),
    };
    const bed = y + 40 * everywhere(x, y, 3, 5, 3);
    const rock = rockFace(x, y, { bed, layered: kind.layered, seed, period: TILE });
    texel.height = rock.relief + 2.5 * everywhere(x, y, 9, 8, 3);

    const color = texel.albedo;
    paintRock(color, rock, kind);
    scale(color, 1 + 0.1 * clamp(rock.relief / 6, -1, 1));
    const soot = smoothstep(0, 0.8, everywhere(x, y, 4, 9, 5));
    glaze(color, SOOT, 0.4 * soot);

    const worn = smoothstep(-0.3, 0.6, everywhere(x, y, 6, 10, 4));
    texel.roughness =
      0.76 -
      0.14 * worn +
      0.08 * everywhere(x, y, 24, 11, 4) +
      0.05 * rock.sand +
      0.12 * rock.pecked -
      0.12 * rock.vein +
      0.08 * soot;
  };
}

export const stone = {
  name: "stone",
  size: 1024,
  tile: 1.6,
  seed: 41,
  quality: { normal: 70 },
  sampler,
  weathering: {
    radius: 6,
    depth: 2.5,
    dirt: [0.5, 0.49, 0.48],
    polish: 0.12,
    roughness: 0.08,
  },
};
