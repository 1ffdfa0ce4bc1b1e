import type { Gpu } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import { type CachedLight, isMoonAlone, moonOf } from "../cached-light.js";
import type { FrameInput } from "../frame-input.js";
import type { GBufferKind } from "../gbuffer/gbuffer.js";
import { fitToRoom } from "../gi/fit-to-room.js";
import type { IndirectScene } from "../gi/indirect-pass.js";
import { type Captures, LightCaptures } from "../gi/light-captures.js";
import type { CaptureLight } from "../light-block.js";
import type { PhysicalTier } from "../quality.js";
import type { ShadowCube } from "../shadow/shadow-pass.js";
import { ResampledIrradiance } from "./resampled-irradiance.js";

/**
 * Captures of the light that an image is refined in; until they are held, those of the renderer that it began with.
 *
 * Beside a flame the moon's are that renderer's for good, its irradiance resampled: its own took three quarters of the time.
 */
export class RefinedCaptures {
  readonly #own: LightCaptures;
  readonly #moonIrradiance: ResampledIrradiance;
  #borrowed: Captures | null = null;
  /** The other renderer's, beside a flame. */
  #moon: CachedLight | null = null;
  /** Of the image. */
  #light: CaptureLight | null = null;

  constructor(gpu: Gpu, room: IndirectScene, tier: PhysicalTier) {
    this.#own = new LightCaptures(gpu, room, tier, false);
    this.#moonIrradiance = new ResampledIrradiance(
      gpu,
      fitToRoom(tier.indirect, room.collision, room.model),
    );
  }

  /** An image begins, with another renderer's captures of its light. */
  begin({ captureLight, world }: FrameInput, captures: Captures): void {
    const { cached } = captures;
    this.#light = captureLight;
    this.#borrowed = captures;
    this.#moon = isMoonAlone(world, cached) ? null : moonOf(cached);
  }

  update(frame: FrameInput, kind: GBufferKind): Captures {
    return this.#borrowed ?? this.#withMoon(this.#own.update(this.#withoutMoon(frame), kind));
  }

  *steps(frame: FrameInput): Steps<Captures> {
    return this.#withMoon(yield* this.#own.steps(this.#withoutMoon(frame)));
  }

  /** Shadow cube of a frame's light, a face in each step: before the other captures, which go on from it. */
  shadow({ captureLight }: FrameInput): Steps<ShadowCube> {
    return this.#own.shadow(captureLight);
  }

  /** Continues captures of the image's light. True once they are held: see `LightCaptures`. */
  hold(frame: FrameInput, steps: number): boolean {
    const captureLight = this.#light ?? frame.captureLight;
    const areHeld = this.#own.hold({ ...this.#withoutMoon(frame), captureLight }, steps);
    if (areHeld) this.#borrowed = null;
    return areHeld;
  }

  #withoutMoon(frame: FrameInput): FrameInput {
    return this.#moon ? { ...frame, world: { ...frame.world, moon: null } } : frame;
  }

  #withMoon(captures: Captures): Captures {
    if (!this.#moon) return captures;
    const { irradiance, cached } = captures;
    const resampled = this.#moonIrradiance.update(this.#moon.irradiance, irradiance);
    return { ...captures, cached: [{ ...this.#moon, irradiance: resampled }, ...cached] };
  }
}
