import { clamp, mix, noise, randomStream, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";
import { latewood } from "../wood.mjs";

/** The sawn end of a log, pith near the middle of the tile, bark at 95 mm from it. */

const TILE = 200;
const MIDDLE = TILE / 2;
const RADIUS = 95;
const HEART = 52;

const SAP = pigment(0xb8a98c);
const HEARTWOOD = pigment(0x9a8262);
const LATE = pigment(0x6f5c43);
const GREY = pigment(0x9b968c);
const BLUE_STAIN = pigment(0x7f8688);
const BARK = pigment(0x4a4038);
const CRACK = pigment(0x191613);

function splits(seed) {
  const next = randomStream(1, seed);
  const radial = [{ turn: next(0, 2 * Math.PI), from: 1, to: RADIUS + 4, width: 3.6, seed: 1 }];
  for (let k = 0; k < 13; k++) {
    const fromHeart = next() < 0.4;
    const length = 14 + 46 * next() ** 2;
    const from = fromHeart ? next(1, 8) : RADIUS - length;
    radial.push({
      turn: next(0, 2 * Math.PI),
      from,
      to: fromHeart ? from + length : RADIUS + 4,
      width: next(0.5, 1.7),
      seed: 2 + k,
    });
  }
  return radial;
}

/** Depth 0..1 of the splits that drying opened across the rings, widest in the sapwood. */
function splitDepth(radius, turn, list, seed) {
  let deepest = 0;
  for (const split of list) {
    const along = (radius - split.from) / (split.to - split.from);
    if (along < 0 || along > 1) continue;
    let off = turn - split.turn - 0.05 * noise(radius / 26, 0.5, seed + split.seed);
    off -= Math.round(off / (2 * Math.PI)) * 2 * Math.PI;
    const across = Math.abs(off * radius + 0.7 * noise(radius / 6, 1.5, seed + split.seed));
    const open =
      split.to > RADIUS ? smoothstep(0, 0.5, along) : 2.2 * Math.sqrt(along) * (1 - along) ** 1.5;
    const half = 0.5 * split.width * open;
    const depth = (1 - smoothstep(0.5 * half, half + 0.3, across)) * Math.min(1, 2.5 * half);
    deepest = Math.max(deepest, depth);
  }
  return deepest;
}

function sampler(seed) {
  const list = splits(seed);
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    texel.bark ??= [0, 0, 0];
    const dx = x - MIDDLE - 4;
    const dy = y - MIDDLE + 3;
    const turn = Math.atan2(dy, dx);
    const fromPith = Math.hypot(dx, dy);
    const fromMiddle = Math.hypot(x - MIDDLE, y - MIDDLE);
    const lobes = 0.045 * noise(1.3 * Math.cos(turn), 1.3 * Math.sin(turn), seed + 1);
    const radius = fromPith * (1 + lobes) + 0.9 * everywhere(x, y, 9, 2, 2);
    // Young trees grow fast: wide years round the pith, narrow ones under the bark.
    const years = 0.16 * radius + 0.0031 * radius * radius + 0.1 * everywhere(x, y, 40, 3, 2);
    const late = latewood(years, seed + 4);
    const outline = fromMiddle + 1.6 * noise(3 * Math.cos(turn), 3 * Math.sin(turn), seed + 5);
    const bark = smoothstep(RADIUS - 2.4, RADIUS - 1.4, outline + 0.6 * everywhere(x, y, 50, 6, 2));
    const split =
      splitDepth(radius, turn, list, seed) * (1 - smoothstep(RADIUS, RADIUS + 3, outline));
    const rays = noise(turn * 60, radius / 16, seed + 7) * smoothstep(6, 30, radius);

    // A bow saw leaves shallow arcs, not all of one stroke.
    const bow = y + 0.0011 * (x - MIDDLE) ** 2 + 0.9 * everywhere(x, y, 3, 8, 2);
    const stroke = noise(0.5, bow / 2.6, seed + 9) + 0.5 * noise(x / 70, bow / 1.1, seed + 10);
    const torn = everywhere(x, y, 160, 11, 2);
    const shaggy = everywhere(x, y, 22, 12, 4);
    const wood =
      0.22 * stroke +
      0.35 * late +
      0.12 * torn -
      0.012 * Math.max(0, fromMiddle - 88) ** 2 +
      0.1 * rays -
      6 * split;
    texel.height = mix(wood, -1.5 + 1.8 * shaggy + 0.1 * torn, bark);

    const color = texel.albedo;
    set(color, SAP);
    const heart = smoothstep(HEART + 5, HEART - 3, radius + 4 * everywhere(x, y, 6, 13, 2));
    cover(color, HEARTWOOD, 0.75 * heart);
    cover(color, LATE, clamp(0.75 * late + 0.12 * torn));
    const stain = smoothstep(
      0.05,
      0.5,
      noise(2.2 * Math.cos(turn), 2.2 * Math.sin(turn), seed + 14) + 0.2 * rays,
    );
    cover(color, BLUE_STAIN, 0.6 * stain * (1 - heart));
    cover(color, GREY, clamp(0.42 + 0.4 * everywhere(x, y, 4, 15)) * (1 - 0.5 * late));
    scale(color, 1 + 0.1 * stroke + 0.1 * torn + 0.06 * rays);
    glaze(color, [0.6, 0.56, 0.52], 0.6 * smoothstep(70, RADIUS, fromMiddle));
    glaze(color, [0.55, 0.5, 0.45], smoothstep(4.5, 1.5, fromPith));
    set(texel.bark, BARK);
    scale(texel.bark, 1 + 0.5 * shaggy + 0.15 * torn);
    cover(color, texel.bark, bark);
    cover(color, CRACK, 0.94 * split);

    texel.roughness = mix(
      0.8 - 0.1 * late + 0.06 * torn + 0.05 * stroke,
      0.92,
      Math.max(bark, split),
    );
  };
}

export const logends = {
  name: "logends",
  size: 512,
  tile: 0.2,
  seed: 53,
  quality: { normal: 72 },
  sampler,
  weathering: { radius: 1.5, depth: 1, dirt: [0.5, 0.47, 0.44], roughness: 0.06 },
};
