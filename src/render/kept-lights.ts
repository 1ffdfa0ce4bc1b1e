import type { Gpu } from "../gl/gpu.js";
import type { VertexArray } from "../gl/vertex-array.js";
import type { StandingCandle } from "../world/standing-candle.js";
import type { World } from "../world/world.js";
import type { IndirectScene } from "./gi/indirect-pass.js";
import { type IndirectTargets, indirectTargets } from "./gi/indirect-targets.js";
import type { KeptLight } from "./kept-light.js";
import { MoonCaptures } from "./moon/moon-captures.js";
import type { PhysicalTier } from "./quality.js";
import type { ShadowCasters } from "./shadow/shadow-casters.js";
import { type ShadowAtlas, shadowAtlas } from "./shadow/shadow-pass.js";
import { StandingLight } from "./standing-light.js";

/** The lights beside the carried flame, each captured when it first shines. */
export class KeptLights {
  readonly #makeMoon: () => MoonCaptures;
  readonly #makeStanding: (slot: number, slots: number) => StandingLight;
  readonly #mostCandles: number;
  #moon: MoonCaptures | null = null;
  /** Of candles that burn, or have burnt. */
  readonly #standing: StandingLight[] = [];

  /** @param known targets that bounces are computed in at once; null for its own */
  constructor(
    gpu: Gpu,
    screen: VertexArray,
    scene: IndirectScene,
    tier: PhysicalTier,
    known: IndirectTargets | null,
  ) {
    this.#mostCandles = tier.mostCandles;
    // Each light is captured at once, so that one set of targets serves all.
    let shared = known;
    const targets = () => {
      shared ??= indirectTargets(gpu, tier.indirect);
      return shared;
    };
    let shadows: ShadowAtlas | null = null;
    this.#makeStanding = (slot, slots) => {
      shadows ??= shadowAtlas(gpu, tier.shadow.size, slots);
      return new StandingLight(gpu, screen, scene, tier.indirect, targets(), { shadows, slot });
    };
    this.#makeMoon = () => new MoonCaptures(gpu, screen, scene, tier, targets());
  }

  /** @param casters of a standing candle's shadows and bounced light */
  update({ moon, standing }: World, casters: ShadowCasters): readonly KeptLight[] {
    const lights: KeptLight[] = [];
    if (moon) {
      this.#moon ??= this.#makeMoon();
      const light = this.#moon.light(moon);
      if (light) lights.push(light);
    }
    const slots = Math.min(standing.length, this.#mostCandles);
    const burning = standing.filter(({ flame }) => flame.glow > 0).slice(0, slots);
    for (const candle of burning) {
      lights.push(this.#capturesOf(candle, burning, slots).light(candle, casters));
    }
    return lights;
  }

  /** Its own captures, or new ones, or those of a candle that is out. */
  #capturesOf(
    { name }: StandingCandle,
    burning: readonly StandingCandle[],
    slots: number,
  ): StandingLight {
    const known = this.#standing.find((light) => light.name === name);
    if (known) return known;
    const { length } = this.#standing;
    if (length < slots) this.#standing.push(this.#makeStanding(length, slots));
    const isFree = (light: StandingLight) => burning.every((candle) => candle.name !== light.name);
    const free = this.#standing.findLast(isFree);
    if (!free) throw new Error("No more candles light the room than there are captures.");
    return free;
  }
}
