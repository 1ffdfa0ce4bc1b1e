import type { Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";

/** Of a wick whose flame has no wick drawn in it: as the taper's. Metres. */
const DEFAULT = 0.0072;
/** A wick is within this distance of the axis of its flame, and ends at most so far above its root. Metres. */
const REACH = 0.006;
const HIGHEST = 0.03;

/** Height of a wick's end above the root of its flame, metres. */
export function wickEnd(
  [x, y, z]: Readonly<Vec3>,
  wicks: readonly Pick<Part, "positions">[],
): number {
  let end = 0;
  for (const { positions } of wicks) {
    for (let at = 0; at < positions.length; at += 3) {
      const height = positions[at + 1]! - y;
      if (height <= end || height > HIGHEST) continue;
      if (Math.hypot(positions[at]! - x, positions[at + 2]! - z) < REACH) end = height;
    }
  }
  return end || DEFAULT;
}
