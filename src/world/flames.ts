import type { Flame } from "./flame/flame.js";
import { length2, length3, type Vec3 } from "./geometry.js";
import { reachOut } from "./player/hand.js";
import type { World } from "./world.js";

/** Distance at which a flame lights a wick, metres. */
const KINDLING = 0.1;
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
  const { standing, candle, hand, room } = world;
  if (standing.length === 0) return;
  reachOut(hand, candle.isHeld && room?.findWayToWick(world, way) ? way : null, seconds);
}
