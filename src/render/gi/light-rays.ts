import type { Part } from "../../assets/model.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { isMostlyClear } from "../mesh/mesh.js";
import { partsOfTriangles } from "../mesh/triangles.js";

/** Rays of light that bounces. */
export type LightRays = Pick<CollisionMesh, "raycast" | "isClear">;

/** Rays of a room's light: glass and the like, of which nothing or little is drawn, do not stop them. */
export function lightRays(collision: CollisionMesh, parts: readonly Part[]): LightRays {
  if (!parts.some(isMostlyClear)) return collision;
  const ofParts = parts.map((part) => Number(isMostlyClear(part)));
  // 1 for each triangle that is.
  const clear = Uint8Array.from(partsOfTriangles(parts), (i) => ofParts[i]!);
  return {
    raycast: (origin, direction, farthest) => collision.raycast(origin, direction, farthest, clear),
    isClear: (from, to) => collision.isClear(from, to, clear),
  };
}
