import type { Part } from "../../assets/model.js";
import type { CollisionMesh } from "../../world/room/collision-mesh.js";
import { isMostlyClear } from "../mesh/mesh.js";

/** Rays of light that bounces. */
export type LightRays = Pick<CollisionMesh, "raycast" | "isClear">;

/** Rays of a room's light: glass and the like, of which nothing or little is drawn, do not stop them. */
export function lightRays(collision: CollisionMesh, parts: readonly Part[]): LightRays {
  if (!parts.some(isMostlyClear)) return collision;
  const clear = clearTriangles(parts);
  return {
    raycast: (origin, direction, farthest) => collision.raycast(origin, direction, farthest, clear),
    isClear: (from, to) => collision.isClear(from, to, clear),
  };
}

/** 1 for each triangle of a part that is mostly clear, else 0; one part after the other. */
function clearTriangles(parts: readonly Part[]): Uint8Array {
  const counts = parts.map(({ indices }) => Math.floor(indices.length / 3));
  const clear = new Uint8Array(counts.reduce((sum, count) => sum + count, 0));
  let first = 0;
  for (const [i, part] of parts.entries()) {
    const end = first + (counts[i] ?? 0);
    if (isMostlyClear(part)) clear.fill(1, first, end);
    first = end;
  }
  return clear;
}
