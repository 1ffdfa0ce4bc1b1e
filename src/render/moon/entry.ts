import type { Model } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { pointsIn } from "../points.js";

/** Points along each edge of the room that rays to the moon are cast from. */
const POINTS: Readonly<Vec3> = [20, 10, 20];

/**
 * Whether moonlight reaches any point of a room.
 *
 * Without this test, a room of walls without thickness would have thin bright lines where they meet, since the bias
 * of the shadow map is some millimetres.
 *
 * @param casters that block the light
 */
export function entersRoom(
  direction: Vec3,
  casters: CollisionMesh,
  bounds: Model["bounds"],
): boolean {
  const toMoon: Vec3 = [-direction[0], -direction[1], -direction[2]];
  for (const point of pointsIn(bounds, POINTS)) {
    if (!casters.raycast(point, toMoon, Number.POSITIVE_INFINITY)) return true;
  }
  return false;
}
