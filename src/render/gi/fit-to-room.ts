import type { Model } from "../../assets/model.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { interiorBounds } from "./interior-bounds.js";
import type { ProbeDetail } from "./probe-rays.js";

/** Largest distance of probes along a room's floor, metres. */
const WIDEST = 0.9;
/** At most so many times as many probes as in a small room. */
const MOST = 1.7;

/**
 * Resolution of an irradiance volume with more probes along the floor of a large room. Even numbers: of odd ones the
 * middle is in a wall that halves the room.
 */
export function fitToRoom<Detail extends ProbeDetail>(
  detail: Detail,
  collision: CollisionMesh,
  model: Model,
): Detail {
  const { min, max } = interiorBounds(collision, model);
  const [columns, rows, planes] = detail.probes;
  const along = (axis: 0 | 2, least: number) =>
    Math.max(least, 2 * Math.ceil((max[axis] - min[axis]) / (2 * WIDEST)));
  let [across, deep] = [along(0, columns), along(2, planes)];
  while (across * deep > MOST * columns * planes) {
    if (across / columns > deep / planes) across -= 2;
    else deep -= 2;
  }
  return { ...detail, probes: [across, rows, deep] };
}
