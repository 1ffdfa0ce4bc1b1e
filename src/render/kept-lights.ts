import type { Gpu } from "../gl/gpu.js";
import type { VertexArray } from "../gl/vertex-array.js";
import type { World } from "../world/world.js";
import type { IndirectScene } from "./gi/indirect-pass.js";
import { type IndirectTargets, indirectTargets } from "./gi/indirect-targets.js";
import type { KeptLight } from "./kept-light.js";
import { MoonCaptures } from "./moon/moon-captures.js";
import type { PhysicalTier } from "./quality.js";
import type { ShadowCasters } from "./shadow/shadow-casters.js";
import { StandingLight } from "./standing-light.js";

/** The lights beside the carried flame, each captured when it first shines. */
export class KeptLights {
  readonly #makeMoon: () => MoonCaptures;
  readonly #makeStanding: () => StandingLight;
  readonly #mostCandles: number;
  #moon: MoonCaptures | null = null;
  /** By the candle's name. */
  readonly #standing = new Map<string, StandingLight>();

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
    this.#makeStanding = () => new StandingLight(gpu, screen, scene, tier, targets());
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
    const burning = standing.filter(({ flame }) => flame.glow > 0);
    for (const candle of burning.slice(0, this.#mostCandles)) {
      const known = this.#standing.get(candle.name) ?? this.#makeStanding();
      this.#standing.set(candle.name, known);
      lights.push(known.light(candle, casters));
    }
    return lights;
  }
}
