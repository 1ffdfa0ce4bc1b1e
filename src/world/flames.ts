import { CANDLE_CYLINDER } from "./candle.js";
import type { Flame } from "./flame/flame.js";
import { length2, length3, type Vec3 } from "./geometry.js";
import { reachOut, stiffFoot } from "./player/hand.js";
import type { World } from "./world.js";

/** Distance at which a flame lights a wick, metres. */
const KINDLING = 0.1;
/** Distance at which the hand reaches out to a wick: along the floor, and up or down. Metres. */
const REACH = 0.4;
const REACH_UP = 0.5;
/**
 * Offset of the carried flame from the wick that it lights: to the side, and up, of which the lowest free one.
 * Metres.
 */
const BESIDE = 0.06;
const ABOVE = [0.035, 0.075, 0.13, 0.2];
/** A candle held out over a wick is tipped to light it: from so far to the side and so high, metres. */
const TIPPED = 0.09;
const TIPPED_UP = 0.24;

/** Candles of a world: the carried one is 0, then come the standing ones. */
export function candleCount({ standing }: World): number {
  return standing.length + 1;
}

/** Flame of a candle, and its root at the moment of the frame, metres; null where there is no such candle. */
export function rootedFlame(
  { standing, flame, interpolated }: World,
  index: number,
): { readonly root: Readonly<Vec3>; readonly flame: Flame } | null {
  return index === 0 ? { root: interpolated.flame, flame } : (standing[index - 1] ?? null);
}

export function litFlames({ standing, flame }: World): boolean[] {
  return [flame.isLit, ...standing.map((candle) => candle.flame.isLit)];
}

/** Lights the wick that the carried flame is held to; else puts the carried flame out, or lights it. */
export function useFlame(world: World): void {
  const { flame } = world;
  const wick = wickAtFlame(world);
  if (wick > 0) world.standing[wick - 1]!.flame.light();
  else if (flame.isLit) flame.extinguish();
  else flame.light();
}

/** The candle with the nearest unlit wick that the carried flame would light; 0 if there is none. */
export function wickAtFlame({ candle, flame, emitter, hand, standing }: World): number {
  if (!candle.isHeld || !flame.isLit) return 0;
  let nearest = KINDLING;
  let wick = 0;
  for (let i = 0; i < standing.length; i++) {
    const { root, flame: other } = standing[i]!;
    if (other.isLit) continue;
    const up = Math.min(Math.max(root[1] - emitter[1], 0), flame.height);
    const distance = length3(root[0] - emitter[0], root[1] - emitter[1] - up, root[2] - emitter[2]);
    const isBelow =
      hand.daring > 0.5 &&
      emitter[1] - root[1] < TIPPED_UP &&
      length2(root[0] - emitter[0], root[2] - emitter[2]) < TIPPED;
    if (distance > nearest && !(isBelow && wick === 0)) continue;
    nearest = Math.min(distance, nearest);
    wick = i + 1;
  }
  return wick;
}

const way: Vec3 = [0, 0, 0];

/** Reaches out with the hand to a wick where either candle can light the other. */
export function reachForWick(world: World, seconds: number): void {
  const { standing, candle, hand } = world;
  if (standing.length === 0) return;
  reachOut(hand, candle.isHeld && findWay(world) ? way : null, seconds);
}

const stiff: Vec3 = [0, 0, 0];

/**
 * Writes the way to the nearest such wick to `way`, from where a stiff arm holds the flame: if it depended on where the
 * hand is, it would tremble between two places. False if there is none.
 */
function findWay(world: World): boolean {
  const { standing, player, setup, candle, emitter, flame } = world;
  stiffFoot(player, setup.hold, stiff);
  let nearest = REACH;
  let isFound = false;
  for (let i = 0; i < standing.length; i++) {
    const { root, flame: other } = standing[i]!;
    const dx = root[0] - (stiff[0] + emitter[0] - candle.position[0]);
    const dy = root[1] - (stiff[1] + emitter[1] - candle.position[1]);
    const dz = root[2] - (stiff[2] + emitter[2] - candle.position[2]);
    const distance = length2(dx, dz);
    if (other.isLit === flame.isLit || Math.abs(dy) > REACH_UP || distance > nearest) continue;
    const share = Math.max(0, 1 - BESIDE / Math.max(distance, 1e-6));
    way[0] = dx * share;
    way[1] = dy;
    way[2] = dz * share;
    nearest = distance;
    isFound = true;
  }
  if (isFound) way[1] += freeHeight(world);
  return isFound;
}

const foot: Vec3 = [0, 0, 0];

/** Height above the wick at which the candle touches nothing, at the end of `way`. */
function freeHeight({ room }: World): number {
  let above = 0;
  for (let i = 0; i < ABOVE.length; i++) {
    above = ABOVE[i]!;
    for (let axis = 0; axis < 3; axis++) foot[axis] = stiff[axis]! + way[axis]!;
    foot[1] += above;
    const { radius, height } = CANDLE_CYLINDER;
    if (!room?.collision.overlapsCylinder(foot, radius, height)) break;
  }
  return above;
}
