import { clamp, fractalNoise, mix, noise, smoothstep } from "./noise.mjs";
import { bendRoundKnots, checkDepth, knotShape, latewood } from "./wood.mjs";

/**
 * A sawn board: a plane cut through a log's growth rings, which is what gives cathedrals where the cut
 * passes near the pith and stripes where it does not. Lengths in mm; x runs along the board.
 */
export function sawBoard(next, seed, { length, width, knots: mostKnots, checks: checkCount }) {
  const knots = [];
  const count = Math.floor(mostKnots * next() * 1.4);
  for (let k = 0; k < count; k++) {
    const shape = knotShape(next, seed, 4, 24);
    knots.push({ ...shape, along: length * next(0.05, 0.95), across: width * next(0.08, 0.92) });
  }
  const checks = [];
  for (let k = 0; k < checkCount; k++) {
    const reach = 40 + 260 * next() * next();
    const atEnd = next() < 0.75;
    checks.push({
      along: atEnd ? next(-0.1, 0.35) * reach + (next() < 0.5 ? 0 : length) : next(0, length),
      across: width * next(0.04, 0.96),
      length: 2 * reach,
      width: 0.6 + 1.8 * next() * next(),
      seed: Math.floor(next(0, 65536)),
    });
  }
  return {
    seed: Math.floor(next(0, 1 << 24)),
    length,
    width,
    knots,
    checks,
    pithAcross: width * next(-0.35, 1.35),
    pithDepth: 14 + 95 * next() ** 2,
    yearWidth: next(3.4, 7.5),
  };
}

const figure = {};

/**
 * What the saw laid bare at (x, y) of a board, y across it from its edge: latewood 0..1, fibre and
 * streak about -1..1, open pores 0..1, checks, and what `bendRoundKnots` says of knots. Repeats after `period` along the board. The
 * returned object is reused by the next call.
 */
export function boardFigure(board, x, y, period) {
  const { seed } = board;
  const lengthwise = (wavelength, across, offset, octaves = 1) => {
    const cycles = Math.max(1, Math.round(period / wavelength));
    return fractalNoise((x / period) * cycles, across, seed + offset, octaves, cycles, 0);
  };
  const knot = bendRoundKnots(x, y, board.knots, period);
  const check = checkDepth(x, knot.across, board.checks, period, 0.8);

  const w = knot.across + 3 * lengthwise(420, y / 70, 1) + 1 * lengthwise(160, y / 22, 2);
  // The pith wanders with the trunk, and with it the ring that lies in the cut.
  const fromPith =
    w - board.pithAcross - 24 * lengthwise(530, 0.5, 3) - 5 * lengthwise(150, 0.9, 4);
  const depth = board.pithDepth + 30 * lengthwise(640, 4.5, 5) + 8 * lengthwise(200, 0.2, 6);
  const radius = Math.hypot(fromPith, depth);
  const years =
    radius / board.yearWidth +
    0.3 * lengthwise(120, w / 9, 7) +
    0.1 * lengthwise(40, w / 2.8, 8) +
    0.8 * noise(radius / 40, 0.5, seed + 9);

  const knotRing = latewood(knot.radius * 4.2 + 0.25 * noise(x / 5, y / 5, seed + 10), seed + 11);
  Object.assign(figure, knot);
  figure.late = mix(latewood(years, seed + 12), knotRing, knot.inside);
  figure.fibre =
    0.5 * lengthwise(48, w / 1.9, 13) +
    0.35 * lengthwise(95, w / 3.3, 14) +
    0.3 * lengthwise(24, w / 1.4, 15);
  figure.pore =
    smoothstep(0.34, 0.62, lengthwise(26, w / 1.9, 16)) *
    (1 - 0.65 * figure.late) *
    (1 - knot.inside);
  figure.streak =
    0.5 * lengthwise(320, w / 40, 17) +
    0.35 * lengthwise(210, w / 13, 18) +
    0.4 * lengthwise(260, w / 4.5, 19);
  figure.across = w;
  figure.knotRing = knotRing;
  figure.check = clamp(check) * (1 - knot.inside);
  return figure;
}
