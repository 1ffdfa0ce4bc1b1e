import { tick } from "./advance.js";
import type { Wind } from "./air/air.js";
import type { Plume } from "./air/plume.js";
import { interpolate, poseCandle } from "./interpolate.js";
import { adaptFully } from "./player/adapt.js";
import { STILL } from "./player/intent.js";
import { HISTORY } from "./timeline.js";
import type { World } from "./world.js";

/** Ticks in which the plume rises, and of each step of it, which takes a few milliseconds. */
const RISING = 60;
const STEP = 4;

/**
 * The plume that was warmed up last, and what it depends on. It takes longest, and a page makes its first worlds, and
 * those of a reset, alike.
 */
let risen: { readonly cause: string; readonly plume: Plume } | null = null;

/** Lets a new world's flame burn for as long as particles live; then the wind comes up. */
export function* warmUp(world: World, wind: Wind): Generator<void, void> {
  poseCandle(world, 0);
  for (let i = RISING; i < HISTORY; i++) tick(world, STILL);
  const cause = causeOf(world);
  const plume = createPlume(world);
  const copied = risen?.cause === cause ? risen.plume : null;
  if (!copied) world.plume = plume;
  for (let i = 0; i < RISING; i++) {
    if (world.plume && i % STEP === 0) yield;
    tick(world, STILL);
  }
  if (plume && copied) {
    plume.copy(copied);
    world.plume = plume;
  } else if (plume) {
    const kept = createPlume(world);
    kept?.copy(plume);
    risen = kept && { cause, plume: kept };
  }
  world.air.wind = wind;
  adaptFully(world);
  interpolate(world);
}

function createPlume({ setup, createPlume, seed, emitter }: World): Plume | null {
  return setup.isAlone ? null : (createPlume?.(seed, emitter, false) ?? null);
}

/** All that the plume of a world that was just made depends on. */
function causeOf({ look, seed, emitter, flame, air, timeline }: World): string {
  return JSON.stringify([look, seed, emitter, flame.wick, flame.isLit, air.wind, timeline.tick]);
}
