import type { Look } from "../../src/settings.ts";
import { createWorldInSteps, type WorldOptions } from "../../src/world/create-world.ts";
import { createSample } from "../../src/world/particles/particles.ts";
import { finish } from "../../src/world/steps.ts";
import type { World } from "../../src/world/world.ts";

/** A new world, whose flame is fully developed. */
export function createWorld(look: Look, seed: number, options: WorldOptions = {}): World {
  return finish(createWorldInSteps(look, seed, { createSample, ...options }));
}
