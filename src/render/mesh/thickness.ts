/** Least share of a surface that faces some way on the whole for it to be open. */
const OPEN = 0.02;
/** Sums over the triangles of a thing: its volume, its area, and which way it faces on the whole. */
const SUMS = 5;

/**
 * How thick the thing is in the mean that each point belongs to, metres; infinite where it is open.
 *
 * @param positions xyz of each point, metres
 * @param corners points of the triangles, three to each: what hangs together is a thing
 */
export function thicknessesOf(
  positions: ArrayLike<number>,
  corners: ArrayLike<number>,
): Float64Array {
  const count = positions.length / 3;
  const things = thingsOf(count, corners);
  const sums = new Float64Array(count * SUMS);
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * corners[i + k]!) as [number, number, number];
    const at = things[corners[i]!]! * SUMS;
    let squared = 0;
    for (let k = 0; k < 3; k++) {
      const [m, n] = [(k + 1) % 3, (k + 2) % 3];
      const along = (to: number, axis: number) => positions[to + axis]! - positions[a + axis]!;
      const twice = along(b, m) * along(c, n) - along(b, n) * along(c, m);
      sums[at]! += (positions[a + k]! * twice) / 6;
      sums[at + 2 + k]! += twice / 2;
      squared += twice * twice;
    }
    sums[at + 1]! += Math.sqrt(squared) / 2;
  }
  return Float64Array.from(things, (thing) => {
    const [volume = 0, area = 0, ...facing] = sums.subarray(thing * SUMS, (thing + 1) * SUMS);
    // What is closed faces all ways alike.
    if (Math.hypot(...facing) > OPEN * area) return Number.POSITIVE_INFINITY;
    return (2 * Math.abs(volume)) / Math.max(area, 1e-12);
  });
}

/** For each point one of those that it hangs together with, the same for all of them. */
function thingsOf(count: number, corners: ArrayLike<number>): Uint32Array {
  const parents = Uint32Array.from({ length: count }, (_, point) => point);
  const thingOf = (point: number): number => {
    let root = point;
    while (parents[root] !== root) {
      parents[root] = parents[parents[root]!]!;
      root = parents[root]!;
    }
    return root;
  };
  for (let i = 0; i < corners.length; i++) {
    parents[thingOf(corners[i]!)] = thingOf(corners[i - (i % 3)]!);
  }
  return parents.map((_, point) => thingOf(point));
}
