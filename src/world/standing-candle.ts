import type { Plume } from "./air/plume.js";
import { Flame, ROOM } from "./flame/flame.js";
import type { Vec3 } from "./geometry.js";
import { seedOf } from "./random.js";
import { TICK } from "./timeline.js";
import type { World } from "./world.js";

/** A wick in a model. Metres. */
export interface Wick {
  readonly name: string;
  /** Root of its flame. */
  readonly position: Readonly<Vec3>;
  readonly wickDiameter: number;
}

/** Candle that stands where its model has it, with a flame of its own. */
export interface StandingCandle {
  readonly name: string;
  /** Root of the flame, metres. */
  readonly root: Vec3;
  readonly flame: Flame;
  /** Hot air and smoke, while there is smoke; a burning candle has none, since each costs as much as a frame may. */
  plume: Plume | null;
}

/** Most candles that smoke at a time: their air is solved. */
const MOST_PLUMES = 4;
/** Difference from the room's temperature at which a wick is cold, kelvin. */
const COLD = 0.5;
const STILL: Vec3 = [0, 0, 0];

/** @param index from 1: the carried candle is 0 */
export function createStandingCandle(
  { name, position, wickDiameter }: Wick,
  index: number,
  seed: number,
  isLit: boolean,
): StandingCandle {
  const flame = new Flame(wickDiameter, isLit, seedOf(seed, index));
  return { name, root: [...position], flame, plume: null };
}

/** Advances all standing candles by one tick. */
export function advanceStanding({ standing, air, sways }: World): void {
  for (let i = 0; i < standing.length; i++) {
    const { flame, root } = standing[i]!;
    const isCold = !flame.isLit && flame.glow === 0 && flame.ember < ROOM + COLD;
    if (!isCold) flame.advance(root, STILL, air, !sways, TICK);
  }
}

/** Advances the smoke of candles that went out by one `PLUME_STEP`; on a page, of the first one as well. */
export function advanceSmoke(world: World): void {
  const { standing, air, sways, seed, createPlume, setup, emitter } = world;
  if (!createPlume) return;
  let plumes = 0;
  const first = setup.isAlone ? 0 : 1;
  for (let i = first; i <= standing.length; i++) {
    const candle = i === 0 ? world : standing[i - 1]!;
    const { flame, plume } = candle;
    const root = i === 0 ? emitter : standing[i - 1]!.root;
    if (!plume) continue;
    plume.step(flame, root, sways ? air : null);
    const smokes = !flame.isLit && flame.measure().smoking > 0;
    if (!smokes && plume.smoke.count === 0) candle.plume = null;
    else plumes++;
  }
  for (let i = first; i <= standing.length && plumes < MOST_PLUMES; i++) {
    const candle = i === 0 ? world : standing[i - 1]!;
    const { flame } = candle;
    if (candle.plume || flame.isLit || flame.measure().smoking === 0) continue;
    candle.plume = createPlume(seedOf(seed, i), i === 0 ? emitter : standing[i - 1]!.root, true);
    plumes++;
  }
}
