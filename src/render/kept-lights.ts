import type { Gpu } from "../gl/gpu.js";
import type { VertexArray } from "../gl/vertex-array.js";
import type { World } from "../world/world.js";
import type { IndirectScene } from "./gi/indirect-pass.js";
import type { KeptLight } from "./kept-light.js";
import { MoonCaptures } from "./moon/moon-captures.js";
import type { PhysicalTier } from "./quality.js";

/** The lights beside the carried flame, each captured when it first shines. */
export class KeptLights {
  readonly #makeMoon: () => MoonCaptures;
  #moon: MoonCaptures | null = null;

  constructor(gpu: Gpu, screen: VertexArray, scene: IndirectScene, tier: PhysicalTier) {
    this.#makeMoon = () => new MoonCaptures(gpu, screen, scene, tier);
  }

  update({ moon }: World): readonly KeptLight[] {
    if (!moon) return [];
    this.#moon ??= this.#makeMoon();
    const light = this.#moon.light(moon);
    return light ? [light] : [];
  }
}
