import { tick } from "./advance.js";
import type { Wind } from "./air/air.js";
import type { Plume } from "./air/plume.js";
import { interpolate, poseCandle } from "./interpolate.js";
import { STILL } from "./player/intent.js";
import type { Steps } from "./steps.js";
import { HISTORY } from "./timeline.js";
import type { World } from "./world.js";

/** Ticks in which the plume rises. */
const RISING = 60;

/**
 * The plume that was warmed up last, and what it depends on. It takes longest, and a page makes its first worlds, and
 * those of a reset, alike.
 */
let risen: { readonly cause: string | null; readonly plume: Plume } | null = null;

/** Lets a new world's flame burn for as long as particles live; then the wind comes up. */
export function* warmUp(world: World, wind: Wind): Steps {
  poseCandle(world, 0);
  for (let i = RISING; i < HISTORY; i++) tick(world, STILL);
  const { setup, seed, emitter, flame, air, timeline, sways } = world;
  const createPlume = setup.isAlone ? null : world.createPlume;
  const causes = [seed, emitter, flame.wick, flame.isLit, air.wind, timeline.tick, sways];
  const cause = createPlume && JSON.stringify(causes);
  const known = risen?.cause === cause ? risen?.plume : null;
  if (!known) world.plume = createPlume?.(seed, emitter, false) ?? null;
  for (let i = 0; i < RISING; i++) {
    if (world.plume) yield;
    tick(world, STILL);
  }
  if (known) world.plume = known.clone();
  else if (world.plume) risen = { cause, plume: world.plume.clone() };
  air.wind = wind;
  world.adaptation?.adaptFully(world);
  interpolate(world);
}
