import { vec3 } from "gl-matrix";
import type { Gpu } from "../gl/gpu.js";
import { flameLight, TAPER } from "../light/flame-light.js";
import type { StandingCandle } from "../world/standing-candle.js";
import type { Steps } from "../world/steps.js";
import type { World } from "../world/world.js";
import type { CachedLight } from "./cached-light.js";
import type { IndirectScene } from "./gi/indirect-pass.js";
import { type IndirectTargets, indirectTargets } from "./gi/indirect-targets.js";
import { supportTarget } from "./gi/surfel-pass.js";
import { MoonCaptures } from "./moon/moon-captures.js";
import type { PhysicalTier } from "./quality.js";
import type { ShadowCasters } from "./shadow/shadow-casters.js";
import { shadowAtlas } from "./shadow/shadow-pass.js";
import { StandingCandleCaptures, type StandingSlot } from "./standing-candle-captures.js";

/** The lights beside the carried flame, each captured when it first shines. */
export class CachedLights {
  readonly #makeMoon: () => MoonCaptures;
  readonly #makeStanding: (slot: number, slots: number) => StandingCandleCaptures;
  readonly #mostCandles: number;
  #moon: MoonCaptures | null = null;
  /** Of candles that burn, or have burnt. */
  readonly #standing: StandingCandleCaptures[] = [];

  /** @param known targets that bounces are computed in at once; null for its own */
  constructor(gpu: Gpu, scene: IndirectScene, tier: PhysicalTier, known: IndirectTargets | null) {
    this.#mostCandles = tier.mostCandles;
    // Each light is captured at once, so that one set of targets serves all.
    let shared = known;
    const targets = () => {
      shared ??= indirectTargets(gpu, tier.indirect);
      return shared;
    };
    let standing: Omit<StandingSlot, "slot"> | null = null;
    this.#makeStanding = (slot, slots) => {
      standing ??= {
        shadows: shadowAtlas(gpu, tier.shadow.size, slots),
        supports: supportTarget(gpu, slots),
      };
      return new StandingCandleCaptures(gpu, scene, tier.indirect, targets(), {
        ...standing,
        slot,
      });
    };
    this.#makeMoon = () => new MoonCaptures(gpu, scene, tier, targets());
  }

  /**
   * The lights that shine, in steps where one of them is captured.
   *
   * @param casters of a standing candle's shadows and bounced light
   * @param isGradual whether a new direction of the moon may follow later
   */
  *steps(
    { moon, standing }: World,
    casters: ShadowCasters,
    isGradual = false,
  ): Steps<readonly CachedLight[]> {
    const lights: CachedLight[] = [];
    if (moon) {
      this.#moon ??= this.#makeMoon();
      yield;
      const light = yield* this.#moon.light(moon, isGradual);
      if (light) lights.push(light);
    }
    const slots = Math.min(standing.length, this.#mostCandles);
    const groups = groupedAroundFirst(
      standing.filter(({ flame }) => flame.glow > 0),
      slots,
    );
    const burning = groups.map(([first]) => first);
    for (const [first, ...others] of groups) {
      const light = yield* this.#capturesOf(first, burning, slots).light(first, casters);
      const all = [light.intensity, ...others.map((one) => flameLight(one, TAPER).intensity)];
      const sum = (channel: 0 | 1 | 2) => all.reduce((sum, one) => sum + one[channel], 0);
      lights.push({ ...light, intensity: [sum(0), sum(1), sum(2)] });
    }
    return lights;
  }

  *night(casters: ShadowCasters): Steps {
    if (this.#moon) yield* this.#moon.night(casters);
  }

  /** Its own captures, or new ones, or those of a candle that is out. */
  #capturesOf(
    { name }: StandingCandle,
    burning: readonly StandingCandle[],
    slots: number,
  ): StandingCandleCaptures {
    const known = this.#standing.find((light) => light.name === name);
    if (known) return known;
    const { length } = this.#standing;
    if (length < slots) this.#standing.push(this.#makeStanding(length, slots));
    const isFree = (light: StandingCandleCaptures) =>
      burning.every((candle) => candle.name !== light.name);
    const free = this.#standing.findLast(isFree);
    if (!free) throw new Error("No more candles light the room than there are captures.");
    return free;
  }
}

/** One of the candles that have captures, then those beyond them whose light comes from its place. */
type Group = [first: StandingCandle, ...others: StandingCandle[]];

/** Puts each candle beyond the first `most` to the nearest of these. */
export function groupedAroundFirst(candles: readonly StandingCandle[], most: number): Group[] {
  const groups = candles.slice(0, most).map((candle): Group => [candle]);
  for (const candle of candles.slice(most)) {
    const distanceTo = ([{ root }]: Group) => vec3.distance(root, candle.root);
    const [nearest] = groups.toSorted((one, other) => distanceTo(one) - distanceTo(other));
    nearest?.push(candle);
  }
  return groups;
}
