import { moveCamera, standCandle } from "./commands.js";
import { litFlames } from "./flames.js";
import type { Vec3 } from "./geometry.js";
import { TICK } from "./timeline.js";
import type { Stand, World } from "./world.js";

/**
 * Snapshot of a world: its time, its camera, and the candle's place and flame.
 *
 * Another world of the same room goes on from it, once this one is gone.
 */
export type Snapshot = Readonly<ReturnType<typeof takeSnapshot>>;

export function takeSnapshot(world: World) {
  const { timeline, remainder, player, candle, flame, fieldOfView } = world;
  const { position, yaw, pitch } = player;
  return {
    tick: timeline.tick,
    /** Seconds after that tick. */
    remainder,
    position: [...position] as Readonly<Vec3>,
    yaw,
    pitch,
    /** Null: the setup's. */
    fieldOfView,
    /** Null while the candle is held. */
    stand: candle.isHeld ? null : ({ position: [...candle.position], yaw: candle.yaw } as Stand),
    isLit: flame.isLit,
    /** Whether each of the standing candles burns; null: as at first. */
    areLit: litFlames(world).slice(1) as readonly boolean[] | null,
  };
}

/** Brings camera and candle to their places. The world is as old as the snapshot, and of the same room. */
export function restoreSnapshot(world: World, snapshot: Snapshot): void {
  const { remainder, position, yaw, pitch, fieldOfView, stand } = snapshot;
  world.remainder = remainder;
  moveCamera(world, position, yaw, pitch, fieldOfView);
  if (stand) standCandle(world, stand.position, stand.yaw);
}

/** Seconds since the beginning. */
export function timeOf({ tick, remainder }: Snapshot): number {
  return tick * TICK + remainder;
}
