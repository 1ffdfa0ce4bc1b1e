import { CANDLE_CYLINDER, holdCandle } from "./candle.js";
import type { Vec3 } from "./geometry.js";
import { headBob } from "./player/gait.js";
import { holdOut } from "./player/hand.js";
import { lookAhead } from "./player/player.js";
import type { World } from "./world.js";

const way: Vec3 = [0, 0, 0];
const bob: Vec3 = [0, 0, 0];

/** Extrapolates the frame's positions from the last tick by the time left over, so that motion is smooth. */
export function interpolate(world: World): void {
  const { player, candle, emitter, interpolated, remainder, room } = world;
  const { position, velocity } = player;
  const { eye, foot, flame } = interpolated;
  lookAhead(player, world.lead, remainder, interpolated);
  interpolated.candleYaw = candle.isHeld ? interpolated.yaw : candle.yaw;
  for (let axis = 0; axis < 3; axis++) {
    eye[axis] = position[axis]!;
    way[axis] = velocity[axis]! * remainder;
  }
  world.movementBounds.move(eye, way, way);
  const heldWeight = candle.isHeld ? 1 : 0;
  for (let axis = 0; axis < 3; axis++) {
    const carried = (eye[axis]! - position[axis]!) * heldWeight;
    foot[axis] = candle.position[axis]! + carried;
    flame[axis] = emitter[axis]! + carried;
  }
  if (!room || !world.sways) return;
  headBob(world, bob);
  for (let axis = 0; axis < 3; axis++) eye[axis]! += bob[axis]!;
}

/** Between ticks, a turn of the head shows the candle where it leads; the motion itself is the next tick's. */
export function interpolateTurn(world: World): void {
  const { candle, emitter } = world;
  const [foot, root] = [[...candle.position], [...emitter]];
  poseCandle(world, 0);
  interpolate(world);
  Object.assign(candle.position, foot);
  Object.assign(emitter, root);
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
