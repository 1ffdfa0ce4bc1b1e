import type { Gpu, UniformBlock } from "../gl/gpu.js";
import { flameLight, TAPER } from "../light/flame-light.js";
import { flameRadius, heightInTapers, TAPER_WICK } from "../world/flame/burning.js";
import type { Vec3 } from "../world/geometry.js";
import type { StandingCandle } from "../world/standing-candle.js";
import type { Steps } from "../world/steps.js";
import type { CachedLight } from "./cached-light.js";
import { IndirectPass, type IndirectScene } from "./gi/indirect-pass.js";
import type { IndirectTargets } from "./gi/indirect-targets.js";
import type { IndirectDetail } from "./gi/probe-rays.js";
import { type SupportSlot, SurfelPass } from "./gi/surfel-pass.js";
import type { CaptureLight } from "./light-block.js";
import type { ShadowCasters } from "./shadow/shadow-casters.js";
import { type ShadowAtlas, ShadowPass } from "./shadow/shadow-pass.js";

/** A taper's still flame over its root: height of its middle, half its height and its radius as a light, metres. */
const STILL = { middle: 0.02, halfHeight: 0.0095, radius: 0.0035 } as const;
/** Top of the candle: its height above the flame's root, which stands in the pool, and its radius, metres. */
export const RIM = { height: 0.0015, radius: 0.0101 } as const;

export function middleOfStillFlame({ root: [x, y, z], flame }: StandingCandle): Vec3 {
  return [x, y + STILL.middle * heightInTapers(flame.wick), z];
}

/** The flame of a standing candle, still, 1 cd strong: members of the shaders' `Light` block. */
function stillLight(candle: StandingCandle, shadowSlot: number): CaptureLight {
  const { root, flame } = candle;
  const [x, y, z] = root;
  const times = heightInTapers(flame.wick);
  const position = middleOfStillFlame(candle);
  const rim = y + RIM.height;
  return {
    position,
    captureOrigin: position,
    halfHeight: STILL.halfHeight * times,
    intensity: [1, 1, 1],
    radius: (STILL.radius * flameRadius(flame.wick, 1)) / flameRadius(TAPER_WICK, 1),
    along: [0, 1, 0],
    axis: [x, z],
    rim,
    rimRadius: RIM.radius,
    pan: rim,
    panRadius: 0,
    shadowSlot,
  };
}

/** What all standing candles draw to, each in its slot. */
export interface StandingSlot extends SupportSlot {
  readonly shadows: ShadowAtlas;
}

/** Shadow cube and irradiance volume of a standing candle, captured when it first burns. */
export class StandingCandleCaptures {
  readonly #slot: number;
  readonly #shadow: ShadowPass;
  readonly #indirect: IndirectPass;
  readonly #block: UniformBlock;
  /** Of the candle that it is captured for: no other takes the slot meanwhile. */
  name: string | null = null;
  #light: Omit<CachedLight, "intensity"> | null = null;
  /** Of its flame, m. */
  #wick = 0;

  constructor(
    gpu: Gpu,
    scene: IndirectScene,
    indirect: IndirectDetail,
    targets: IndirectTargets,
    { shadows, ...support }: StandingSlot,
  ) {
    this.#slot = support.slot;
    this.#shadow = new ShadowPass(gpu, shadows, support.slot);
    const surfels = new SurfelPass(gpu, indirect, support);
    this.#indirect = new IndirectPass(gpu, scene, indirect, targets, surfels);
    this.#block = surfels.block;
  }

  *light(candle: StandingCandle, casters: ShadowCasters): Steps<CachedLight> {
    const { wick } = candle.flame;
    if (this.name !== candle.name || this.#wick !== wick || !this.#light) {
      this.name = candle.name;
      this.#light = null; // the steps may be abandoned
      this.#wick = wick;
      this.#light = yield* this.#capture(candle, casters);
    }
    return { ...this.#light, intensity: flameLight(candle, TAPER).intensity };
  }

  *#capture(candle: StandingCandle, casters: ShadowCasters): Steps<Omit<CachedLight, "intensity">> {
    const { name, root, flame } = candle;
    const light = stillLight(candle, this.#slot);
    const { position: captureOrigin } = light;
    const shadow = { depth: yield* this.#shadow.steps(casters, captureOrigin), captureOrigin };
    return {
      kind: "candle",
      virtual: null,
      name,
      light,
      block: this.#block,
      shadow: shadow.depth,
      irradiance: yield* this.#indirect.capture(casters, light, shadow),
      background: 0,
      key: JSON.stringify([root, flame.wick]),
    };
  }
}
