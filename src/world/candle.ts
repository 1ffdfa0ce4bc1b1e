import type { Vec3 } from "./geometry.js";
import { stiffFoot } from "./player/hand.js";
import type { Player } from "./player/player.js";
import type { Cylinder } from "./room/placement.js";
import type { WorldSetup } from "./world-setup.js";

/** Farthest that the candle is put down on bare ground, metres ahead of the feet. */
const ARM_AHEAD = [0, 0, 0.9] as const;
/** Room that the candle needs around its axis in a box, metres. */
const CANDLE_MARGIN = 0.12;
/** Farthest along the floor that a candle is taken up from; more than it is put down at, for a step back. Metres. */
export const GRASP = 1.5;
/** Bounds of holder, candle and flame. */
export const CANDLE_CYLINDER: Cylinder = { radius: 0.07, height: 0.28 };

/** The candle: in the hand, or standing in the room. Always upright. */
export interface Candle {
  /** Its foot, metres. */
  readonly position: Vec3;
  /** The way it is turned, radians. */
  yaw: number;
  isHeld: boolean;
}

/** Holds the candle in a stiff hand, which turns with the head but does not tilt with it. */
export function holdCandle(candle: Candle, player: Player, setup: WorldSetup): void {
  putAhead(candle, player, setup.hold, setup);
  candle.yaw = player.yaw;
}

/** Puts the candle down on bare ground, an arm's length ahead. */
export function placeOnGround(candle: Candle, player: Player, setup: WorldSetup): void {
  putAhead(candle, player, ARM_AHEAD, setup);
  candle.position[1] = setup.room.min[1];
  candle.isHeld = false;
}

interface Place {
  readonly position: Readonly<Vec3>;
}

export function isWithinReach(candle: Place, player: Place): boolean {
  const dx = candle.position[0] - player.position[0];
  const dz = candle.position[2] - player.position[2];
  return Math.hypot(dx, dz) <= GRASP;
}

function putAhead(
  candle: Candle,
  player: Player,
  hold: readonly [right: number, up: number, ahead: number],
  setup: WorldSetup,
): void {
  stiffFoot(player, hold, candle.position);
  if (!setup.hasWalls) return;
  // Only the walls: the hand may be as low as the floor.
  const { min, max } = setup.room;
  for (let axis = 0; axis < 3; axis += 2) {
    const low = min[axis]! + CANDLE_MARGIN;
    const high = max[axis]! - CANDLE_MARGIN;
    candle.position[axis] = Math.min(Math.max(candle.position[axis]!, low), high);
  }
}
