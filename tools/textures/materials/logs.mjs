import { chinking } from "../chinking.mjs";
import { bell, clamp, fractalNoise, mix, noise, randomStream, smoothstep } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";
import { bendRoundKnots, checkDepth, knotShape, latewood } from "../wood.mjs";

/**
 * A wall of peeled round logs, weathered to grey and blond, chinked with lime mortar. Eight logs of
 * 200 mm, u along them, each log's crown at v = (k + 0.5) / 8 and a joint at v = k / 8.
 */

const TILE = 1600;
const LOGS = 8;
const PITCH = TILE / LOGS;

/** Share of the logs' roundness drawn into the normals; the mesh is to carry the rest. */
const ROUNDNESS = 0.55;

/** Height of the bed of mortar: where the logs come to 79 mm from their crowns. */
const BED = -ROUNDNESS * 0.5 * PITCH * (1 - Math.cos(Math.asin(0.79))) - 1.5;

const BLOND = pigment(0xbbab90);
const LATE = pigment(0x8e7a5f);
const SILVER = pigment(0xa9a59b);
const BARK = pigment(0x55463a);
const KNOT = pigment(0x54463a);
const SHADOW = pigment(0x1d1a17);
const DUST = pigment(0xaaa69c);
const SOOT = [0.5, 0.48, 0.46];

function growLog(index, seed) {
  const next = randomStream(index, seed);
  const knots = [];
  // Pines branch in whorls, a year's growth apart.
  const whorls = Math.floor(next(2, 4));
  const firstWhorl = next(0, TILE);
  for (let whorl = 0; whorl < whorls; whorl++) {
    const along = firstWhorl + (whorl * TILE) / whorls + next(-90, 90);
    const count = Math.floor(next(1, 3.2));
    for (let k = 0; k < count; k++) {
      const shape = knotShape(next, seed, 7, 23);
      knots.push({ ...shape, along: along + next(-70, 70), across: next(-95, 95) });
    }
  }
  const checks = [];
  const long = Math.floor(next(1, 3.4));
  for (let k = 0; k < long; k++) {
    checks.push({
      along: next(0, TILE),
      across: next(-55, 50),
      length: next(320, 1150),
      width: next(2.6, 7),
      seed: index * 97 + k,
    });
  }
  // Hairlines gather where the wood dried fastest.
  for (let k = 0; k < 46; k++) {
    const middle = checks[k % (long + 2)] ?? { along: next(0, TILE), across: next(-90, 90) };
    checks.push({
      along: middle.along + next(-420, 420),
      across: middle.across + 60 * next(-1, 1) * next(),
      length: 50 + 340 * next() * next(),
      width: 0.7 + 1.6 * next() * next() * next(),
      seed: index * 97 + 10 + k,
    });
  }
  return {
    seed: seed * 500 + index * 53,
    knots,
    checks,
    radius: 0.5 * PITCH * next(0.98, 1.05),
    centre: next(-3, 3),
    twist: next(-9, 9),
    yearWidth: next(1.7, 3.2),
    tone: next(0.78, 1.16),
    silver: next(0.25, 1),
    bark: next(-0.25, 0.15),
    facets: next(0.5, 1.1),
  };
}

/** Noise that repeats along the log with the tile: `cycles` to a tile, `across` in cycles too. */
function along(x, cycles, across, seed, octaves = 3) {
  return fractalNoise((x / TILE) * cycles, across, seed, octaves, cycles, 0);
}

/**
 * What the drawknife left: long flats round the log, lower in the middle than a circle by the
 * sagitta, meeting in faint creases; two runs of strokes overlap.
 */
function drawknife(x, arc, log) {
  let lowest = 0;
  for (let run = 0; run < 2; run++) {
    const width = 21 + 9 * run;
    const place = (arc + 9 * along(x, 5, arc / 90, log.seed + 30 + run, 2)) / width + 0.5 * run;
    const stroke = Math.floor(place);
    const off = 2 * (place - stroke) - 1;
    const lands = smoothstep(-0.25, 0.25, along(x, 7, stroke * 7.3, log.seed + 32 + run, 2));
    lowest = Math.max(lowest, lands * (1 - off * off));
  }
  return -0.55 * log.facets * lowest;
}

function paintWood(color, wood) {
  set(color, BLOND);
  cover(color, LATE, clamp(0.22 + 0.6 * wood.late + 0.3 * wood.fibre + 0.2 * wood.streak));
  const silver = clamp(wood.log.silver + 0.75 * wood.patch + 0.12 * wood.fibre);
  cover(color, SILVER, 0.8 * silver * (1 - 0.45 * wood.late));
  scale(color, wood.log.tone * (1 + 0.3 * wood.streak + 0.2 * wood.fibre + 0.12 * wood.patch));
  cover(color, BARK, 0.72 * wood.bark);
  cover(color, KNOT, clamp(0.42 * wood.halo * wood.halo + 0.5 * wood.inside));
  if (wood.inside > 0) {
    scale(color, 1 - 0.35 * wood.inside * wood.knotRing);
    scale(color, 1 - 0.75 * wood.rim * wood.inside * bell(wood.radius - 0.96, 0.09));
  }
  cover(color, SHADOW, clamp(0.93 * Math.max(wood.check, wood.star)));
}

function sampler(seed) {
  const logs = Array.from({ length: LOGS }, (_, index) => growLog(index, seed));
  const mortar = chinking(LOGS, TILE, seed);
  return (x, y, texel) => {
    const index = Math.floor(y / PITCH);
    const log = logs[index];
    const s = log.seed;
    const crown = (index + 0.5) * PITCH + log.centre + 4 * along(x, 2, 0.5, s, 2);
    const radius = log.radius * (1 + 0.025 * along(x, 3, 0.7, s + 1, 3));
    const height01 = clamp((y - crown) / radius, -0.995, 0.995);
    const angle = Math.asin(height01);
    const arc = angle * log.radius;

    const knot = bendRoundKnots(x, arc, log.knots, TILE);
    const swell = knot.swell;
    const w =
      knot.across +
      log.twist * Math.sin((2 * Math.PI * x) / TILE + s) +
      3 * along(x, 4, arc / 70, s + 3) +
      0.9 * along(x, 14, arc / 18, s + 4, 2);

    // Every millimetre the knife took off shows an older ring: the figure is a contour map of the cut.
    const cut = drawknife(x, arc, log);
    const taken =
      3.4 * along(x, 3, w / 46, s + 5, 3) + 1.1 * along(x, 9, w / 17, s + 6, 2) + 2 * cut;
    const late = latewood((taken + 40) / log.yearWidth + 0.12 * along(x, 40, w / 3, s + 7, 1), s);
    const grain =
      0.5 * noise((x / TILE) * 36, w / 1.9, s + 8, 36) +
      0.35 * noise((x / TILE) * 18, w / 3.6, s + 9, 18) +
      0.3 * noise((x / TILE) * 64, w / 1.3, s + 10, 64);
    const streak =
      0.55 * along(x, 3, w / 11, s + 11, 2) +
      0.6 * along(x, 5, w / 4.2, s + 12, 2) +
      0.4 * along(x, 9, w / 2.4, s + 24, 1);

    const check = checkDepth(x, knot.across, log.checks, TILE, 0.9) * (1 - knot.inside);
    const barkEdge =
      along(x, 8, w / 30, s + 13, 5) +
      0.3 * along(x, 40, w / 7, s + 25, 3) +
      0.15 * grain +
      log.bark -
      0.42;
    const bark = smoothstep(0, 0.05, barkEdge) * (0.7 + 0.3 * streak);

    const knotRing = 0.5 + 0.5 * Math.sin(knot.radius * 21 + noise(x / 7, arc / 7, s + 14));
    let height =
      ROUNDNESS * radius * (Math.cos(angle) - 1) +
      cut +
      0.3 * late +
      0.2 * grain +
      0.42 * streak +
      1.2 * along(x, 5, arc / 60, s + 15, 4) +
      2.2 * swell +
      0.5 * bark +
      knot.inside * (0.5 - 1.1 * knot.radius * knot.radius + 0.3 * knotRing) -
      2.2 * knot.star -
      7 * check;

    const side = y < (index + 0.5) * PITCH ? 0 : 1;
    const jointIndex = (index + side) % LOGS;
    const off = y - (index + side) * PITCH;
    const joint = mortar(x, off, jointIndex);
    const mortarHeight = BED + joint.height;
    const proud = mortarHeight - height;
    const smear =
      0.5 * along(x, 60, off / 9, seed + 19 + jointIndex, 3) +
      0.7 * along(x, 14, jointIndex * 2.7 + side * 9, seed + 20, 2);
    const chink = smoothstep(-0.5, 0.9, proud + 1.5 * smear);
    // Mortar shrinks from the wood as it dries, and parts from one side of it here and there.
    const parted =
      bell(proud + 1.5 * smear, 0.8) *
      smoothstep(-0.1, 0.35, along(x, 6, jointIndex * 5.1 + side * 3.3, seed + 21, 3));

    const patch = along(x, 4, arc / 120, s + 16, 4);
    const color = texel.albedo;
    paintWood(color, { ...knot, log, late, fibre: grain, streak, patch, bark, knotRing, check });

    const dusty =
      smoothstep(0.25, -0.95, height01) * (0.55 + 0.45 * along(x, 9, arc / 25, s + 17, 3));
    cover(color, DUST, clamp(0.38 * dusty * (1 - check)));
    const sooty =
      smoothstep(-0.1, 0.5, fractalNoise((x / TILE) * 4, (y / TILE) * 5, seed + 22, 5, 4, 5)) *
        0.4 +
      smoothstep(0.45, 1, Math.abs(height01)) * 0.5;
    glaze(color, SOOT, clamp(sooty));

    cover(color, joint.albedo, chink);
    cover(color, SHADOW, 0.75 * parted);
    height = mix(height, Math.max(height, mortarHeight), chink) - 2.2 * parted;

    texel.height = height;
    const timber =
      0.6 -
      0.12 * late +
      0.08 * grain +
      0.1 * along(x, 11, arc / 40, s + 18, 4) +
      0.12 * dusty -
      0.1 * knot.inside +
      0.12 * bark -
      0.05 * cut;
    texel.roughness = mix(mix(timber, 0.95, check), joint.roughness, chink);
  };
}

export const logs = {
  name: "logs",
  size: 1024,
  tile: 1.6,
  seed: 3,
  sampler,
  weathering: { radius: 6, depth: 1.6, dirt: [0.5, 0.48, 0.46], roughness: 0.1 },
};
