import { CANDLE_CYLINDER, type Candle, holdCandle } from "./candle.js";
import type { Vec3 } from "./geometry.js";
import { headBob } from "./player/gait.js";
import { advanceHand, copyHand, createHand, holdOut } from "./player/hand.js";
import { lookAhead, type Player } from "./player/player.js";
import type { World } from "./world.js";

const way: Vec3 = [0, 0, 0];
const bob: Vec3 = [0, 0, 0];
/** Visitor, hand and candle at the moment of the frame. */
const body: Player = { position: [0, 0, 0], velocity: [0, 0, 0], yaw: 0, pitch: 0 };
const shownHand = createHand(0);
const shownCandle: Candle = { position: [0, 0, 0], yaw: 0, isHeld: true };

/** Extrapolates what is drawn from the last tick by the time left over, so that motion is smooth. */
export function interpolate(world: World): void {
  const { player, candle, emitter, interpolated, remainder, room, hand } = world;
  const { position, velocity } = player;
  const { eye, foot, flame } = interpolated;
  lookAhead(player, world.lead, remainder, interpolated);
  interpolated.candleYaw = candle.isHeld ? interpolated.yaw : candle.yaw;
  for (let axis = 0; axis < 3; axis++) {
    eye[axis] = position[axis]!;
    way[axis] = velocity[axis]! * remainder;
  }
  world.movementBounds.move(eye, way, way);
  const isAhead = candle.isHeld && (remainder > 0 || interpolated.yaw !== hand.yaw);
  if (isAhead) holdAhead(world);
  for (let axis = 0; axis < 3; axis++) {
    if (!isAhead) foot[axis] = candle.position[axis]!;
    flame[axis] = emitter[axis]! + (foot[axis]! - candle.position[axis]!);
  }
  if (!room || !world.sways) return;
  headBob(world, bob);
  for (let axis = 0; axis < 3; axis++) eye[axis]! += bob[axis]!;
}

/** Has the candle follow the drawn view as it will: the hand moves on from the last tick, and is left as it is. */
function holdAhead({ player, hand, interpolated, remainder, room, setup }: World): void {
  const { eye, foot } = interpolated;
  for (let axis = 0; axis < 3; axis++) {
    body.position[axis] = eye[axis]!;
    body.velocity[axis] = player.velocity[axis]!;
  }
  body.yaw = interpolated.yaw;
  if (room) {
    copyHand(hand, shownHand);
    advanceHand(shownHand, body, remainder);
    holdOut(shownHand, body, setup.hold, room.collision, CANDLE_CYLINDER, remainder, foot);
    return;
  }
  holdCandle(shownCandle, body, setup);
  for (let axis = 0; axis < 3; axis++) foot[axis] = shownCandle.position[axis]!;
}

/** Moves candle and flame with the hand, after some seconds; 0 leaves the hand unchanged. */
export function poseCandle(world: World, seconds: number): void {
  const { candle, player, hand, setup, room, emitter } = world;
  if (candle.isHeld && room) {
    holdOut(hand, player, setup.hold, room.collision, CANDLE_CYLINDER, seconds, candle.position);
    candle.yaw = player.yaw;
  } else if (candle.isHeld) {
    holdCandle(candle, player, setup);
  }
  for (let axis = 0; axis < 3; axis++) {
    emitter[axis] = candle.position[axis]! + setup.wick[axis]! * setup.candleScale;
  }
}
