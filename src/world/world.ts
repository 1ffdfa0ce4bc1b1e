import type { Look } from "../settings.js";
import { Air, CALM, type Wind } from "./air.js";
import { inset, type Vec3 } from "./bounds.js";
import {
  type Candle,
  holdCandle,
  isWithinGrasp,
  placeInRoom,
  placeOnGround,
  STAND,
} from "./candle.js";
import { fieldOfViewOf } from "./field-of-view.js";
import { TAPER_WICK } from "./flame/burning.js";
import { Flame } from "./flame/flame.js";
import {
  advanceHand,
  advanceStride,
  calmHand,
  createHand,
  type Hand,
  headBob,
  holdOut,
} from "./gait.js";
import { type Ground, OPEN, walled } from "./ground.js";
import { type Intent, STILL } from "./intent.js";
import { length2 } from "./length.js";
import { GROUPS } from "./particle-layer.js";
import { FLOATS, layerKey, Particles } from "./particles.js";
import { canTake, type Refusal } from "./placing.js";
import { look as lookAround, MAX_PITCH, type Player, walk } from "./player.js";
import { Fumes } from "./plume/fumes.js";
import { Pupil, type Sight } from "./pupil.js";
import type { Room } from "./room.js";
import { Spits } from "./spits.js";
import { STAGES, type Stage, WALL_MARGIN } from "./stage.js";
import { MEMORY, TICK, Timeline } from "./timeline.js";

/** Ticks that hot air is given to rise before the world is first seen; and ticks of each of its steps. */
const WARMING = 60;
const FUMES_EVERY = 2;
/** Ticks from glance to glance of the adapting eye; middle of a flame from its foot, metres. */
const GLANCE_EVERY = 2;
const MIDDLE = 0.025;

/** Strongest wind that one can light a candle in, m/s. */
const LIGHTABLE = 1;
/** A flame that burns less than this share of its fuel heats its wick too little to spit. */
const SPITTING = 0.5;
const STANDING: Vec3 = [0, 0, 0];
/** Nobody stands farther from the middle of a world, metres. */
const FARTHEST = 1e4;
/** Distance from the eye at which the flame has lost a group of particles, metres each. */
const LOD_DISTANCE = 2.5;

/** Everything there is, without a picture of it. It knows no screen, no GPU and no clock. */
export interface World {
  readonly look: Look;
  readonly stage: Stage;
  readonly seed: number;
  /** The room as it can be touched; null in the paper's box, which the stage describes. */
  readonly room: Room | null;
  readonly ground: Ground;
  readonly player: Player;
  readonly hand: Hand;
  readonly candle: Candle;
  readonly air: Air;
  readonly flame: Flame;
  /** When its wick spits, if it burns well. */
  readonly spits: Spits;
  /** Hot air and smoke; null in the paper's looks, whose flame heats nothing. */
  fumes: Fumes | null;
  /** How the visitor's eye follows changes of the light; at rest in the paper's looks. */
  readonly pupil: Pupil;
  /** What it adapts to; null where there is no room to be seen in real light. */
  readonly sight: Sight | null;
  /** Foot of the flame, metres. */
  readonly emitter: Vec3;
  /** Where things are at the moment of the picture, up to a tick after the state above. Metres. */
  readonly shown: { readonly eye: Vec3; readonly foot: Vec3; readonly flame: Vec3 };
  readonly timeline: Timeline;
  /** Every fourth particle of the paper's brightest layer: where its flame is, for the light. */
  readonly sample: Particles;
  /** Time asked for and not yet simulated, seconds, less than a tick. */
  remainder: number;
  /** Moment of the stride, 0 to 1. */
  stride: number;
  /** Across the picture's shorter side, radians, as the page wants it; null is the stage's. */
  fieldOfView: number | null;
  /** Whether walking sways the head. */
  sways: boolean;
  /** Why the candle could not be put down when it was last tried; null if it could. */
  refusal: Refusal | null;
}

/** What a world is born with, beside its look and its seed. */
export interface Birth {
  /** Ticks that count as simulated, for a world that takes over from another. */
  readonly age?: number;
  readonly room?: Room | null;
  /** How candle and flame stand, if not as the look has it. */
  readonly stage?: Stage | null;
  readonly wind?: Wind;
  /** Diameter of the wick, metres. */
  readonly wick?: number;
  readonly isLit?: boolean;
  readonly fieldOfView?: number | null;
}

/** A world whose flame has burnt for a while, so that it is whole at once. */
export function createWorld(look: Look, seed: number, birth: Birth = {}): World {
  const { age = 0, room = null, stage: own, wind = CALM, wick = TAPER_WICK, isLit = true } = birth;
  const stage = own ?? STAGES[look];
  const brightest = stage.layers.length - 1;
  const layer = stage.layers[brightest];
  if (!layer) throw new Error(`The look “${look}” has no particle layers.`);
  const start: Vec3 = room ? [...room.start] : [...stage.spawn];
  const yaw = room ? room.yaw : stage.yaw;
  const isHeld = stage.stand === null;
  const world: World = {
    look,
    stage,
    seed,
    room,
    ground: room?.ground ?? (stage.isSolid ? walled(inset(stage.room, WALL_MARGIN)) : OPEN),
    player: { position: start, velocity: [0, 0, 0], yaw, pitch: stage.pitch },
    hand: createHand(yaw),
    candle: { position: [...(stage.stand ?? start)], yaw, isHeld },
    spits: new Spits(seed),
    air: new Air(seed, { ...wind, speed: Math.min(wind.speed, LIGHTABLE) }),
    flame: new Flame(wick, isLit),
    fumes: null,
    pupil: new Pupil(),
    sight:
      room && look === "physical"
        ? {
            solid: room.solid,
            eye: start,
            yaw,
            pitch: stage.pitch,
            fieldOfView: stage.fieldOfView,
            flame: [0, 0, 0],
            luminousIntensity: 0,
          }
        : null,
    emitter: [0, 0, 0],
    shown: { eye: [0, 0, 0], foot: [0, 0, 0], flame: [0, 0, 0] },
    timeline: new Timeline(age - MEMORY),
    sample: new Particles(layer, layerKey(seed, brightest), layer.capacity / GROUPS),
    remainder: 0,
    stride: 0,
    fieldOfView: birth.fieldOfView ?? null,
    sways: true,
    refusal: null,
  };
  room?.plan.setStanding(null);
  settle(world, 0);
  for (let i = 0; i < MEMORY; i++) {
    if (look === "physical" && i === MEMORY - WARMING) {
      world.fumes = new Fumes(seed, world.emitter);
    }
    tick(world, STILL);
  }
  // A gale comes up only then: the flame was lit in calm.
  world.air.wind = wind;
  adapt(world);
  show(world);
  return world;
}

/** Seconds simulated since the beginning. */
export function currentTime({ timeline, remainder }: World): number {
  return timeline.tick * TICK + remainder;
}

/** Lets time pass, in whole ticks; what is left over is carried to the next call. */
export function advance(world: World, intent: Intent, seconds: number): void {
  lookAround(world.player, intent);
  if (intent.placesOrTakes) placeOrTake(world);
  if (intent.togglesFlame) toggleFlame(world.flame);
  if (intent.blows) blow(world, 1);
  // 144 x 1/144 must be one second: the error of a sum is far below a millionth of a tick.
  const ticks = Math.floor((world.remainder + seconds) / TICK + 1e-6);
  world.remainder = Math.max(0, world.remainder + seconds - ticks * TICK);
  if (world.remainder < TICK * 1e-6) world.remainder = 0;
  if (ticks === 0) settle(world, 0);
  for (let i = 0; i < ticks; i++) tick(world, intent);
  show(world);
}

/** Puts the camera somewhere: inside the walls if there are any. Metres and radians. */
export function moveCamera(
  world: World,
  position: ArrayLike<number>,
  yaw: number,
  pitch: number,
  fieldOfView: number | null = world.fieldOfView,
): void {
  const { player, stage } = world;
  const before = [...player.position, player.yaw, player.pitch, fieldOfViewOf(world)];
  for (const axis of [0, 1, 2] as const) {
    const value = Number(position[axis]);
    if (!Number.isNaN(value))
      player.position[axis] = Math.min(Math.max(value, -FARTHEST), FARTHEST);
    player.velocity[axis] = 0;
  }
  world.ground.settle(player.position);
  if (Number.isFinite(yaw)) player.yaw = yaw;
  if (Number.isFinite(pitch)) player.pitch = Math.min(Math.max(pitch, -MAX_PITCH), MAX_PITCH);
  world.fieldOfView = fieldOfView === stage.fieldOfView ? null : fieldOfView;
  calmHand(world.hand, player.yaw);
  settle(world, 0);
  const after = [...player.position, player.yaw, player.pitch, fieldOfViewOf(world)];
  if (after.some((value, i) => value !== before[i])) adapt(world);
  show(world);
}

/** Puts the candle down. False if it stands already, or if there is no place for it: see `refusal`. */
export function placeCandle(world: World): boolean {
  const { candle, player, stage, room } = world;
  if (!candle.isHeld) return false;
  world.refusal = room ? placeInRoom(candle, player, room) : null;
  if (world.refusal !== null) return false;
  if (!room) placeOnGround(candle, player, stage);
  settle(world, 0);
  show(world);
  return true;
}

/** Puts the candle where another world's stands, if it does; in another room, ahead, if there is a place. */
export function standLike(world: World, { candle, stage, room }: World): void {
  const isFree = stage.stand === null && world.stage.stand === null;
  if (candle.isHeld || !isFree) return;
  if (room || world.room) {
    placeCandle(world);
    adapt(world);
    return;
  }
  standCandle(world, candle.position, candle.yaw);
}

/** Stands the candle exactly where it stood before; not where it belongs elsewhere. */
export function standCandle(world: World, position: Readonly<Vec3>, yaw: number): void {
  const { candle, stage, room } = world;
  if (stage.stand !== null) return;
  for (const axis of [0, 1, 2] as const) candle.position[axis] = position[axis];
  candle.yaw = yaw;
  candle.isHeld = false;
  room?.plan.setStanding(position, STAND.radius);
  settle(world, 0);
  adapt(world);
  show(world);
}

/** Takes the candle up. False if it is held, or out of reach, or belongs where it stands. */
export function takeCandle(world: World): boolean {
  const { candle, player, stage, room } = world;
  const isNear = room ? canTake(player.position, candle.position) : isWithinGrasp(candle, player);
  if (candle.isHeld || stage.stand !== null || !isNear) return false;
  candle.isHeld = true;
  room?.plan.setStanding(null);
  calmHand(world.hand, player.yaw);
  settle(world, 0);
  notice(world);
  show(world);
  return true;
}

function placeOrTake(world: World): void {
  if (world.candle.isHeld) placeCandle(world);
  else takeCandle(world);
}

function toggleFlame(flame: Flame): void {
  if (flame.isLit) flame.extinguish();
  else flame.light();
}

/** Within this angle of the line of sight, radians, and this far a breath is meant for the flame. */
const AIM = 0.7;
const BREATH_REACH = 1.6;

/** A breath from the eye: at the flame if it is ahead and near, else along the line of sight. */
export function blow({ air, player, emitter }: World, strength: number): void {
  const { position, yaw, pitch } = player;
  const level = Math.cos(pitch);
  const sight: Vec3 = [-Math.sin(yaw) * level, Math.sin(pitch), -Math.cos(yaw) * level];
  const toFlame: Vec3 = [0, 0, 0];
  for (const axis of [0, 1, 2] as const) toFlame[axis] = emitter[axis] - position[axis];
  // The lowest third of the flame is what holds it on its wick.
  toFlame[1] += 0.01;
  const distance = Math.hypot(...toFlame);
  for (const axis of [0, 1, 2] as const) toFlame[axis] /= Math.max(distance, 1e-6);
  const ahead = toFlame[0] * sight[0] + toFlame[1] * sight[1] + toFlame[2] * sight[2];
  const isMeant = distance < BREATH_REACH && ahead > Math.cos(AIM);
  air.blow(position, isMeant ? toFlame : sight, distance, strength);
}

/** Middle of the flame's glowing particles, from the emitter, in the emitter's unit. */
export function flameCentre({ sample }: World, out: Vec3): Vec3 {
  let weight = 0;
  out[0] = out[1] = out[2] = 0;
  for (let i = 0; i < sample.state.length; i += FLOATS) {
    const alpha = Math.max(0, (sample.state[i + 3] ?? 0) / sample.layer.life);
    weight += alpha;
    for (const axis of [0, 1, 2] as const) out[axis] += alpha * (sample.state[i + axis] ?? 0);
  }
  for (const axis of [0, 1, 2] as const) out[axis] /= Math.max(weight, 1e-6);
  return out;
}

/** Groups of particles worth having at the emitter's distance from the eye. */
export function levelOfDetail({ emitter, player, stage }: World): number {
  const { position } = player;
  const x = emitter[0] - position[0];
  const y = emitter[1] - position[1];
  const z = emitter[2] - position[2];
  const distance = Math.sqrt(x * x + y * y + z * z);
  // A flame twice as large is as large from twice as far.
  const lost = Math.floor((distance * 0.125) / (LOD_DISTANCE * stage.flameScale));
  return Math.max(1, GROUPS - lost);
}

/** Of the tick under way, so that none allocates: the emitter before it, and what `tick` makes of it. */
const before: Vec3 = [0, 0, 0];
const motion: Vec3 = [0, 0, 0];
const flow: Vec3 = [0, 0, 0];
const way: Vec3 = [0, 0, 0];
const wind: Vec3 = [0, 0, 0];

function tick(world: World, intent: Intent): void {
  const { player, emitter, timeline, air, flame } = world;
  for (let axis = 0; axis < 3; axis++) before[axis] = emitter[axis]!;
  stride(world, intent);
  settle(world, TICK);
  for (let axis = 0; axis < 3; axis++) motion[axis] = (emitter[axis]! - before[axis]!) / TICK;
  const carrying = world.candle.isHeld ? motion : STANDING;
  air.advance(timeline.tick + 1, player.position, player.velocity, emitter, carrying);
  // The paper's flame has its own law of motion: it is only lit and put out as the physical one is.
  const isPhysical = world.look === "physical";
  flame.advance(emitter, isPhysical ? motion : STANDING, air, !(world.sways && isPhysical), TICK);
  if (timeline.tick % GLANCE_EVERY === 0) {
    const seen = sightOf(world);
    if (seen) world.pupil.advance(seen, GLANCE_EVERY * TICK);
  }
  if (timeline.tick % FUMES_EVERY === 0) {
    world.fumes?.step(flame, emitter, world.sways ? air : null);
  }
  record(world, isPhysical);
  if (!isPhysical) world.sample.follow(timeline);
}

/** Lets the visitor go on, and his hand follow. */
function stride(world: World, intent: Intent): void {
  const { player, stage, ground, hand } = world;
  const { position } = player;
  const x = position[0];
  const z = position[2];
  walk(player, intent, stage.gait, ground, TICK);
  world.stride = advanceStride(world.stride, length2(position[0] - x, position[2] - z));
  advanceHand(hand, player, TICK);
}

/** Tells the particles what has become of the emitter. */
function record(world: World, isPhysical: boolean): void {
  const { stage, emitter, timeline, air, flame } = world;
  // The paper's particles are in air at rest.
  if (isPhysical && world.sways) air.velocity(emitter, flow);
  else flow.fill(0);
  for (let axis = 0; axis < 3; axis++) {
    way[axis] = (emitter[axis]! - before[axis]!) / stage.flameScale;
    wind[axis] = flow[axis]! / stage.flameScale - way[axis]! / TICK;
  }
  const burnsWell = world.sways && flame.isLit && flame.fuel > SPITTING;
  const spits = burnsWell && world.spits.isAt(timeline.tick);
  timeline.record(way, wind, flame.isLit ? levelOfDetail(world) : 0, spits);
}

/** What the visitor's eye adapts to, as it is now. */
function sightOf(world: World): Sight | null {
  const { sight, player, flame, emitter } = world;
  if (!sight) return null;
  sight.fieldOfView = fieldOfViewOf(world);
  sight.yaw = player.yaw;
  sight.pitch = player.pitch;
  for (let axis = 0; axis < 3; axis++) sight.flame[axis] = emitter[axis]!;
  sight.flame[1] += MIDDLE;
  sight.luminousIntensity = flame.glow;
  return sight;
}

function adapt(world: World): void {
  const sight = sightOf(world);
  if (sight) world.pupil.settle(sight);
}

function notice(world: World): void {
  const sight = sightOf(world);
  if (sight) world.pupil.notice(sight);
}

/** Brings candle and flame to where the visitor is. */
function settle({ candle, player, hand, stage, room, emitter }: World, seconds: number): void {
  if (candle.isHeld && room) {
    holdOut(hand, player, stage.hold, room.solid, STAND, seconds, candle.position);
    candle.yaw = player.yaw;
  } else if (candle.isHeld) {
    holdCandle(candle, player, stage);
  }
  for (let axis = 0; axis < 3; axis++) {
    emitter[axis] = candle.position[axis]! + stage.wick[axis]! * stage.candleScale;
  }
}

const bob: Vec3 = [0, 0, 0];

/** Lets the picture run ahead of the last tick by the time left over, so that motion is smooth. */
function show(world: World): void {
  const { player, candle, emitter, shown, remainder, room } = world;
  const { position, velocity } = player;
  for (let axis = 0; axis < 3; axis++) {
    shown.eye[axis] = position[axis]! + velocity[axis]! * remainder;
  }
  world.ground.settle(shown.eye);
  const share = candle.isHeld ? 1 : 0;
  for (let axis = 0; axis < 3; axis++) {
    const carried = (shown.eye[axis]! - position[axis]!) * share;
    shown.foot[axis] = candle.position[axis]! + carried;
    shown.flame[axis] = emitter[axis]! + carried;
  }
  if (!room || !world.sways) return;
  headBob(world, bob);
  for (let axis = 0; axis < 3; axis++) shown.eye[axis]! += bob[axis]!;
}
