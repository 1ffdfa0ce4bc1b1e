import { boardFigure, sawBoard } from "../boards.mjs";
import { bell, cellular, clamp, noise, randomStream, smoothstep, tiledNoise } from "../noise.mjs";
import { cover, glaze, pigment, scale, set } from "../pigment.mjs";

/**
 * Limed and waxed oak for furniture: four boards of 400 mm along u, without gaps, each running round the
 * tile: v 0 to 1/4 and 3/4 to 1 flat-sawn, 1/4 to 1/2 rift-sawn, 1/2 to 3/4 quarter-sawn with its rays.
 */

const TILE = 1600;
const BOARDS = 4;
const WIDTH = TILE / BOARDS;

const EARLY = pigment(0xb9a789);
const LATE = pigment(0x7b6645);
const LIMED = pigment(0xaca598);
const RAY = pigment(0xc4b698);
const PORE = pigment(0x51453a);
const KNOT = pigment(0x4c3d2f);
const GRIME = [0.48, 0.44, 0.4];

/** How each board left the log: where its pith lay, and how much of the rays the cut shows. */
const CUTS = [
  { pithAcross: 0.46, pithDepth: 46, yearWidth: 8, rays: 0.1, knots: 1.6, tone: 1.02, grey: 0.25 },
  {
    pithAcross: -0.9,
    pithDepth: 150,
    yearWidth: 5.5,
    rays: 0.35,
    knots: 0,
    tone: 0.86,
    grey: 0.45,
  },
  { pithAcross: -1.3, pithDepth: 12, yearWidth: 6.5, rays: 1, knots: 0, tone: 0.98, grey: 0.2 },
  { pithAcross: 0.62, pithDepth: 30, yearWidth: 9.5, rays: 0, knots: 3.2, tone: 0.9, grey: 0.6 },
];

function sampler(seed) {
  const boards = CUTS.map((cut, row) => {
    const board = sawBoard(randomStream(row, seed), seed, {
      length: TILE,
      width: WIDTH,
      knots: cut.knots,
      checks: 5,
    });
    return {
      ...cut,
      ...board,
      pithAcross: WIDTH * cut.pithAcross,
      pithDepth: cut.pithDepth,
      yearWidth: cut.yearWidth,
    };
  });
  const everywhere = tiledNoise(TILE, seed);
  const lengthwise = (x, wavelength, across, offset) => {
    const cycles = Math.round(TILE / wavelength);
    return noise((x / TILE) * cycles, across, offset, cycles, 0);
  };

  return (x, y, texel) => {
    const row = Math.floor(y / WIDTH);
    const board = boards[row];
    const s = board.seed;
    const figure = boardFigure(board, x, y - row * WIDTH, TILE);
    const w = figure.across;

    // Oak is ring-porous: its vessels stand in rows in the spring wood.
    const pore =
      smoothstep(0, 0.5, lengthwise(x, 34, w / 1.9, s + 50)) *
      clamp(1 - 3.2 * figure.late) *
      (0.6 + 0.4 * lengthwise(x, 120, w / 14, s + 51)) *
      (1 - figure.inside);
    const leaning = w + 0.22 * x;
    const fleck =
      board.rays *
      smoothstep(
        0.22,
        0.42,
        lengthwise(x, 34, leaning / 7, s + 52) + 0.35 * lengthwise(x, 150, w / 40, s + 53),
      );
    const chatter =
      Math.sin(x / 2.1 + 1.5 * noise(w / 60, row, s + 54)) *
      smoothstep(0.1, 0.6, lengthwise(x, 180, row, s + 55));

    const handled = smoothstep(-0.25, 0.6, everywhere(x, y, 4, 1, 4));
    const blow = cellular((x / TILE) * 34, (y / TILE) * 34, seed + 40, 34, 34);
    const dent =
      blow.id % 100 < 9 ? smoothstep(0.05 + 0.001 * (blow.id % 97), 0.02, blow.nearest) : 0;
    const first = Math.abs(everywhere(x + y, y - 2 * x, 6, 4, 1));
    const second = Math.abs(everywhere(x - 2 * y, y + x, 7, 5, 1));
    const scratch =
      smoothstep(0.009, 0.002, first) * smoothstep(0.1, 0.4, everywhere(x, y, 6, 6, 2)) +
      smoothstep(0.007, 0.002, second) * smoothstep(0.1, 0.4, everywhere(x, y, 6, 7, 2));

    texel.height =
      0.2 * figure.late +
      0.07 * figure.fibre +
      0.16 * figure.streak -
      0.3 * pore +
      0.06 * fleck +
      0.02 * chatter +
      0.35 * lengthwise(x, 260, w / 60, s + 56) +
      0.9 * figure.swell +
      figure.inside * (0.3 - 0.5 * figure.radius ** 2) -
      1.4 * figure.star -
      1.8 * figure.check -
      0.35 * dent -
      0.08 * scratch;

    const color = texel.albedo;
    set(color, EARLY);
    cover(
      color,
      LATE,
      clamp(0.05 + 0.95 * figure.late + 0.16 * figure.fibre + 0.3 * figure.streak),
    );
    cover(
      color,
      LIMED,
      clamp(board.grey + 0.4 * everywhere(x, y, 4, 8)) * (0.6 - 0.4 * figure.late),
    );
    cover(color, RAY, 0.55 * fleck);
    scale(color, board.tone * (1 + 0.16 * figure.streak + 0.1 * figure.fibre));
    cover(
      color,
      KNOT,
      clamp(0.55 * figure.halo ** 2 + figure.inside * (0.4 + 0.4 * figure.knotRing)),
    );
    scale(color, 1 - 0.7 * figure.rim * figure.inside * bell(figure.radius - 0.97, 0.1));
    cover(color, PORE, clamp(0.34 * pore));
    cover(color, PORE, clamp(0.9 * figure.check + 0.9 * figure.star));
    const grime = smoothstep(0.1, 0.8, everywhere(x, y, 5, 9, 5));
    glaze(color, GRIME, clamp(0.5 * grime + 0.1 * scratch));
    scale(color, 1 + 0.1 * handled);

    texel.roughness =
      0.5 -
      0.08 * figure.late +
      0.05 * figure.fibre +
      0.2 * pore -
      0.1 * fleck -
      0.15 * handled +
      0.1 * everywhere(x, y, 11, 10, 5) +
      0.05 * everywhere(x, y, 70, 11, 2) +
      0.12 * grime +
      0.12 * clamp(scratch) +
      0.3 * figure.check;
  };
}

export const trim = {
  name: "trim",
  size: 1024,
  tile: 1.6,
  seed: 29,
  sampler,
  weathering: { radius: 3, depth: 0.9, dirt: [0.6, 0.56, 0.52], roughness: 0.06 },
};
