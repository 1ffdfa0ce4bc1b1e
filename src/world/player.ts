import { type Bounds, keepInside, type Vec3 } from "./bounds.js";
import type { Intent } from "./intent.js";

/** Rate at which the walker takes up the pace asked for, 1/s: 95 % within a quarter of a second. */
const AGILITY = 12;
/** Turning by keys, rad/s. */
const TURN_SPEED = 1.6;
/** Looking straight up or down would leave no line of sight to walk along. */
export const MAX_PITCH = 1.5;

/** The visitor: an eye that walks. Right-handed, +Y up, yaw 0 looks along -Z, left positive. */
export interface Player {
  /** The eye, metres. */
  readonly position: Vec3;
  /** m/s */
  readonly velocity: Vec3;
  yaw: number;
  pitch: number;
}

export interface Gait {
  /** m/s */
  readonly walk: number;
  readonly run: number;
}

/** Turns the head by what the pointer moved since the last frame. */
export function look(player: Player, { yaw, pitch }: Intent): void {
  player.yaw = wrapAngle(player.yaw + yaw);
  player.pitch = Math.min(Math.max(player.pitch + pitch, -MAX_PITCH), MAX_PITCH);
}

/**
 * Walks for a while.
 *
 * The velocity nears the wanted one exponentially, and both it and the way are integrated exactly,
 * so a step of any length ends where many short ones would.
 */
export function walk(
  player: Player,
  { forward, right, runs, turn }: Intent,
  gait: Gait,
  bounds: Bounds | null,
  seconds: number,
): void {
  player.yaw = wrapAngle(player.yaw + turn * TURN_SPEED * seconds);
  const length = Math.max(1, Math.hypot(forward, right));
  const pace = (runs ? gait.run : gait.walk) / length;
  const sin = Math.sin(player.yaw);
  const cos = Math.cos(player.yaw);
  const wanted = [(right * cos - forward * sin) * pace, 0, (-right * sin - forward * cos) * pace];
  const decay = Math.exp(-AGILITY * seconds);
  for (const axis of [0, 2] as const) {
    const excess = player.velocity[axis] - wanted[axis]!;
    player.position[axis] += wanted[axis]! * seconds + (excess * (1 - decay)) / AGILITY;
    player.velocity[axis] = wanted[axis]! + excess * decay;
  }
  if (bounds) keepInside(player.position, bounds, player.velocity);
}

function wrapAngle(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
