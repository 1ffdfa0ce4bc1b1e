import { cellular, clamp, fractalNoise, noise, randomStream, smoothstep } from "./noise.mjs";
import { glaze, pigment, scale, set } from "./pigment.mjs";

/**
 * Lime mortar pressed between logs and struck with a trowel. Lengths in mm; x along the joint, `off`
 * across it from its middle, both periodic with the tile since each joint has its own seed.
 */

const LIME = pigment(0xd2cec4);
const SOOT = [0.5, 0.48, 0.46];
const HALF_WIDTH = 24;

const chink = { height: 0, albedo: [0, 0, 0], roughness: 0 };

/** Where each joint has cracked across, as mortar does that dries between logs that move. */
function crossCracks(joint, seed, tile) {
  const next = randomStream(joint, seed);
  let x = next(0, 300);
  const cracks = [];
  while (x < tile) {
    cracks.push({
      x,
      width: next(0.5, 1.5),
      lean: next(-0.35, 0.35),
      seed: joint * 31 + cracks.length,
    });
    x += next(150, 620);
  }
  return cracks;
}

function crackDepth(x, off, cracks, tile) {
  let deepest = 0;
  for (const crack of cracks) {
    let dx = x - crack.x;
    dx -= Math.round(dx / tile) * tile;
    if (Math.abs(dx) > 30) continue;
    const path =
      crack.lean * off +
      4 * noise(off / 11, 0.5, crack.seed) +
      1.5 * noise(off / 3.5, 1.5, crack.seed);
    const depth = 1 - smoothstep(0.3 * crack.width, crack.width + 0.5, Math.abs(dx - path));
    deepest = Math.max(deepest, depth * Math.min(1, crack.width));
  }
  return deepest;
}

/** The mortar of every joint: `(x, off, joint)` gives height over the bed, colour and roughness. */
export function chinking(joints, tile, seed) {
  const cracked = Array.from({ length: joints }, (_, joint) => crossCracks(joint, seed, tile));

  return (x, off, joint) => {
    const s = seed * 31 + joint * 17;
    const along = (cycles, across, offset, octaves) =>
      fractalNoise((x / tile) * cycles, across, s + offset, octaves, cycles, 0);

    // Each pull of the trowel leaves a flat a hand or two long, a lip where it was lifted, and drag lines.
    const pull = along(6, 0.5, 5, 2);
    const pressed = smoothstep(-0.25, 0.25, pull);
    const lip = Math.exp(-((pull / 0.06) ** 2));
    const drag = along(9, off / 2.6, 3, 2);
    const torn = along(52, off / 9, 2, 4);
    const sand = noise((x / tile) * 560, off / 2.9, s + 4, 560);
    const stones = cellular((x / tile) * 260, off / 6.2, s + 6, 260, 0);
    const stone = stones.id % 100 < 6 ? smoothstep(0.36, 0.1, stones.nearest) : 0;
    const lost =
      stones.id % 100 > 95
        ? smoothstep(0.12 + 0.004 * ((stones.id >>> 8) & 63), 0.08, stones.nearest)
        : 0;
    const spalled = smoothstep(0.5, 0.56, along(10, off / 40, 7, 4));
    const crack = crackDepth(x, off, cracked[joint], tile);

    const share = off / HALF_WIDTH;
    chink.height =
      1.8 * Math.min(share * share, 1) -
      14 * Math.max(0, Math.abs(share) - 1.25) +
      2.4 * along(7, 0.9, 1, 3) +
      0.9 * pressed +
      0.7 * lip * noise(off / 20, 0.5, s + 8) +
      0.55 * drag * pressed +
      (1 - 0.6 * pressed) * 1.1 * torn +
      0.14 * sand +
      0.4 * stone -
      1.1 * lost -
      2.2 * spalled * (0.7 + 0.3 * torn) -
      2 * crack;

    const color = chink.albedo;
    set(color, LIME);
    const stain = along(7, off / 90, 9, 4);
    scale(color, 0.9 + 0.12 * stain + 0.06 * sand + 0.07 * drag * pressed + 0.08 * torn);
    glaze(color, SOOT, clamp(0.22 + 0.55 * stain + 0.12 * spalled));
    scale(color, (1 - 0.25 * stone) * (1 - 0.25 * lost) * (1 - 0.72 * crack));
    chink.roughness = 0.93 - 0.1 * pressed + 0.04 * sand;
    return chink;
  };
}
