import { length2, type Vec3 } from "../geometry.js";
import type { Player } from "./player.js";

/** Of a grown visitor, metres above the floor. */
export const EYE_HEIGHT = 1.6;
/** m/s */
export const WALK = 1.4;
export const RUN = 2.8;
/** Rate at which the walker takes up the pace asked for, 1/s: 95 % within a quarter of a second. */
const AGILITY = 12;
/** A pace that differs by less is taken up at once, m/s: what is left of a stop's way is a tenth of a millimetre. */
const STANDSTILL = 0.001;

/** Way of two steps, metres. */
const STRIDE = 1.6;
/** Amplitudes of the head's sway at a walk or a run: barely perceptible. Metres. */
const RISE = 0.006;
const SWING = 0.004;

/**
 * Eases a level velocity towards the wanted one exponentially, and writes the displacement meanwhile to `way`.
 * Both are exact, so a step of any length ends where many short ones would.
 */
export function accelerate(
  velocity: Vec3,
  wanted: Readonly<Vec3>,
  seconds: number,
  way: Vec3,
): void {
  for (let axis = 0; axis < 3; axis += 2) {
    const excess = velocity[axis]! - wanted[axis]!;
    const decay = Math.abs(excess) < STANDSTILL ? 0 : Math.exp(-AGILITY * seconds);
    velocity[axis] = wanted[axis]! + excess * decay;
    way[axis] = wanted[axis]! * seconds + (excess * (1 - decay)) / AGILITY;
  }
}

/** Phase of the stride after a way walked, metres: 0 to 1 over two steps. */
export function advanceStride(stride: number, way: number): number {
  return (stride + way / STRIDE) % 1;
}

/** Head bob: offset of a walking head, metres: up and down with each step, to the side with every other. */
export function headBob(
  { stride, player: { velocity, yaw } }: { stride: number; player: Omit<Player, "pitch"> },
  out: Vec3,
): Vec3 {
  const pace = Math.min(1, length2(velocity[0], velocity[2]) / WALK);
  const phase = 2 * Math.PI * stride;
  const side = SWING * pace * Math.sin(phase);
  out[0] = side * Math.cos(yaw);
  // Lowest when both feet are on the ground, which is when the head is in the middle.
  out[1] = -RISE * pace * Math.cos(2 * phase);
  out[2] = -side * Math.sin(yaw);
  return out;
}
