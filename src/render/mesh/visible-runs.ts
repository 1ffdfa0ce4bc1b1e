import type { Bounds } from "../../world/geometry.js";
import { AT_ORIGIN, type Placement } from "../frame-input.js";
import { type Run, runsOf } from "./clusters.js";
import type { Mesh } from "./mesh.js";

/**
 * Frustum culling: the visible triangles of a mesh, as runs of its indices.
 *
 * By clusters where the model stands as it was made, else as a whole.
 *
 * @param most runs; to have no more, hidden clusters are drawn, too
 */
export function visibleRuns(
  { clusters, vertexArray }: Mesh,
  placement: Placement,
  isVisible: (box: Bounds) => boolean,
  most?: number,
): readonly Run[] {
  if (placement === AT_ORIGIN) return runsOf(clusters, isVisible, most);
  return isVisible(boundsOfTurned(clusters, placement))
    ? [{ first: 0, count: vertexArray.count }]
    : [];
}

/** Bounds of clusters that are turned about the vertical by any angle, and moved. */
export function boundsOfTurned(clusters: readonly Bounds[], [x, y, z]: Placement): Bounds {
  let [radius, low, high] = [0, 0, 0];
  for (const { min, max } of clusters) {
    const wide = [0, 2].map((axis) => Math.max(Math.abs(min[axis]!), Math.abs(max[axis]!)));
    radius = Math.max(radius, Math.hypot(...wide));
    low = Math.min(low, min[1]);
    high = Math.max(high, max[1]);
  }
  return { min: [x - radius, y + low, z - radius], max: [x + radius, y + high, z + radius] };
}
