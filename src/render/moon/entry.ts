import type { Model, Part } from "../../assets/model.js";
import type { Vec3 } from "../../world/geometry.js";
import { CollisionMesh } from "../../world/room/collision-mesh.js";

/** Points along each edge of the room that rays to the moon are cast from. */
const POINTS = [20, 10, 20] as const;

/**
 * Whether moonlight reaches any point of a room.
 *
 * Without this test, a room of walls without thickness would have thin bright lines where they meet, since the bias
 * of the shadow map is some millimetres.
 *
 * @param parts that block the light
 */
export function entersRoom(
  direction: Vec3,
  parts: readonly Pick<Part, "positions" | "indices">[],
  { min, max }: Model["bounds"],
): boolean {
  const casters = new CollisionMesh(parts);
  const toMoon: Vec3 = [-direction[0], -direction[1], -direction[2]];
  const point: Vec3 = [0, 0, 0];
  const [columns, rows, planes] = POINTS;
  for (let i = 0; i < columns * rows * planes; i++) {
    const place = [i % columns, Math.floor(i / columns) % rows, Math.floor(i / (columns * rows))];
    for (const axis of [0, 1, 2] as const) {
      const share = (place[axis]! + 0.5) / POINTS[axis];
      point[axis] = min[axis] + share * (max[axis] - min[axis]);
    }
    if (!casters.raycast(point, toMoon, Number.POSITIVE_INFINITY)) return true;
  }
  return false;
}
