import { inset, keepInside, type Vec3 } from "./bounds.js";
import type { Player } from "./player.js";
import type { Stage } from "./stage.js";

/** Farthest that the candle is put down, metres ahead of the feet. */
const REACH = 0.9;
/** Room that the candle needs around its axis, metres. */
const CANDLE_MARGIN = 0.12;
/** From this near to a candle that stands, it can be taken up. Metres, along the floor. */
const GRASP = 1.6;

/** The candle: in the hand, or standing in the room. Always upright. */
export interface Candle {
  /** Its foot, metres. */
  readonly position: Vec3;
  isHeld: boolean;
}

/** Where the hand holds the candle's foot. It turns with the head, but does not tilt with it. */
export function holdCandle(candle: Candle, player: Player, stage: Stage): void {
  const [right, up, ahead] = stage.hold;
  putAhead(candle, player, right, ahead, stage);
  candle.position[1] = player.position[1] + up;
}

/** Puts the candle down on the floor, an arm's length ahead. */
export function place(candle: Candle, player: Player, stage: Stage): void {
  putAhead(candle, player, 0, REACH, stage);
  candle.position[1] = stage.room.min[1];
  candle.isHeld = false;
}

export function isWithinGrasp(candle: Candle, player: Player): boolean {
  const dx = candle.position[0] - player.position[0];
  const dz = candle.position[2] - player.position[2];
  return Math.hypot(dx, dz) < GRASP;
}

function putAhead(
  candle: Candle,
  { position: eye, yaw }: Player,
  right: number,
  ahead: number,
  stage: Stage,
): void {
  const sin = Math.sin(yaw);
  const cos = Math.cos(yaw);
  candle.position[0] = eye[0] + right * cos - ahead * sin;
  candle.position[2] = eye[2] - right * sin - ahead * cos;
  if (!stage.isSolid) return;
  const { room } = stage;
  const { min, max } = inset(room, CANDLE_MARGIN);
  // Only the walls: the hand may be as low as the floor.
  keepInside(candle.position, {
    min: [min[0], Number.NEGATIVE_INFINITY, min[2]],
    max: [max[0], Number.POSITIVE_INFINITY, max[2]],
  });
}
