import { boardFigure, sawBoard } from "../boards.mjs";
import {
  bell,
  cellular,
  clamp,
  mix,
  noise,
  random,
  randomStream,
  smoothstep,
  tiledNoise,
} from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/**
 * A scrubbed pine floor gone grey: boards of 200 mm along u, butted and nailed on joists 533 mm apart,
 * dirt in the gaps, worn pale where people walk.
 */

const TILE = 1600;
const BOARDS = 8;
const WIDTH = TILE / BOARDS;
const JOISTS = 3;
const SPACING = TILE / JOISTS;

const EARLY = pigment(0xc4b493);
const LATE = pigment(0x79603f);
const GREY = pigment(0xa39e93);
const KNOT = pigment(0x50402f);
const CRACK = pigment(0x1c1814);
const GRIME = [0.42, 0.4, 0.39];
const RUST = [0.4, 0.34, 0.3];
const DIRT = pigment(0x2b2621);
const LINT = pigment(0x8d867a);
const IRON = pigment(0x3f3b38);
const IRON_RUST = pigment(0x5a4436);
const DUST = pigment(0xaaa496);

/** The boards of one row: it breaks once or twice in a tile, always on a joist. */
function layRow(row, seed) {
  const next = randomStream(row, seed * 7 + 5);
  const first = [0, 2, 1, 2, 0, 1, 0, 1][row];
  const joints = next() < 0.7 ? [first] : [first, (first + 1 + Math.floor(next(0, 2))) % JOISTS];
  joints.sort((a, b) => a - b);
  return joints.map((joist, index) => {
    const start = (joist + 0.5) * SPACING;
    const following = joints[index + 1];
    const end =
      following === undefined ? (joints[0] + 0.5) * SPACING + TILE : (following + 0.5) * SPACING;
    const board = sawBoard(next, seed, {
      length: end - start,
      width: WIDTH,
      knots: (2.8 * (end - start)) / TILE,
      checks: 9,
    });
    return {
      ...board,
      start,
      tone: next(0.68, 1.12),
      grey: next(0.05, 0.75),
      contrast: next(0.6, 1.05),
      lift: next(-0.9, 0.9),
      cup: next(-0.9, 0.7),
      tilt: next(-0.5, 0.5),
      gapAbove: 1.2 + 3.4 * next() ** 2,
      gapBelow: 1.2 + 3.4 * next() ** 2,
      gapEnd: next(0.8, 2.6),
      worn: next(0.4, 1),
    };
  });
}

function boardAt(row, x) {
  for (const board of row) {
    const local = x - board.start - (x < board.start ? -TILE : 0);
    if (local >= 0 && local < board.length) return board;
  }
  return row[row.length - 1];
}

/** Distance to the nearest nail, where the board crosses a joist or ends on one. */
const nail = { distance: 99, along: 0, across: 0, turn: 0 };

function findNail(board, x, y) {
  nail.distance = 99;
  const crossings = Math.round(board.length / SPACING);
  for (let k = 0; k <= crossings; k++) {
    const inset = k === 0 ? 26 : k === crossings ? -26 : 0;
    const alongBoard = k * SPACING + inset;
    if (Math.abs(x - alongBoard) > 60) continue;
    for (let side = 0; side < 2; side++) {
      const dx = x - alongBoard - 14 * (random(k, side, board.seed) - 0.5);
      const dy =
        y - board.width * (side ? 0.8 : 0.2) - 16 * (random(k, side + 2, board.seed) - 0.5);
      const distance = Math.hypot(dx, dy);
      if (distance < nail.distance) {
        nail.distance = distance;
        nail.along = dx;
        nail.across = dy;
        nail.turn = random(k, side + 4, board.seed);
      }
    }
  }
  return nail;
}

function sampler(seed) {
  const rows = Array.from({ length: BOARDS }, (_, row) => layRow(row, seed));
  const everywhere = tiledNoise(TILE, seed);

  return (x, y, texel) => {
    texel.iron ??= [0, 0, 0];
    texel.filth ??= [0, 0, 0];
    const row = Math.floor(y / WIDTH);
    const board = boardAt(rows[row], x);
    const s = board.seed;
    let localX = x - board.start;
    if (localX < 0) localX += TILE;
    const localY = y - row * WIDTH;
    const figure = boardFigure(board, localX, localY, TILE);

    const frayed = (side) =>
      0.5 * noise(localX / 90, side, s + 30) +
      0.35 * noise(localX / 17, side, s + 31) +
      0.9 * Math.max(0, noise(localX / 9, side, s + 32) - 0.35);
    const toAbove = localY - 0.5 * board.gapAbove - frayed(0.5);
    const toBelow = WIDTH - localY - 0.5 * board.gapBelow - frayed(7.5);
    const chipped = 0.3 * noise(localY / 12, 2, s + 33) + 0.3 * figure.fibre;
    const toEnd = Math.min(localX, board.length - localX) - 0.5 * board.gapEnd - chipped;
    const toEdge = Math.min(toAbove, toBelow, toEnd);
    const gap = 1 - smoothstep(-0.7, 0.5, toEdge);

    const traffic = smoothstep(-0.3, 0.7, everywhere(x, y, 3, 1)) * smoothstep(0, 30, toEdge);
    const debris = smoothstep(
      -0.2,
      0.5,
      everywhere(x, y, 6, 2) + 0.35 * everywhere(x, y, 110, 3, 2),
    );

    const off = localY / (WIDTH / 2) - 1;
    const eased = 2.4 + 1.4 * noise(localX / 140, 0.4, s + 34);
    const rounding = 1 - clamp(toEdge / eased);
    const scrubbed = 0.34 + 0.3 * board.worn;
    let height =
      board.lift +
      board.cup * (off * off - 0.4) +
      board.tilt * off -
      1.5 * rounding * rounding +
      scrubbed * figure.late * (1 - 0.6 * figure.inside) +
      0.13 * figure.fibre -
      0.3 * figure.pore +
      0.3 * figure.streak +
      0.35 * noise(localX / 200, localY / 55, s + 35) +
      1.1 * figure.swell +
      figure.inside * (0.5 - 0.6 * figure.radius * figure.radius) -
      1.6 * figure.star -
      3 * figure.check;
    const blow = cellular((x / TILE) * 30, (y / TILE) * 30, seed + 40, 30, 30);
    const dent =
      blow.id % 100 < 14 ? smoothstep(0.05 + 0.001 * (blow.id % 97), 0.02, blow.nearest) : 0;
    height -= 0.4 * dent;
    const line = Math.abs(everywhere(x + 2 * y, y - x, 6, 6, 1));
    const scratch =
      smoothstep(0.011, 0.003, line) * smoothstep(0.1, 0.5, everywhere(x, y, 7, 7, 2)) * (1 - gap);
    height -= 0.22 * scratch;

    const color = texel.albedo;
    set(color, EARLY);
    cover(
      color,
      LATE,
      clamp(0.06 + board.contrast * figure.late + 0.16 * figure.fibre + 0.16 * figure.streak),
    );
    const patch = everywhere(x, y, 5, 8);
    cover(color, GREY, clamp(board.grey + 0.45 * patch) * (0.7 - 0.5 * figure.late));
    scale(color, board.tone * (1 + 0.16 * figure.streak + 0.1 * figure.fibre));
    cover(
      color,
      KNOT,
      clamp(0.5 * figure.halo ** 2 + figure.inside * (0.35 + 0.4 * figure.knotRing)),
    );
    scale(color, 1 - 0.8 * figure.rim * figure.inside * bell(figure.radius - 0.97, 0.1));
    scale(color, 1 - 0.12 * figure.pore);
    cover(color, CRACK, clamp(0.9 * figure.check + 0.85 * figure.star));
    scale(color, 1 + 0.2 * traffic * (1 - 0.5 * figure.late));

    const spill = smoothstep(0.2, 0.75, everywhere(x, y, 4, 9, 5));
    const grime =
      0.8 *
        Math.exp(-Math.max(0, toEdge) / 5) *
        (0.55 + 0.45 * noise(localX / 30, localY / 30, s + 36)) +
      0.45 * Math.exp(-Math.max(0, toEdge) / 24) * (0.5 + 0.5 * noise(localX / 110, row, s + 37)) +
      0.45 * spill;
    glaze(color, GRIME, clamp(0.75 * grime));

    const head = findNail(board, localX, localY);
    const bleed = Math.exp(-Math.hypot(0.26 * head.along, 1.5 * head.across) / 4.5);
    glaze(color, RUST, clamp(0.9 * bleed));
    // Rose heads, hammered: four facets and no two alike.
    const facets =
      0.5 * Math.abs(Math.cos(2 * Math.atan2(head.across, head.along) + 6 * head.turn));
    const isNail = 1 - smoothstep(4.1 + facets, 4.9 + facets, head.distance);
    const sunk = smoothstep(10, 4.5, head.distance) * (1 - isNail);
    height -= 0.7 * sunk;
    height = mix(
      height,
      board.lift - 0.2 - 0.035 * head.distance ** 2 + 0.12 * noise(x / 2, y / 2, seed + 10),
      isNail,
    );
    const rusty = smoothstep(-0.2, 0.5, noise(x / 3, y / 3, seed + 11));
    set(texel.iron, IRON);
    cover(texel.iron, IRON_RUST, rusty);
    cover(color, texel.iron, isNail);

    const dust =
      0.3 * smoothstep(0, 0.7, everywhere(x, y, 7, 12)) * (1 - traffic) +
      0.25 * figure.pore * traffic;
    cover(color, DUST, 0.5 * dust * (1 - isNail));

    set(texel.filth, DIRT);
    cover(texel.filth, LINT, 0.6 * debris * clamp(0.5 + 0.6 * everywhere(x, y, 170, 13, 1)));
    cover(color, texel.filth, 0.94 * gap);
    height -= gap * (5.5 - 3.4 * debris);

    texel.height = height;
    const timber =
      0.52 -
      0.1 * figure.late +
      0.06 * figure.fibre +
      0.05 * figure.pore -
      0.17 * traffic +
      0.13 * everywhere(x, y, 9, 14, 5) +
      0.07 * everywhere(x, y, 60, 15, 2) +
      0.1 * clamp(grime) +
      0.3 * dust +
      0.1 * scratch -
      0.08 * figure.inside;
    texel.roughness = mix(
      mix(timber, 0.5 + 0.25 * rusty, isNail),
      0.96,
      Math.max(gap, figure.check),
    );
    texel.metallic = isNail * (1 - 0.7 * rusty) * (1 - gap);
  };
}

export const planks = {
  name: "planks",
  size: 1024,
  tile: 1.6,
  seed: 11,
  sampler,
  weathering: { radius: 4, depth: 1.4, dirt: [0.5, 0.47, 0.45], roughness: 0.1 },
};
