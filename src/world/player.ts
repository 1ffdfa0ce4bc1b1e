import type { Vec3 } from "./bounds.js";
import { accelerate } from "./gait.js";
import type { Ground } from "./ground.js";
import type { Intent } from "./intent.js";
import { length2 } from "./length.js";

/** The visitor is a circle on the floor of this radius, metres. */
export const WALKER_RADIUS = 0.25;
/** Turning, and looking up or down, by keys or stick at its limit: rad/s. */
const TURN_SPEED = 1.6;
const TILT_SPEED = 1;
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
  player.yaw += yaw;
  player.pitch += pitch;
  straighten(player);
}

/** Keeps yaw within a turn, and pitch between feet and crown. */
function straighten(player: Player): void {
  const turn = 2 * Math.PI;
  player.yaw -= turn * Math.round(player.yaw / turn);
  player.pitch = Math.min(Math.max(player.pitch, -MAX_PITCH), MAX_PITCH);
}

/**
 * Walks for a while.
 *
 * The velocity nears the wanted one exponentially, and both it and the way are integrated exactly,
 * so a step of any length ends where many short ones would.
 */
export function walk(
  player: Player,
  { forward, right, runs, turn, tilt }: Intent,
  gait: Gait,
  ground: Ground,
  seconds: number,
): void {
  const { position, velocity } = player;
  player.yaw += turn * TURN_SPEED * seconds;
  player.pitch += tilt * TILT_SPEED * seconds;
  straighten(player);
  const length = Math.max(1, length2(forward, right));
  const pace = (runs ? gait.run : gait.walk) / length;
  const sin = Math.sin(player.yaw);
  const cos = Math.cos(player.yaw);
  wanted[0] = (right * cos - forward * sin) * pace;
  wanted[2] = (-right * sin - forward * cos) * pace;
  accelerate(velocity, wanted, seconds, way);
  ground.walk(position, way, velocity);
}

const wanted: Vec3 = [0, 0, 0];
const way: Vec3 = [0, 0, 0];
