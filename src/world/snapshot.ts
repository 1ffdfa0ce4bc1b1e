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
export interface Snapshot {
  readonly tick: number;
  /** Seconds after that tick. */
  readonly remainder: number;
  readonly position: Readonly<Vec3>;
  readonly yaw: number;
  readonly pitch: number;
  /** Null: the setup's. */
  readonly fieldOfView: number | null;
  /** Null while the candle is held. */
  readonly stand: Stand | null;
  readonly isLit: boolean;
  /** Whether each of the standing candles burns; null: as at first. */
  readonly areLit: readonly boolean[] | null;
}

export function takeSnapshot(world: World): Snapshot {
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
    areLit: litFlames(world).slice(1),
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
