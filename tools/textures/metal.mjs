import { noise, random, smoothstep, tiledNoise } from "./noise.mjs";

/**
 * What use does to worked metal: lines of the lathe along u, straight scratches, fingers. Lengths in mm;
 * everything repeats after `tile`.
 */

/** Lines round a turned piece: fine feed marks with a few that the tool dug deeper, about -1..1. */
export function latheLines(x, y, tile, seed) {
  const fine = Math.round(tile / 1.3);
  const coarse = Math.round(tile / 5);
  const along = (x / tile) * 2;
  return (
    0.6 * noise(along, (y / tile) * fine, seed, 2, fine) +
    0.5 * noise(0.5, (y / tile) * coarse, seed + 1, 0, coarse)
  );
}

/** Straight hairline scratches: `count` of them thrown at random, depth 0..1. */
export function scratches(count, tile, seed, shortest, longest) {
  const lines = Array.from({ length: count }, (_, k) => {
    const turn = Math.PI * random(k, 0, seed);
    return {
      x: tile * random(k, 1, seed),
      y: tile * random(k, 2, seed),
      cosine: Math.cos(turn),
      sine: Math.sin(turn),
      half: 0.5 * (shortest + (longest - shortest) * random(k, 3, seed) ** 3),
      width: 0.18 + 0.35 * random(k, 4, seed) ** 2,
      depth: 0.3 + 0.7 * random(k, 5, seed),
      bend: (random(k, 6, seed) - 0.5) * 0.006,
    };
  });
  return (x, y) => {
    let deepest = 0;
    for (const line of lines) {
      let dx = x - line.x;
      let dy = y - line.y;
      dx -= Math.round(dx / tile) * tile;
      dy -= Math.round(dy / tile) * tile;
      const along = dx * line.cosine + dy * line.sine;
      if (along > line.half || along < -line.half) continue;
      const across = Math.abs(dy * line.cosine - dx * line.sine + line.bend * along * along);
      if (across > 1.2) continue;
      const ends = 1 - (along / line.half) ** 2;
      const depth =
        line.depth * ends * (1 - smoothstep(0.3 * line.width, line.width + 0.25, across));
      if (depth > deepest) deepest = depth;
    }
    return deepest;
  };
}

/** Where hands have been: greasy patches with soft edges, 0..1. */
export function smudges(x, y, tile, seed) {
  const everywhere = tiledNoise(tile, seed);
  const patch = everywhere(x, y, 7, 0, 4) + 0.35 * everywhere(x, y, 26, 7, 3);
  return smoothstep(-0.05, 0.45, patch);
}
