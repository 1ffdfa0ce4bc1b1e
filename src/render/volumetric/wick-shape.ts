import type { Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";
import { UPRIGHT } from "./flame-pass.js";

/** Of a wick whose flame has no wick drawn in it: as the taper's. Metres. */
const DEFAULT = 0.0072;
/** A wick is within this distance of the axis of its flame, and ends at most so far above its root. Metres. */
const REACH = 0.006;
const HIGHEST = 0.03;

/** A wick from the root of its flame, metres. */
export interface WickShape {
  /** Height of its highest vertex. */
  readonly end: number;
  /** Of its centre line, the lowest first. */
  readonly nodes: readonly Readonly<Vec3>[];
}

/** Shape of the wick that is drawn in a flame: means of its vertices at even heights. */
export function wickShape(
  [x, y, z]: Readonly<Vec3>,
  wicks: readonly Pick<Part, "positions">[],
): WickShape {
  const vertices: Vec3[] = [];
  let end = 0;
  for (const { positions } of wicks) {
    for (let at = 0; at < positions.length; at += 3) {
      const from: Vec3 = [positions[at]! - x, positions[at + 1]! - y, positions[at + 2]! - z];
      const isNear = from[1] > 0 && from[1] <= HIGHEST && Math.hypot(from[0], from[2]) < REACH;
      if (!isNear) continue;
      vertices.push(from);
      end = Math.max(end, from[1]);
    }
  }
  if (end === 0) return { end: DEFAULT, nodes: UPRIGHT };
  const nodes: Vec3[] = [];
  for (const i of UPRIGHT.keys()) {
    const share = i / (UPRIGHT.length - 1);
    const about = vertices.filter(([, height]) => Math.abs(height / end - share) < 1 / 6);
    const mean = (axis: 0 | 2) =>
      about.reduce((sum, from) => sum + from[axis], 0) / about.length || nodes[i - 1]?.[axis] || 0;
    nodes.push([mean(0), share * end, mean(2)]);
  }
  return { end, nodes };
}
