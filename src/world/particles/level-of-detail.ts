import type { World } from "../world.js";
import { GROUPS } from "./particle-layer.js";

/** Distance from the eye at which the flame has lost a group of particles, metres each. */
const LOD_DISTANCE = 2.5;

/** Particle level of detail: groups worth emitting at the emitter's distance from the eye. */
export function emittingGroups({ emitter, player, setup }: World): number {
  const { position } = player;
  const x = emitter[0] - position[0];
  const y = emitter[1] - position[1];
  const z = emitter[2] - position[2];
  const distance = Math.sqrt(x * x + y * y + z * z);
  // Distance in sizes of the flame.
  const droppedGroups = Math.floor((distance * 0.125) / (LOD_DISTANCE * setup.flameScale));
  return Math.max(1, GROUPS - droppedGroups);
}
