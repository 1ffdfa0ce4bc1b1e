import { length2, type Vec3 } from "../geometry.js";
import type { MovementBounds } from "../room/movement-bounds.js";
import { accelerate } from "./gait.js";
import type { Intent } from "./intent.js";

/** Radius of the visitor, who is a circle on the floor, metres. */
export const WALKER_RADIUS = 0.25;
/** Turning, and looking up or down, by keys or stick at its limit: rad/s. */
const TURN_SPEED = 1.6;
const TILT_SPEED = 1;
/** Largest pitch: straight up or down there would be no direction to walk in. */
export const MAX_PITCH = 1.5;

/** First-person player: the visitor's eye and how it moves. Right-handed, +Y up, yaw 0 looks along -Z, left positive. */
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

/** Direction of the line of sight, unit. */
export function gazeDirection({ yaw, pitch }: Player): Vec3 {
  const level = Math.cos(pitch);
  return [-Math.sin(yaw) * level, Math.sin(pitch), -Math.cos(yaw) * level];
}

/** Turns the head by so much of the pointer's motion. */
export function turnHead(player: Player, { yaw, pitch }: Pick<Intent, "yaw" | "pitch">): void {
  player.yaw += yaw;
  player.pitch += pitch;
  straighten(player);
}

/** Turning by keys or stick since the last tick: its mean, as `Intent` has it. */
export type Lead = { -readonly [name in keyof Pick<Intent, "turn" | "tilt">]: number };

/**
 * Takes up how a frame turns by keys or stick, before its ticks.
 *
 * @param begun seconds between the last tick and the frame before
 * @param remainder seconds between the last tick and this frame, if it has none of its own
 */
export function followKeys(
  player: Player,
  lead: Lead,
  { turn, tilt }: Intent,
  begun: number,
  remainder: number | null,
): void {
  if (remainder === null) {
    // The first tick turns as if the keys had been held since the last one.
    player.yaw += (lead.turn - turn) * TURN_SPEED * begun;
    player.pitch += (lead.tilt - tilt) * TILT_SPEED * begun;
  }
  const former = remainder ? begun / remainder : 0;
  lead.turn = turn + (lead.turn - turn) * former;
  lead.tilt = tilt + (lead.tilt - tilt) * former;
}

/** Writes the direction of view so many seconds after the last tick. */
export function lookAhead(
  { yaw, pitch }: Player,
  { turn, tilt }: Lead,
  seconds: number,
  view: { yaw: number; pitch: number },
): void {
  view.yaw = yaw + turn * TURN_SPEED * seconds;
  view.pitch = clampPitch(pitch + tilt * TILT_SPEED * seconds);
}

function clampPitch(pitch: number): number {
  return Math.min(Math.max(pitch, -MAX_PITCH), MAX_PITCH);
}

/** Keeps yaw within a turn, and pitch between feet and crown. */
function straighten(player: Player): void {
  const turn = 2 * Math.PI;
  player.yaw -= turn * Math.round(player.yaw / turn);
  player.pitch = clampPitch(player.pitch);
}

/** Walks for so many seconds, as far as there is space; see `accelerate`. */
export function walk(
  player: Player,
  { forward, right, runs, turn, tilt }: Intent,
  gait: Gait,
  ground: MovementBounds,
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
  targetVelocity[0] = (right * cos - forward * sin) * pace;
  targetVelocity[2] = (-right * sin - forward * cos) * pace;
  accelerate(velocity, targetVelocity, seconds, way);
  ground.move(position, way, velocity);
}

const targetVelocity: Vec3 = [0, 0, 0];
const way: Vec3 = [0, 0, 0];
