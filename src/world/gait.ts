import type { Vec3 } from "./bounds.js";
import { length2 } from "./length.js";
import type { Stand } from "./placing.js";
import type { Solid } from "./solid.js";

/** Of a grown visitor, metres above the floor. */
export const EYE_HEIGHT = 1.6;
/** m/s */
export const WALK = 1.4;
export const RUN = 2.8;
/** Rate at which the walker takes up the pace asked for, 1/s: 95 % within a quarter of a second. */
const AGILITY = 12;

const WHOLE_TURN = 2 * Math.PI;

/** Way of two steps, metres. */
const STRIDE = 1.6;
/** The head's sway at a walk or a run, to either side of the middle: barely perceptible. Metres. */
const RISE = 0.006;
const SWING = 0.004;

/** How fast the hand follows a turn of the head, and the body's motion, 1/s. */
const TURN_STIFFNESS = 18;
const SWAY_STIFFNESS = 14;
/** The hand is never left farther behind than this: radians, metres. */
const MAX_LAG = 0.3;
const MAX_SWAY = 0.05;
/** How fast the hand comes to where it should be held, near a wall or away from it, 1/s. */
const STRETCHING = 7;
/** Things this near already make the hand draw back, metres: so that it seldom has to do so at once. */
const CAUTION = 0.06;

/** Who walks: where his eye is, metres, how fast he goes, m/s, and which way he faces, radians. */
export interface Walker {
  readonly position: Readonly<Vec3>;
  readonly velocity: Readonly<Vec3>;
  readonly yaw: number;
}

/**
 * Lets a level velocity near the wanted one exponentially, and writes to `way` how far it goes meanwhile:
 * exact, so a step of any length ends where many short ones would.
 */
export function accelerate(
  velocity: Vec3,
  wanted: Readonly<Vec3>,
  seconds: number,
  way: Vec3,
): void {
  const decay = Math.exp(-AGILITY * seconds);
  for (let axis = 0; axis < 3; axis += 2) {
    const excess = velocity[axis]! - wanted[axis]!;
    velocity[axis] = wanted[axis]! + excess * decay;
    way[axis] = wanted[axis]! * seconds + (excess * (1 - decay)) / AGILITY;
  }
}

/** Moment of the stride after a way walked: 0 to 1 over two steps. */
export function advanceStride(stride: number, way: number): number {
  return (stride + way / STRIDE) % 1;
}

/**
 * Where walking moves the head to, from where it would be gliding: up and down with each step, to the
 * side with every other. Who stands does not sway. Metres.
 */
export function headBob(
  { stride, player: { velocity, yaw } }: { readonly stride: number; readonly player: Walker },
  out: Vec3,
): Vec3 {
  const share = Math.min(1, length2(velocity[0], velocity[2]) / WALK);
  const phase = 2 * Math.PI * stride;
  const side = SWING * share * Math.sin(phase);
  out[0] = side * Math.cos(yaw);
  // Lowest when both feet are on the ground, which is when the head is in the middle.
  out[1] = -RISE * share * Math.cos(2 * phase);
  out[2] = -side * Math.sin(yaw);
  return out;
}

/** The hand that holds the candle: it has inertia, and it is careful. */
export interface Hand {
  /** How far it is behind the turn of the head, radians. */
  lag: number;
  /** How fast it turns itself, rad/s. */
  turning: number;
  /** How far it is from where a stiff arm would hold it, metres, and how fast it goes there, m/s. */
  readonly sway: Vec3;
  readonly swaying: Vec3;
  /** How far the arm is stretched, 0 to 1. */
  stretch: number;
  /** The body when the hand was last advanced. */
  yaw: number;
  readonly velocity: Vec3;
}

/** A hand at rest. */
export function createHand(yaw: number): Hand {
  return {
    lag: 0,
    turning: 0,
    sway: [0, 0, 0],
    swaying: [0, 0, 0],
    stretch: 1,
    yaw,
    velocity: [0, 0, 0],
  };
}

/** Brings a hand to rest at once, as after a jump to elsewhere. */
export function calmHand(hand: Hand, yaw: number): void {
  hand.lag = hand.turning = 0;
  hand.stretch = 1;
  hand.yaw = yaw;
  for (const axis of [0, 1, 2] as const) {
    hand.sway[axis] = hand.swaying[axis] = hand.velocity[axis] = 0;
  }
}

/**
 * Lets the hand follow the body for a while: a critically damped spring behind the turn of the head,
 * and one that the body's acceleration pulls at. Both exact if turn and acceleration were even.
 */
export function advanceHand(hand: Hand, { yaw, velocity }: Walker, seconds: number): void {
  if (!(seconds > 0)) return;
  const turned = yaw - hand.yaw;
  const turn = (turned - WHOLE_TURN * Math.round(turned / WHOLE_TURN)) / seconds;
  hand.yaw = yaw;
  // Damped against the room, so it stays behind for as long as the head turns.
  const behind = (2 * turn) / TURN_STIFFNESS;
  spring.offset = hand.lag - behind;
  spring.speed = turn - hand.turning;
  relax(TURN_STIFFNESS, seconds);
  hand.lag = behind + spring.offset;
  hand.turning = turn - spring.speed;
  for (let axis = 0; axis < 3; axis += 2) {
    const acceleration = (velocity[axis]! - hand.velocity[axis]!) / seconds;
    hand.velocity[axis] = velocity[axis]!;
    const rest = -acceleration / SWAY_STIFFNESS ** 2;
    spring.offset = hand.sway[axis]! - rest;
    spring.speed = hand.swaying[axis]!;
    relax(SWAY_STIFFNESS, seconds);
    hand.sway[axis] = rest + spring.offset;
    hand.swaying[axis] = spring.speed;
  }
}

/**
 * Writes to `foot` where the hand holds the candle's foot, and draws the hand back from what is near.
 *
 * The candle comes from the walker's own axis, around which there is space, and stops where it would
 * touch something: so it never reaches into anything, nor through it.
 *
 * @param hold from the eye: right, up, ahead, metres
 * @param solid what is in the way; null if nothing ever is
 * @param seconds since the last time; 0 to look ahead, which leaves the hand as it is
 */
export function holdOut(
  hand: Hand,
  { position: eye, yaw }: Walker,
  hold: readonly [number, number, number],
  solid: Solid | null,
  stand: Stand,
  seconds: number,
  foot: Vec3,
): void {
  const right = hold[0];
  const ahead = hold[2];
  const angle = yaw - soften(hand.lag, MAX_LAG);
  const sin = Math.sin(angle);
  const cos = Math.cos(angle);
  reach[0] = right * cos - ahead * sin + soften(hand.sway[0], MAX_SWAY);
  reach[2] = -right * sin - ahead * cos + soften(hand.sway[2], MAX_SWAY);
  foot[0] = eye[0];
  foot[1] = eye[1] + hold[1];
  foot[2] = eye[2];
  let stretch = 1;
  if (solid) {
    const wanted = solid.sweepCylinder(foot, reach, stand, CAUTION).share;
    const most = solid.sweepCylinder(foot, reach, stand).share;
    const eased = wanted + (hand.stretch - wanted) * Math.exp(-STRETCHING * seconds);
    stretch = Math.min(eased, most);
  }
  if (seconds > 0) hand.stretch = stretch;
  foot[0] += reach[0] * stretch;
  foot[2] += reach[2] * stretch;
}

const reach: Vec3 = [0, 0, 0];

const spring = { offset: 0, speed: 0 };

/** Lets go of `spring`, which is critically damped, for a while. Exact. */
function relax(stiffness: number, seconds: number): void {
  const { offset, speed } = spring;
  const decay = Math.exp(-stiffness * seconds);
  const slope = speed + stiffness * offset;
  spring.offset = (offset + slope * seconds) * decay;
  spring.speed = (speed - stiffness * slope * seconds) * decay;
}

/** As it is when small, but never more than `most`. */
function soften(value: number, most: number): number {
  return most * Math.tanh(value / most);
}
