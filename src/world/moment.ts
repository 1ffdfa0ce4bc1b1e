import type { Vec3 } from "./bounds.js";
import { TICK } from "./timeline.js";
import { moveCamera, putBack, type World } from "./world.js";

/**
 * When it is in a world, where its visitor and its candle are, and whether that burns: what another world of
 * the same room can go on from, once this one is gone.
 */
export interface Moment {
  readonly tick: number;
  /** Seconds after that tick. */
  readonly remainder: number;
  readonly position: Readonly<Vec3>;
  readonly yaw: number;
  readonly pitch: number;
  /** Null is the stage's. */
  readonly fieldOfView: number | null;
  /** Where the candle stands, and how it is turned; null while it is held. */
  readonly stand: { readonly position: Readonly<Vec3>; readonly yaw: number } | null;
  readonly isLit: boolean;
}

export function momentOf(world: World): Moment {
  const { timeline, remainder, player, candle, flame, fieldOfView } = world;
  const { position, yaw, pitch } = player;
  return {
    tick: timeline.tick,
    remainder,
    position: [...position],
    yaw,
    pitch,
    fieldOfView,
    stand: candle.isHeld ? null : { position: [...candle.position], yaw: candle.yaw },
    isLit: flame.isLit,
  };
}

/** Brings visitor and candle to where they were. The world is as old as the moment, and of the same room. */
export function resume(world: World, moment: Moment): void {
  const { remainder, position, yaw, pitch, fieldOfView, stand } = moment;
  world.remainder = remainder;
  moveCamera(world, position, yaw, pitch, fieldOfView);
  if (stand) putBack(world, stand.position, stand.yaw);
}

export function timeOf({ tick, remainder }: Moment): number {
  return tick * TICK + remainder;
}
