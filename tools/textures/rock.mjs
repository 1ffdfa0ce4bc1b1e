import { cellular, clamp, fractalNoise, hash, smoothstep } from "./noise.mjs";
import { cover, pigment, scale, set } from "./pigment.mjs";

/**
 * Hammer-dressed field stone in cool greys. Lengths in mm; everything repeats after `period` both ways.
 */

const LIGHT = pigment(0xa0a29e);
const DARK = pigment(0x70736f);
const BANDED_LIGHT = pigment(0x858a8b);
const BANDED_DARK = pigment(0x555b5f);
const FELDSPAR = pigment(0xa3a19c);
const MICA = pigment(0x626365);
const QUARTZ = pigment(0xbdbdb8);
const WARM = [1.06, 1, 0.9];

/** Noise of about `wavelength` mm that repeats with the period. */
function grain(x, y, wavelength, seed, octaves, period, stretch = 1) {
  const across = Math.max(1, Math.round(period / (wavelength * stretch)));
  const down = Math.max(1, Math.round(period / wavelength));
  return fractalNoise((x / period) * across, (y / period) * down, seed, octaves, across, down);
}

/**
 * Flats left by the hammer, each with its own dip, meeting along arrises: the lower envelope of bowls
 * round scattered points. About -1..1.
 */
function spalls(x, y, size, seed, period) {
  const cells = Math.round(period / size);
  const unit = period / cells;
  const column = Math.floor(x / unit);
  const row = Math.floor(y / unit);
  let lowest = 9;
  for (let j = row - 1; j <= row + 1; j++) {
    for (let i = column - 1; i <= column + 1; i++) {
      const bits = hash(((i % cells) + cells) % cells, ((j % cells) + cells) % cells, seed);
      const dx = x / unit - i - (bits & 255) / 256;
      const dy = y / unit - j - ((bits >>> 8) & 255) / 256;
      const dip = (((bits >>> 16) & 255) / 255 - 0.5) * 0.75;
      const turn = ((bits >>> 24) / 255) * 2 * Math.PI;
      const flat =
        dip * (Math.cos(turn) * dx + Math.sin(turn) * dy) + 0.75 * (dx * dx + dy * dy) + 0.25 * dip;
      if (flat < lowest) lowest = flat;
    }
  }
  return 2.2 * lowest - 0.3;
}

const face = {
  relief: 0,
  bands: 0,
  mottle: 0,
  sand: 0,
  speckle: 0,
  crystal: 0,
  vein: 0,
  pecked: 0,
};

/**
 * The face of a stone at (x, y): relief in mm, and the patterns its colour is made of. `bed` is the
 * distance across the layers it was laid down in, `layered` 0..1 how much they show. The returned object
 * is reused by the next call.
 */
export function rockFace(x, y, { bed, layered, seed, period }) {
  face.bands = grain(x, bed, 26, seed + 2, 4, period, 12);
  face.mottle = grain(x, y, 80, seed + 6, 5, period);
  face.sand = grain(x, y, 4.8, seed + 10, 1, period) + 0.6 * grain(x, y, 8.9, seed + 11, 1, period);
  face.speckle =
    0.6 * grain(x, y, 6.5, seed + 12, 2, period) + 0.4 * grain(x, y, 15, seed + 13, 2, period);
  face.crystal = grain(x, y, 11, seed + 14, 2, period);
  const ribbon = Math.abs(
    grain(x, bed, 110, seed + 7, 1, period, 2) + 0.05 * grain(x, y, 24, seed + 8, 2, period),
  );
  face.vein =
    smoothstep(0.022, 0.004, ribbon) * smoothstep(0.15, 0.6, grain(x, y, 150, seed + 9, 1, period));
  const cells = Math.round(period / 13);
  const unit = period / cells;
  const pick = cellular(x / unit, y / unit, seed + 15, cells, cells);
  face.pecked = pick.id % 100 < 12 ? smoothstep(0.3, 0.05, pick.nearest) : 0;
  face.relief =
    5.5 * spalls(x, y, 95, seed + 3, period) +
    2.2 * spalls(x, y, 34, seed + 4, period) +
    2 * grain(x, y, 60, seed + 5, 5, period) +
    (0.2 + 0.7 * layered) * face.bands +
    0.16 * face.sand -
    0.8 * face.pecked;
  return face;
}

/** Colours a face: limestone, shading into banded gneiss with `layered` and into granite with `speckled`. */
export function paintRock(color, rock, { layered, speckled, warm, tone }) {
  set(color, DARK);
  cover(color, LIGHT, clamp(0.55 + 0.42 * rock.mottle + 0.2 * rock.speckle + 0.15 * rock.bands));
  if (layered > 0) {
    const band = clamp(0.5 + 0.45 * rock.bands + 0.4 * rock.mottle);
    for (let c = 0; c < 3; c++) {
      const banded = BANDED_DARK[c] + (BANDED_LIGHT[c] - BANDED_DARK[c]) * band;
      color[c] += (banded - color[c]) * layered;
    }
  }
  if (speckled > 0) {
    const grains = clamp(0.5 + 0.7 * rock.speckle);
    for (let c = 0; c < 3; c++) {
      const granite = MICA[c] + (FELDSPAR[c] - MICA[c]) * grains;
      color[c] += (granite - color[c]) * speckled;
    }
    cover(color, QUARTZ, 0.45 * speckled * smoothstep(0.5, 0.75, rock.crystal));
  }
  cover(color, QUARTZ, 0.5 * rock.vein);
  scale(color, tone * (1 + 0.1 * rock.mottle + 0.11 * rock.sand + 0.1 * rock.pecked));
  for (let c = 0; c < 3; c++) color[c] *= 1 + (WARM[c] - 1) * warm;
}
