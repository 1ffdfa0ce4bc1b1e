import type { Material, Model } from "../assets/model.js";
import { clampInside, inset, type Vec3 } from "../world/geometry.js";
import type { CollisionMesh } from "../world/room/collision-mesh.js";
import { freePlace } from "../world/room/enclosed.js";
import type { Wick } from "../world/standing-candle.js";

/** Middle of a flame above its root, which may lie in wax, metres. */
const MIDDLE = 0.015;
/** Of a flame's middle from the room's box, and from what it was inside of. Metres. */
const MARGIN = 0.05;
/** Of a flame above an open scene's box, whose highest thing a wick may be, metres. */
const HEADROOM = 0.1;
const CLEARANCE = 0.03;

/**
 * The wicks of a room, each where a flame can burn; one warning for each kind that was moved.
 *
 * @param eye initial one, metres
 */
export function placeWicks(
  { wicks, parts }: Model,
  collision: CollisionMesh,
  eye: Readonly<Vec3>,
): readonly Wick[] {
  // Else all faces of the room point outwards, and backs tell nothing.
  const isEyeFree = freed(parts, collision, eye) === eye;
  const box = inset(collision.bounds, MARGIN);
  const around = inset(collision.bounds, -HEADROOM);
  let outside = 0;
  let enclosed = 0;
  const placed = wicks.map((wick): Wick => {
    const { position } = wick;
    const middle: Vec3 = [position[0], position[1] + MIDDLE, position[2]];
    const indoors: Vec3 = [...middle];
    clampInside(indoors, around);
    const isOutside = indoors.some((x, axis) => x !== middle[axis]);
    if (isOutside) clampInside(indoors, box);
    const free = isEyeFree ? freed(parts, collision, indoors) : indoors;
    const isEnclosed = free !== indoors;
    outside += isOutside ? 1 : 0;
    enclosed += isEnclosed ? 1 : 0;
    if (!isOutside && !isEnclosed) return wick;
    return { ...wick, position: [free[0], free[1] - MIDDLE, free[2]] };
  });
  if (outside > 0) console.warn("Wicks outside of the room were moved into it.");
  if (enclosed > 0) console.warn("Wicks inside of walls or furniture were moved out.");
  return placed;
}

/** The place itself, if it is not inside of a solid. */
function freed(parts: Model["parts"], collision: CollisionMesh, place: Readonly<Vec3>) {
  const isOpaque = (triangle: number) => materialOf(parts, triangle)?.alphaMode !== "blend";
  return freePlace(collision, place, CLEARANCE, isOpaque);
}

/** Of a triangle; these are numbered across the parts. */
export function materialOf(parts: Model["parts"], triangle: number): Material | undefined {
  let first = 0;
  for (const { indices, material } of parts) {
    first += Math.floor(indices.length / 3);
    if (triangle < first) return material;
  }
  return undefined;
}
