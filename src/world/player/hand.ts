import type { Vec3 } from "../geometry.js";
import type { CollisionMesh } from "../room/collision-mesh.js";
import type { Cylinder } from "../room/placement.js";
import type { Player } from "./player.js";

const WHOLE_TURN = 2 * Math.PI;

/** Rates of the springs to the turn of the head and to the motion of the body, 1/s. */
const TURN_STIFFNESS = 18;
const SWAY_STIFFNESS = 14;
/** Largest lag and sway: radians, metres. */
const MAX_LAG = 0.3;
const MAX_SWAY = 0.05;
/** Rate at which the arm extends or draws back, 1/s. */
const STRETCHING = 7;
/** Rate at which the hand reaches out, 1/s. */
const REACHING = 6;
/** Distance from an obstacle at which the hand begins to draw back, metres. */
const CAUTION = 0.06;

/** Hand that holds the candle: it has inertia, and draws back from obstacles. */
export type Hand = ReturnType<typeof createHand>;

export function createHand(yaw: number) {
  return {
    /** Angle behind the turn of the head, radians. */
    lag: 0,
    /** Its own angular velocity, rad/s. */
    turning: 0,
    /** Offset from where a stiff arm would hold it, metres, and its velocity, m/s. */
    sway: [0, 0, 0] as Vec3,
    swaying: [0, 0, 0] as Vec3,
    /** Offset by which it reaches out to another candle's wick, metres, and how far it ignores `CAUTION`, 0 to 1. */
    lean: [0, 0, 0] as Vec3,
    daring: 0,
    /** Extension of the arm, 0 to 1. */
    stretch: 1,
    /** Of the body, when the hand was last advanced. */
    yaw,
    velocity: [0, 0, 0] as Vec3,
  };
}

/** Makes a hand as another is. */
export function copyHand(from: Hand, to: Hand): void {
  to.lag = from.lag;
  to.turning = from.turning;
  to.daring = from.daring;
  to.stretch = from.stretch;
  to.yaw = from.yaw;
  for (let axis = 0; axis < 3; axis++) {
    to.sway[axis] = from.sway[axis]!;
    to.swaying[axis] = from.swaying[axis]!;
    to.lean[axis] = from.lean[axis]!;
    to.velocity[axis] = from.velocity[axis]!;
  }
}

/** Brings a hand to rest beside the body at once, as after a jump. */
export function calmHand(hand: Hand, { yaw, velocity }: Omit<Player, "pitch">): void {
  hand.lag = hand.turning = hand.daring = 0;
  hand.stretch = 1;
  hand.yaw = yaw;
  for (const vector of [hand.sway, hand.swaying, hand.lean]) vector.fill(0);
  for (const axis of [0, 1, 2] as const) hand.velocity[axis] = velocity[axis];
}

/**
 * Lets the hand reach out for a while, or return.
 *
 * @param way from where a stiff arm holds the flame to where it is wanted, metres; null to return
 */
export function reachOut(hand: Hand, way: Readonly<Vec3> | null, seconds: number): void {
  const blend = 1 - Math.exp(-REACHING * seconds);
  for (let axis = 0; axis < 3; axis++) {
    hand.lean[axis]! += ((way ? way[axis]! : 0) - hand.lean[axis]!) * blend;
  }
  hand.daring += ((way ? 1 : 0) - hand.daring) * blend;
}

/** Writes to `foot` where a stiff arm would hold the candle's foot. */
export function stiffFoot(
  { position: eye, yaw }: Omit<Player, "pitch">,
  hold: readonly [right: number, up: number, ahead: number],
  foot: Vec3,
): void {
  const right = hold[0];
  const ahead = hold[2];
  foot[0] = eye[0] + right * Math.cos(yaw) - ahead * Math.sin(yaw);
  foot[1] = eye[1] + hold[1];
  foot[2] = eye[2] - right * Math.sin(yaw) - ahead * Math.cos(yaw);
}

/**
 * Advances the hand: a critically damped spring behind the turn of the head, and one that the body's
 * acceleration pulls at. Both are exact if turn and acceleration were even.
 */
export function advanceHand(
  hand: Hand,
  { yaw, velocity }: Omit<Player, "pitch">,
  seconds: number,
): void {
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
 * Collision of the held candle: writes to `foot` where the hand holds the candle's foot.
 *
 * The candle is swept from the walker's own axis, around which there is space, and stops where it would touch
 * something: so it never reaches into anything, nor through it.
 *
 * @param hold from the eye: right, up, ahead, metres
 * @param seconds since the last time; 0 to look ahead, which leaves the hand as it is
 */
export function holdOut(
  hand: Hand,
  { position: eye, yaw }: Omit<Player, "pitch">,
  hold: readonly [number, number, number],
  collision: CollisionMesh,
  stand: Cylinder,
  seconds: number,
  foot: Vec3,
): void {
  const right = hold[0];
  const ahead = hold[2];
  const angle = yaw - soften(hand.lag, MAX_LAG);
  const sin = Math.sin(angle);
  const cos = Math.cos(angle);
  reach[0] = right * cos - ahead * sin + soften(hand.sway[0], MAX_SWAY) + hand.lean[0];
  reach[2] = -right * sin - ahead * cos + soften(hand.sway[2], MAX_SWAY) + hand.lean[2];
  foot[0] = eye[0];
  foot[1] = eye[1] + hold[1] + hand.lean[1];
  foot[2] = eye[2];
  const isCautious = hand.daring < 0.5;
  // A constant margin, since V8 would box a computed one.
  const caution = isCautious ? collision.sweepCylinder(foot, reach, stand, CAUTION).fraction : 1;
  const limit = collision.sweepCylinder(foot, reach, stand).fraction;
  const target = isCautious ? caution : limit;
  const eased = target + (hand.stretch - target) * Math.exp(-STRETCHING * seconds);
  const stretch = Math.min(eased, limit);
  if (seconds > 0) hand.stretch = stretch;
  foot[0] += reach[0] * stretch;
  foot[2] += reach[2] * stretch;
}

const reach: Vec3 = [0, 0, 0];

const spring = { offset: 0, speed: 0 };

/** Advances `spring`, which is critically damped. Exact. */
function relax(stiffness: number, seconds: number): void {
  const { offset, speed } = spring;
  const decay = Math.exp(-stiffness * seconds);
  const slope = speed + stiffness * offset;
  spring.offset = (offset + slope * seconds) * decay;
  spring.speed = (speed - stiffness * slope * seconds) * decay;
}

/** As it is when small, but never more than `most`. */
function soften(value: number, limit: number): number {
  return limit * Math.tanh(value / limit);
}
