import { length3 } from "../geometry.js";
import type { World } from "../world.js";
import { GROUPS } from "./particle-layer.js";

/** Distance from the eye at which the flame has lost a group of particles, metres each. */
const LOD_DISTANCE = 2.5;

/** Particle level of detail: groups worth emitting at the emitter's distance from the eye. */
export function emittingGroups({ emitter, player, setup }: World): number {
  const { position } = player;
  const distance = length3(
    emitter[0] - position[0],
    emitter[1] - position[1],
    emitter[2] - position[2],
  );
  // Distance in sizes of the flame.
  const droppedGroups = Math.floor((distance * 0.125) / (LOD_DISTANCE * setup.flameScale));
  return Math.max(1, GROUPS - droppedGroups);
}
