import { blow, placeCandle, takeCandle } from "./commands.js";
import { reachForWick, useFlame } from "./flames.js";
import { length2, type Vec3 } from "./geometry.js";
import { interpolate, poseCandle } from "./interpolate.js";
import { emittingGroups } from "./particles/level-of-detail.js";
import { hasSparks } from "./particles/sparks.js";
import { advanceStride } from "./player/gait.js";
import { advanceHand } from "./player/hand.js";
import { type Intent, STILL } from "./player/intent.js";
import { followKeys, turnHead, walk } from "./player/player.js";
import { advanceSmoke, advanceStanding } from "./standing-candle.js";
import { TICK } from "./timeline.js";
import type { World } from "./world.js";

const PLUME_TICKS = 2;
const ADAPTATION_TICKS = 2;
/** A flame that burns less than this share of its fuel heats its wick too little to throw sparks. */
const SPARKING = 0.5;
const STANDING: Vec3 = [0, 0, 0];

/** Advances the world in whole ticks. The remainder is carried to the next call. */
export function advance(world: World, intent: Intent, seconds: number): void {
  if (intent.togglesFlame) useFlame(world);
  if (intent.blows) blow(world, 1);
  // 144 x 1/144 must be one second: the error of a sum is far below a millionth of a tick.
  const begun = world.remainder;
  const due = begun + seconds;
  const ticks = Math.floor(due / TICK + 1e-6);
  world.remainder = Math.max(0, due - ticks * TICK);
  if (ticks > 0 && world.remainder < TICK * 1e-6) world.remainder = 0;
  const { player, lead, setup } = world;
  if (!setup.isAlone) followKeys(player, lead, intent, begun, ticks > 0 ? null : world.remainder);
  // Each tick has the pointer's motion of its own time, or the flame would feel a whole frame's at once.
  let left = 1;
  for (let i = 1; i <= ticks; i++) {
    const before = left;
    const rest = i < ticks ? due - i * TICK : world.remainder;
    left = rest > 0 ? Math.min(rest / seconds, 1) : 0;
    turn.yaw = intent.yaw * (before - left);
    turn.pitch = intent.pitch * (before - left);
    if (!setup.isAlone) turnHead(player, turn);
    tick(world, intent);
  }
  // What is left the view shows at once; the hand follows it in the next tick.
  turn.yaw = intent.yaw * left;
  turn.pitch = intent.pitch * left;
  if (!setup.isAlone) turnHead(player, turn);
  // Last: from where one stands when it is reported.
  if (intent.placesOrTakes && world.candle.isHeld) placeCandle(world);
  else if (intent.placesOrTakes) takeCandle(world);
  interpolate(world);
}

/** Values of the current tick, allocated once: the pointer's motion, the emitter before it, and what `tick` computes. */
const turn = { yaw: 0, pitch: 0 };
const previousEmitter: Vec3 = [0, 0, 0];
const motion: Vec3 = [0, 0, 0];
const flow: Vec3 = [0, 0, 0];
const way: Vec3 = [0, 0, 0];
const wind: Vec3 = [0, 0, 0];

export function tick(world: World, intent: Intent): void {
  const { player, emitter, timeline, air, flame } = world;
  for (let axis = 0; axis < 3; axis++) previousEmitter[axis] = emitter[axis]!;
  movePlayer(world, intent);
  poseCandle(world, TICK);
  for (let axis = 0; axis < 3; axis++)
    motion[axis] = (emitter[axis]! - previousEmitter[axis]!) / TICK;
  const carrying = world.candle.isHeld ? motion : STANDING;
  air.advance(timeline.tick + 1, player.position, player.velocity, emitter, carrying);
  // The paper's flame has its own law of motion; only lighting it and putting it out are the physical flame's.
  const isPhysical = world.look === "physical";
  flame.advance(emitter, isPhysical ? motion : STANDING, air, !(world.sways && isPhysical), TICK);
  advanceStanding(world);
  if (timeline.tick % ADAPTATION_TICKS === 0) {
    world.adaptation?.advance(world, ADAPTATION_TICKS * TICK);
  }
  if (timeline.tick % PLUME_TICKS === 0) {
    if (!world.setup.isAlone) world.plume?.step(flame, emitter, world.sways ? air : null);
    advanceSmoke(world);
  }
  record(world, isPhysical);
  world.sample?.follow(timeline);
}

function movePlayer(world: World, intent: Intent): void {
  const { player, setup, movementBounds, hand } = world;
  const { position } = player;
  const x = position[0];
  const z = position[2];
  // The view of candles alone is fixed.
  walk(player, setup.isAlone ? STILL : intent, setup.gait, movementBounds, TICK);
  world.stride = advanceStride(world.stride, length2(position[0] - x, position[2] - z));
  advanceHand(hand, player, TICK);
  reachForWick(world, TICK);
}

/** Records the emitter's tick, from which the particles are simulated. */
function record(world: World, isPhysical: boolean): void {
  const { setup, emitter, timeline, air, flame } = world;
  // The paper's particles are in air at rest.
  if (isPhysical && world.sways) air.velocity(emitter, flow);
  else flow.fill(0);
  for (let axis = 0; axis < 3; axis++) {
    way[axis] = (emitter[axis]! - previousEmitter[axis]!) / setup.flameScale;
    wind[axis] = flow[axis]! / setup.flameScale - way[axis]! / TICK;
  }
  const burnsWell = world.sways && flame.isLit && flame.fuel > SPARKING;
  const throwsSparks = burnsWell && hasSparks(world.seed, timeline.tick);
  timeline.record(way, wind, flame.isLit ? emittingGroups(world) : 0, throwsSparks);
}
