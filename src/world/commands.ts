import { CANDLE_CYLINDER, isWithinReach, placeOnGround } from "./candle.js";
import { candleCount, rootedFlame } from "./flames.js";
import type { Vec3 } from "./geometry.js";
import { interpolate, poseCandle } from "./interpolate.js";
import { calmHand } from "./player/hand.js";
import { gazeDirection, MAX_PITCH } from "./player/player.js";
import { fieldOfViewOf, type World } from "./world.js";

/** Largest coordinate of a camera, metres. */
export const FARTHEST = 1e4;
/** Largest angle from the line of sight, radians, and distance of a flame that a breath aims at. */
const AIM = 0.7;
const BREATH_REACH = 1.6;
/** Of a flame, above its root, and distance of a mouth that blows at one. Metres. */
const HELD_AT = 0.01;
const BESIDE = 0.5;
/** Of such a breath at the flame, metres. */
const BREADTH = 0.035;

/** Moves the camera, clamped to the walls if there are any. Metres and radians. */
export function moveCamera(
  world: World,
  position: ArrayLike<number>,
  yaw: number,
  pitch: number,
  fieldOfView = fieldOfViewOf(world),
): void {
  const { player, setup } = world;
  const before = [...player.position, player.yaw, player.pitch, fieldOfViewOf(world)];
  for (const axis of [0, 1, 2] as const) {
    const value = Number(position[axis]);
    if (!Number.isNaN(value))
      player.position[axis] = Math.min(Math.max(value, -FARTHEST), FARTHEST);
    player.velocity[axis] = 0;
  }
  world.movementBounds.clamp(player.position);
  if (Number.isFinite(yaw)) player.yaw = yaw;
  if (Number.isFinite(pitch)) player.pitch = Math.min(Math.max(pitch, -MAX_PITCH), MAX_PITCH);
  const isOwn = fieldOfView === setup.fieldOfView;
  if (fieldOfView !== before[5]) world.fieldOfView = isOwn ? null : fieldOfView;
  // The camera is where it was put, whatever keys are held; who only moves goes on turning.
  if (player.yaw !== before[3] || player.pitch !== before[4]) world.lead.turn = world.lead.tilt = 0;
  calmHand(world.hand, player);
  poseCandle(world, 0);
  const after = [...player.position, player.yaw, player.pitch, fieldOfViewOf(world)];
  if (after.some((value, i) => value !== before[i])) world.adaptation?.settle(world);
  interpolate(world);
}

/** Puts the candle down. False if it stands already, or if there is no place for it: see `refusal`. */
export function placeCandle(world: World): boolean {
  const { candle, player, setup, room } = world;
  if (!candle.isHeld) return false;
  const spot: Vec3 = [0, 0, 0];
  world.refusal = room?.findSpot(player, spot) ?? null;
  if (world.refusal !== null) return false;
  if (room) putDown(world, spot);
  else placeOnGround(candle, player, setup);
  candle.yaw = player.yaw;
  poseCandle(world, 0);
  interpolate(world);
  return true;
}

/** Puts the candle where another world's stands, if it does; in another room, ahead, if there is a place. */
export function standLike(world: World, { candle, setup, room }: World): void {
  const isFree = setup.stand === null && world.setup.stand === null;
  if (candle.isHeld || !isFree) return;
  if (room && world.room ? room.isSame(world.room) : room === world.room) {
    standCandle(world, candle.position, candle.yaw);
    return;
  }
  placeCandle(world);
  world.adaptation?.settle(world);
}

/** Stands the candle exactly at a position, metres; not in scenes that fix it elsewhere. */
export function standCandle(world: World, position: Readonly<Vec3>, yaw: number): void {
  const { candle, setup } = world;
  if (setup.stand !== null) return;
  candle.yaw = yaw;
  putDown(world, position);
  poseCandle(world, 0);
  world.adaptation?.settle(world);
  interpolate(world);
}

function putDown({ candle, room }: World, position: Readonly<Vec3>): void {
  for (const axis of [0, 1, 2] as const) candle.position[axis] = position[axis];
  candle.isHeld = false;
  room?.plan.setObstacle(position, CANDLE_CYLINDER.radius);
}

/** Takes the candle up. False if it is held, fixed by the scene, or out of reach: see `refusal`. */
export function takeCandle(world: World): boolean {
  const { candle, player, setup, room } = world;
  if (candle.isHeld || setup.stand !== null) return false;
  const isNear = room ? room.canTake(player, candle.position) : isWithinReach(candle, player);
  world.refusal = isNear ? null : "out of reach";
  if (!isNear) return false;
  candle.isHeld = true;
  room?.plan.setObstacle(null);
  calmHand(world.hand, player);
  poseCandle(world, 0);
  world.adaptation?.notice(world);
  interpolate(world);
  return true;
}

/** Breaths at all candles of a model alone, each weaker by those that blow on the same flame. */
function blowAtAll(world: World, strength: number): void {
  const count = candleCount(world);
  for (let index = 0; index < count; index++) {
    const root = rootedFlame(world, index)!.root;
    let breaths = 0;
    for (let other = 0; other < count; other++) {
      const [x, y, z] = rootedFlame(world, other)!.root;
      breaths += Math.exp(-(Math.hypot(x - root[0], y - root[1], z - root[2]) ** 2) / BREADTH ** 2);
    }
    blowAt(world, index, strength / breaths);
  }
}

/**
 * A breath from the eye: at the flame nearest to the line of sight if it is near, else along that line.
 *
 * @param strength 1 puts a candle out at arm's length
 */
export function blow(world: World, strength: number): void {
  if (world.setup.isAlone) {
    blowAtAll(world, strength);
    return;
  }
  const { air, player, emitter, candle, flame, standing, room } = world;
  const { position } = player;
  const gaze = gazeDirection(player);
  const carried = targetOf(position, emitter, gaze);
  const burning = standing.filter((other) => other.flame.isLit);
  const targets = burning.map(({ root }) => targetOf(position, root, gaze));
  if (flame.isLit || burning.length === 0) targets.unshift(carried);
  // The hand may hold the candle against a wall.
  const reachTo = (target: typeof carried) =>
    target === carried && candle.isHeld
      ? BREATH_REACH
      : (room?.reachOfBreath(position, target.direction) ?? Infinity);
  const meant = targets
    .filter(({ distance, ahead }) => distance < BREATH_REACH && ahead > Math.cos(AIM))
    .filter((target) => target.distance < reachTo(target))
    .sort((a, b) => b.ahead - a.ahead)[0];
  const target = meant ?? { ...carried, direction: gaze };
  air.blow(position, target.direction, target.distance, strength, 0, reachTo(target));
}

/** Unit direction to a flame, its distance, and the cosine of its angle from the line of sight. */
function targetOf(eye: Readonly<Vec3>, root: Readonly<Vec3>, gaze: Readonly<Vec3>) {
  // The lowest third of the flame is what holds it on its wick.
  const direction: Vec3 = [root[0] - eye[0], root[1] - eye[1] + HELD_AT, root[2] - eye[2]];
  const distance = Math.hypot(...direction);
  for (const axis of [0, 1, 2] as const) direction[axis] /= Math.max(distance, 1e-6);
  const ahead = direction[0] * gaze[0] + direction[1] * gaze[1] + direction[2] * gaze[2];
  return { direction, distance, ahead };
}

/**
 * A breath at one candle, level, from the side of the eye and from so near that its strength counts. What is between does not
 * stop it, a wall behind the candle does.
 *
 * @param index of the candle: 0 is the carried one
 */
export function blowAt(world: World, index: number, strength: number): void {
  const root = rootedFlame(world, index)?.root;
  if (!root) return;
  const { position } = world.player;
  const away: Vec3 = [position[0] - root[0], 0, position[2] - root[2]];
  const length = Math.hypot(...away);
  const [x, z] = length > 1e-6 ? [away[0] / length, away[2] / length] : [0, 1];
  const target: Vec3 = [root[0], root[1] + HELD_AT, root[2]];
  const mouth: Vec3 = [target[0] + x * BESIDE, target[1], target[2] + z * BESIDE];
  const direction: Vec3 = [-x, 0, -z];
  const beyond = world.room?.reachOfBreath(target, direction) ?? Infinity;
  world.air.blow(mouth, direction, BESIDE, strength, index + 1, BESIDE + beyond);
}
