import { clamp, noise, random, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/** Homespun linen in plain weave, eight threads to the centimetre, slubbed and sun-bleached. */

const TILE = 400;
const THREADS = 320;
const PITCH = TILE / THREADS;

const BLEACHED = pigment(0xd8d3c6);
const RAW = pigment(0xb3a892);
const GAP = [0.42, 0.39, 0.34];
const TEA = [0.86, 0.79, 0.67];

/** How thick and how dark one thread is along its way; spun by hand, no two alike. */
function thread(index, along, seed) {
  const slub = noise(along / 38, 0.5, hashed(index, seed), Math.round(TILE / 38));
  const swelling = smoothstep(0.45, 0.8, slub);
  return {
    half: PITCH * (0.41 + 0.07 * (random(index, 1, seed) - 0.5) + 0.08 * slub + 0.13 * swelling),
    tone: random(index, 2, seed) - 0.5 + 0.35 * slub,
    sway: 0.16 * PITCH * noise(along / 9, 1.5, hashed(index, seed), Math.round(TILE / 9)),
  };
}

const hashed = (index, seed) => seed + 131 * index;

function sampler(seed) {
  const everywhere = tiledNoise(TILE, seed);
  const periodic = (wavelength) => TILE / Math.round(TILE / wavelength);
  const stretch = { 38: 38 / periodic(38), 9: 9 / periodic(9) };

  return (x, y, texel) => {
    const column = Math.floor(x / PITCH) % THREADS;
    const row = Math.floor(y / PITCH) % THREADS;
    const warp = thread(column, y * stretch[38], seed + 1);
    const weft = thread(row, x * stretch[38], seed + 2000003);
    const fromWarp = x - (Math.floor(x / PITCH) + 0.5) * PITCH - warp.sway;
    const fromWeft = y - (Math.floor(y / PITCH) + 0.5) * PITCH - weft.sway;
    // Over one, under one.
    const over = (column + row) % 2 === 0 ? 1 : -1;
    const crown = (off, half) => Math.sqrt(Math.max(0, 1 - (off / half) ** 2));
    const bend = 0.17 * over;
    const warpCrown = crown(fromWarp, warp.half);
    const weftCrown = crown(fromWeft, weft.half);
    const warpHeight =
      warpCrown > 0 ? 0.33 * warpCrown + bend * Math.cos((Math.PI * fromWeft) / PITCH) : -0.5;
    const weftHeight =
      weftCrown > 0 ? 0.33 * weftCrown - bend * Math.cos((Math.PI * fromWarp) / PITCH) : -0.5;
    const onWarp = warpHeight > weftHeight;
    const height = Math.max(warpHeight, weftHeight);
    const top = onWarp ? warp : weft;
    const strand = onWarp
      ? noise(fromWarp / 0.3 + y / 2.2, y / 3, seed + 5)
      : noise(fromWeft / 0.3 + x / 2.2, x / 3, seed + 6);
    const hole = smoothstep(0.05, -0.3, height);

    const crease = everywhere(x, y, 4, 7, 3);
    texel.height = Math.max(height, -0.42) + 0.035 * strand + 0.8 * crease;
    const color = texel.albedo;
    set(color, BLEACHED);
    cover(color, RAW, clamp(0.3 + 0.55 * top.tone + 0.2 * everywhere(x, y, 9, 8) + 0.15 * strand));
    glaze(color, TEA, 0.5 * smoothstep(0.2, 0.8, everywhere(x, y, 3, 9, 5)));
    glaze(color, GAP, clamp(hole + 0.45 * smoothstep(0.35, -0.05, height)));
    scale(color, 1 + 0.1 * strand);
    texel.roughness = 0.86 + 0.06 * strand + 0.05 * everywhere(x, y, 12, 10) + 0.06 * hole;
  };
}

export const linen = {
  name: "linen",
  size: 1024,
  tile: 0.4,
  seed: 83,
  quality: { albedo: 45, normal: 55, orm: 45 },
  sampler,
};
