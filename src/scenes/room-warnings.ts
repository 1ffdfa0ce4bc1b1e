import type { Model } from "../assets/model.js";
import { length3 } from "../world/geometry.js";
import type { CollisionMesh } from "../world/room/collision-mesh.js";
import { freePlace } from "../world/room/enclosed.js";
import type { Room } from "../world/room/room.js";
import { materialOf } from "./room-wicks.js";

/** Size of a model below which its unit is doubted, metres. */
const SMALLEST = 0.05;

/** Warns of a room of which a visitor sees nothing from where they start. */
export function warnOfRoom(
  { bounds, parts }: Model,
  collision: CollisionMesh,
  { start, plan }: Room,
): void {
  const {
    min: [left, bottom, back],
    max: [right, top, front],
  } = bounds;
  const size = Math.max(right - left, top - bottom, front - back);
  if (size < SMALLEST) {
    const millimetres = +(size * 1000).toPrecision(2);
    console.warn(`The model is ${millimetres} mm wide: the unit of a glTF file is a metre.`);
  }
  const isInvisibleFromBehind = (triangle: number) => !materialOf(parts, triangle)?.isDoubleSided;
  if (plan.isInside) {
    // The place itself where it is not inside of anything.
    if (freePlace(collision, start, 0, isInvisibleFromBehind) !== start) {
      console.warn("The room's faces point away from its visitor and are invisible.");
    }
    return;
  }
  const [x, y, z] = [
    (left + right) / 2 - start[0],
    (bottom + top) / 2 - start[1],
    (back + front) / 2 - start[2],
  ];
  const distance = length3(x, y, z);
  const hit = collision.raycast(start, [x / distance, y / distance, z / distance], distance);
  if (hit?.isBack && isInvisibleFromBehind(hit.triangle)) {
    console.warn(
      "Nowhere in the model can one stand, and its faces point away from where its visitor starts, beside it.",
    );
  }
}
