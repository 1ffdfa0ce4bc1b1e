import { length3 } from "../../world/geometry.js";
import { LINES, ROWS, SMOKE_FLOATS, type Smoke } from "../../world/particles/smoke.js";

/** Most ends of pieces along a line of smoke. */
export const MOST_SECTIONS = 2 * ROWS;
/** Optical depth that nobody sees. */
export const FAINT = 1e-5;
/** Least sine between a line and the view ray: a line seen along itself has a longer path through it, up to this. */
export const LEAST_SINE = 0.3;
/** Cross-section over breadth and optical depth, of a line seen at `LEAST_SINE`. */
const LENGTHENED = LEAST_SINE * Math.sqrt(2 * Math.PI);
/** Longest piece, metres, and most that its line turns: the distance between directions of length 1. */
const LONGEST = 0.012;
const MOST_BEND = 0.3;
/** Shorter ones are not divided, however their line turns. Metres. */
const SHORTEST = 0.003;
/** Most pieces between two rows. */
const MOST_PIECES = 8;
/** Lines that are measured: each of this many. */
const STRIDE = 4;

/** Pieces that are asked for from each row to the next older one, the youngest first. */
const asked = new Uint8Array(ROWS);

/**
 * Divides the lines of smoke into pieces: one from each row to the next, more where rows lie far apart or the line turns,
 * as in a breath, which carries a parcel 10 cm in a step.
 *
 * @param ends receives where pieces end, in rows from the youngest; the first is 0
 * @returns how many pieces there are
 */
export function setSections(ends: Float32Array, smoke: Smoke): number {
  const last = smoke.count - 1;
  asked.fill(1);
  for (let line = 0; line < LINES; line += STRIDE) ask(smoke, line);
  let spare = MOST_SECTIONS - 1 - last;
  let pieces = 0;
  for (let age = 0; age < last; age++) {
    const count = Math.min(asked[age]!, 1 + spare);
    spare -= count - 1;
    for (let n = 0; n < count; n++) {
      const t = n / count;
      // Where a breath begins to spread it, smoke changes most beside the wick.
      ends[pieces++] = age + (age === 0 ? t * t : t);
    }
  }
  ends[pieces] = last;
  return pieces;
}

/** Most that is seen through the centre of a parcel's line. */
export function opticalDepth(parcels: Float32Array, at: number): number {
  return parcels[at + 3]! / (parcels[at + 4]! * LENGTHENED);
}

/** Raises `asked` to what a line needs where it is seen. */
function ask({ parcels, newest, count }: Smoke, line: number): void {
  const indexOf = (age: number) => (((newest - age + ROWS) % ROWS) * LINES + line) * SMOKE_FLOATS;
  let [x, y, z, before] = [0, 0, 0, 0];
  let here = indexOf(0);
  for (let age = 0; age < count - 1; age++) {
    const next = indexOf(age + 1);
    const dx = parcels[next]! - parcels[here]!;
    const dy = parcels[next + 1]! - parcels[here + 1]!;
    const dz = parcels[next + 2]! - parcels[here + 2]!;
    const length = Math.max(length3(dx, dy, dz), 1e-6);
    if (Math.max(opticalDepth(parcels, here), opticalDepth(parcels, next)) > FAINT) {
      raise(age, length / LONGEST);
      const bend = age === 0 ? 0 : length3(dx / length - x, dy / length - y, dz / length - z);
      if (length > SHORTEST) raise(age, bend / MOST_BEND);
      if (before > SHORTEST) raise(age - 1, bend / MOST_BEND);
    }
    x = dx / length;
    y = dy / length;
    z = dz / length;
    before = length;
    here = next;
  }
}

function raise(age: number, pieces: number): void {
  asked[age] = Math.max(asked[age]!, Math.min(Math.ceil(pieces), MOST_PIECES));
}
