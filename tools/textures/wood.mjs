import { bell, hash, noise, random, smoothstep } from "./noise.mjs";

/** What makes wood look like wood, shared by logs, floor and furniture. Lengths in mm. */

/**
 * Latewood, 0..1, at a distance from the pith counted in years: slow rise, abrupt drop, some years
 * stronger than others.
 */
export function latewood(years, seed) {
  const year = Math.floor(years);
  const season = years - year;
  const strength = 0.35 + 0.65 * random(year, 3, seed);
  return strength * smoothstep(0.3, 0.86, season) * (1 - smoothstep(0.93, 1, season));
}

const knotState = { across: 0, inside: 0, radius: 9, halo: 0, swell: 0, star: 0, rim: 0 };

/**
 * How knots bend the grain at (along, across). Fibres follow the stream lines of a flow past a
 * cylinder, the branch. Returned, and reused by the next call: the bent `across`; how far `inside` a
 * knot; the distance from its centre in knot radii; its dark `halo`; the `swell` round it; the drying
 * `star` crossing it; how dark its `rim` of bark is on this side.
 */
export function bendRoundKnots(along, across, knots, period) {
  const state = knotState;
  state.across = across;
  state.inside = 0;
  state.radius = 9;
  state.halo = 0;
  state.swell = 0;
  state.star = 0;
  for (const knot of knots) {
    let dx = along - knot.along;
    if (period) dx -= Math.round(dx / period) * period;
    const dy = across - knot.across;
    if (Math.abs(dx) > 9 * knot.radius || Math.abs(dy) > 7 * knot.radius) continue;
    const ragged = 0.09 * knot.radius * noise(dx / 5, dy / 5, knot.seed);
    const distance = Math.hypot(dx / knot.stretch, dy) + ragged;
    const apart = Math.hypot(dx / (1.7 * knot.stretch), dy);
    const reach = 1.15 * knot.radius;
    const pushed = Math.min(1, (reach * reach) / (apart * apart + 1e-6));
    state.across -= dy * pushed * bell(apart, 4.5 * knot.radius);
    state.swell = Math.max(
      state.swell,
      bell(apart, 2.1 * knot.radius) * Math.min(1, knot.radius / 14),
    );
    state.halo = Math.max(
      state.halo,
      Math.exp(-Math.max(0, distance - knot.radius) / (0.7 * knot.radius)),
    );
    const inside = 1 - smoothstep(0.9 * knot.radius, 1.06 * knot.radius, distance);
    if (inside > state.inside) {
      state.inside = inside;
      state.radius = distance / knot.radius;
      // A heart-shake or two: cracks from the pith, of one to four arms.
      const angle = Math.atan2(dy, dx) + 0.6 * noise(distance / 7, 0.5, knot.seed + 1);
      const arms = 1 + (knot.seed % 4);
      const arm = Math.abs(Math.sin((arms * angle) / 2 + knot.seed)) * distance;
      const reachOfCrack = 1 - 0.9 * state.radius + 0.5 * noise(2 * angle, 0.5, knot.seed + 2);
      const width = knot.crack * Math.max(0, reachOfCrack);
      state.star = inside * Math.min(1, width) * (1 - smoothstep(0.5 * width, width + 0.6, arm));
      state.rim = 0.5 + 0.5 * noise(Math.cos(angle) * 1.3, Math.sin(angle) * 1.3, knot.seed + 3);
    }
  }
  return state;
}

/** A knot's make-up from a stream of random numbers; place it by adding `along` and `across`. */
export function knotShape(next, seed, smallest, largest) {
  const size = next();
  return {
    radius: smallest + (largest - smallest) * size * size,
    stretch: next(1, 1.35),
    crack: next(0.3, 1.9),
    seed: hash(Math.floor(next(0, 65536)), 1, seed) & 0xffff,
  };
}

/**
 * Depth 0..1 of drying checks: lens-shaped splits that follow the grain, the finer the shallower, each
 * `{ along, across, length, width, seed }`. `edge` is how softly they end, in mm.
 */
export function checkDepth(along, across, checks, period, edge = 0.4) {
  let deepest = 0;
  for (const check of checks) {
    let dx = along - check.along;
    if (period) dx -= Math.round(dx / period) * period;
    const t = (2 * dx) / check.length;
    if (t < -1 || t > 1) continue;
    const dy = across - check.across;
    if (dy > 14 || dy < -14) continue;
    const wander =
      5 * noise(dx / 170, 0.5, check.seed) +
      1.1 * noise(dx / 34, 1.5, check.seed) +
      0.2 * check.width * noise(dx / 9, 2.5, check.seed);
    const taper = (1 - t * t) * (0.75 + 0.35 * noise(dx / 40, 3.5, check.seed));
    const half = 0.5 * check.width * Math.max(0, taper);
    const depth =
      (1 - smoothstep(0.4 * half, half + edge, Math.abs(dy - wander))) *
      Math.min(1, half / 1.1) *
      smoothstep(0, 0.3, taper);
    if (depth > deepest) deepest = depth;
  }
  return deepest;
}
