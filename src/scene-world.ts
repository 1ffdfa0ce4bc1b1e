import type { Scene } from "./scenes/scene.js";
import type { Look, Quality } from "./settings.js";
import type { Wind } from "./world/air/air.js";
import { createWorldInSteps, type WorldOptions } from "./world/create-world.js";
import { TAPER_WICK } from "./world/flame/burning.js";
import { type Moon, type MoonWish, moonOf } from "./world/moon.js";
import { finish, type Steps } from "./world/steps.js";
import type { World } from "./world/world.js";
import { LONE_CANDLE_SETUP } from "./world/world-setup.js";

/** Name of the carried candle's wick, in its model. */
const CARRIED = "wick";

/** Everything about a candle that its owner may set at any time. */
export interface Options {
  readonly look: Look;
  readonly seed: number;
  readonly quality: Quality;
  /** EV */
  readonly exposure: number;
  /** Particles alive; 0 is the look's own count. */
  readonly particles: number;
  readonly wind: Wind;
  /** Diameter of the first candle's wick, metres; null: the model's own. */
  readonly wick: number | null;
  readonly unlit: boolean;
  readonly moon: MoonWish;
  /** Candles that burn at first, unless `unlit`; null: the carried one in a room, all of a model alone. */
  readonly litWicks: readonly number[] | null;
  /** No flicker and no sway: `prefers-reduced-motion`. */
  readonly isStill: boolean;
}

export function burnsAtFirst(index: number, { isModelAlone }: Scene, options: Options): boolean {
  const { unlit, litWicks } = options;
  return !unlit && (litWicks?.includes(index) ?? (isModelAlone || index === 0));
}

/** The moon over a scene; null where none shines. */
export function moonOver({ moonDirection }: Scene, { look, moon }: Options): Moon | null {
  return look === "physical" ? moonOf(moon, moonDirection) : null;
}

/** A new world of a scene. */
export function worldOf(scene: Scene, options: Options, birth: WorldOptions = {}): World {
  return finish(worldInSteps(scene, options, birth));
}

/** The same in steps of a few milliseconds. */
export function* worldInSteps(
  scene: Scene,
  options: Options,
  birth: WorldOptions = {},
): Steps<World> {
  const { room, wicks, createPlume, createSample, isModelAlone, first } = scene;
  const { seed, isStill, wind } = options;
  // A model alone burns the same in any look.
  const look = isModelAlone ? "physical" : options.look;
  const alone = first ? { ...LONE_CANDLE_SETUP, wick: first.position } : LONE_CANDLE_SETUP;
  return yield* createWorldInSteps(look, seed, {
    createPlume,
    createSample,
    room,
    setup: isModelAlone ? alone : null,
    wind,
    wick: wickOf(scene, options),
    wicks,
    moon: moonOver(scene, options),
    isLit: burnsAtFirst(0, scene, options),
    areLit: wicks.map((_, i) => burnsAtFirst(i + 1, scene, options)),
    sways: !isStill,
    ...birth,
  });
}

/** Diameter of the first candle's wick, metres. */
export function wickOf({ first }: Scene, { wick }: Options): number {
  return wick ?? first?.wickDiameter ?? TAPER_WICK;
}

export function candleNamesOf({ first, wicks }: Scene): readonly string[] {
  return [first?.name ?? CARRIED, ...wicks.map(({ name }) => name)];
}
