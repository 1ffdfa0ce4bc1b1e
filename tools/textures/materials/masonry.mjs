import {
  bell,
  cellular,
  clamp,
  fractalNoise,
  mix,
  noise,
  randomStream,
  smoothstep,
} from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";
import { paintRock, rockFace } from "../rock.mjs";
import { synthesizeSurface, weather } from "../surface.mjs";

/** A wall of roughly squared field stones, cool greys of several kinds, bedded in sandy lime. */

const TILE = 1600;
const COURSES = [230, 170, 260, 200, 240, 180, 320];

const MORTAR = pigment(0xb5b0a4);
const SAND = pigment(0x85796a);
const SOOT = [0.34, 0.33, 0.33];

/** Rectangles that fill the tile in courses; a course may hold two thin stones one on the other. */
function layStones(seed) {
  const stones = [];
  let top = 0;
  COURSES.forEach((height, course) => {
    const next = randomStream(course, seed);
    const shift = next(0, TILE);
    const count = Math.round(TILE / (height * next(1.35, 1.7)));
    const shares = Array.from({ length: count }, () => next(0.6, 1.5));
    const total = shares.reduce((sum, share) => sum + share, 0);
    let left = shift;
    for (const share of shares) {
      const width = (TILE * share) / total;
      const split = height > 190 && next() < 0.3 ? next(0.38, 0.62) : 1;
      stones.push({ left, top, width, height: height * split });
      if (split < 1)
        stones.push({ left, top: top + height * split, width, height: height * (1 - split) });
      left += width;
    }
    top += height;
  });
  return stones.map((stone, index) => {
    const next = randomStream(1000 + index, seed);
    return {
      ...stone,
      layered: next() < 0.35 ? next(0.5, 1) : 0,
      speckled: next() < 0.16 ? next(0.5, 0.9) : 0,
      warm: next() < 0.25 ? next(0.4, 1) : next(-0.3, 0.2),
      seed: Math.floor(next(0, 1 << 24)),
      corner: next(0.12, 0.3),
      joint: next(6, 11),
      tone: next(0.72, 1.22),
      proud: next(-4, 7),
      tiltX: next(-0.035, 0.035),
      tiltY: next(-0.05, 0.05),
      pillow: next(7, 16),
      lean: next(-0.05, 0.05),
      bedding: next(-0.25, 0.25),
    };
  });
}

const place = { inside: 0, stone: null, x: 0, y: 0 };

/** The stone whose face is nearest, and how far inside its rounded outline a point lies (mm). */
function nearestStone(stones, x, y) {
  place.inside = -999;
  for (const stone of stones) {
    let dx = x - stone.left - stone.width / 2;
    dx -= Math.round(dx / TILE) * TILE;
    let dy = y - stone.top - stone.height / 2;
    dy -= Math.round(dy / TILE) * TILE;
    if (Math.abs(dx) > stone.width / 2 + 30 || Math.abs(dy) > stone.height / 2 + 30) continue;
    const halfX = stone.width / 2 - stone.joint;
    const halfY = stone.height / 2 - stone.joint;
    const radius = stone.corner * Math.min(halfX, halfY) * 2;
    const slanted = dx + stone.lean * dy;
    const qx = Math.abs(slanted) - halfX + radius;
    const qy = Math.abs(dy) - halfY + radius;
    const inside =
      radius - Math.hypot(Math.max(qx, 0), Math.max(qy, 0)) - Math.min(0, Math.max(qx, qy));
    if (inside > place.inside) {
      place.inside = inside;
      place.stone = stone;
      place.x = dx;
      place.y = dy;
    }
  }
  return place;
}

function sampler(seed) {
  const stones = layStones(seed);
  const lime = [0, 0, 0];
  const everywhere = (x, y, cycles, offset, octaves = 4) =>
    fractalNoise((x / TILE) * cycles, (y / TILE) * cycles, seed + offset, octaves, cycles, cycles);

  return (x, y, texel) => {
    const bentX = x + 13 * everywhere(x, y, 7, 1, 3) + 3.5 * everywhere(x, y, 40, 2, 3);
    const bentY = y + 13 * everywhere(x, y, 7, 3, 3) + 3.5 * everywhere(x, y, 40, 4, 3);
    const { stone, inside, x: dx, y: dy } = nearestStone(stones, bentX, bentY);
    const s = stone.seed;

    const chip = everywhere(x, y, 26, 5, 3);
    const depth = inside + 5 * Math.min(0, chip + 0.1);
    const dome = 1 - Math.exp(-Math.max(0, depth) / 17);
    const bed = dy + stone.bedding * dx + 9 * noise(dx / 90, dy / 60, s + 1);
    const rock = rockFace(dx, dy, { bed, layered: stone.layered, seed: s, period: 0 });
    const face =
      stone.proud +
      stone.pillow * dome +
      dome * (rock.relief + stone.tiltX * dx + stone.tiltY * dy) +
      Math.min(0, depth) * 2.2;

    const bedMortar =
      -1.5 +
      2.4 * everywhere(x, y, 12, 9, 4) +
      1.1 * everywhere(x, y, 60, 10, 3) +
      0.3 * everywhere(x, y, 260, 11, 2);
    const pebble = cellular((x / TILE) * 130, (y / TILE) * 130, seed + 12, 130, 130);
    const gravel = pebble.id % 100 < 22 ? smoothstep(0.4, 0.1, pebble.nearest) : 0;
    const mortarHeight = bedMortar + 0.7 * gravel;
    const covered = smoothstep(-0.8, 1.2, mortarHeight - face + 1.4 * everywhere(x, y, 34, 13, 4));
    const parted = bell(mortarHeight - face, 1.1) * smoothstep(0, 0.4, everywhere(x, y, 11, 14, 3));
    texel.height = mix(face, Math.max(face, mortarHeight), covered) - 2.2 * parted;

    const color = texel.albedo;
    paintRock(color, rock, stone);
    scale(color, 1 + 0.1 * clamp(rock.relief / 6, -1, 1));
    const soot = smoothstep(0, 0.8, everywhere(x, y, 3, 18, 5));
    glaze(color, SOOT, 0.35 * soot);

    set(lime, MORTAR);
    const stain = everywhere(x, y, 9, 19, 5);
    scale(lime, 0.88 + 0.16 * stain + 0.06 * rock.sand);
    cover(lime, SAND, 0.55 * gravel);
    glaze(lime, SOOT, clamp(0.3 + 0.35 * stain + 0.25 * soot));
    cover(color, lime, covered);
    glaze(color, SOOT, 0.8 * parted);

    const worn = smoothstep(0.2, 0.9, dome) * smoothstep(-0.3, 0.6, everywhere(x, y, 6, 20, 4));
    const stoneRoughness =
      0.74 -
      0.14 * worn +
      0.08 * everywhere(x, y, 24, 21, 4) +
      0.05 * rock.sand +
      0.12 * rock.pecked -
      0.12 * rock.vein;
    texel.roughness = mix(stoneRoughness, 0.95, covered);
    texel.metallic = 0;
  };
}

export const masonry = {
  name: "masonry",
  size: 1024,
  tile: 1.6,
  seed: 41,
  synthesize(resolution, seed = this.seed) {
    const surface = synthesizeSurface({ resolution, tile: this.tile }, sampler(seed));
    return weather(surface, { radius: 9, depth: 5, dirt: [0.45, 0.44, 0.43], roughness: 0.08 });
  },
};
