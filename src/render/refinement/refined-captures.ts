import type { Gpu } from "../../gl/gpu.js";
import type { Steps } from "../../world/steps.js";
import type { FrameInput } from "../frame-input.js";
import type { GBufferKind } from "../gbuffer/gbuffer.js";
import type { IndirectScene } from "../gi/indirect-pass.js";
import { type Captures, LightCaptures } from "../gi/light-captures.js";
import type { CaptureLight } from "../light-block.js";
import type { PhysicalTier } from "../quality.js";
import type { ShadowCube } from "../shadow/shadow-pass.js";

/** Captures of the light that an image is refined in; until they are held, those of the renderer that it began with. */
export class RefinedCaptures {
  readonly #own: LightCaptures;
  #borrowed: Captures | null = null;
  /** Of the image. */
  #light: CaptureLight | null = null;

  constructor(gpu: Gpu, room: IndirectScene, tier: PhysicalTier) {
    this.#own = new LightCaptures(gpu, room, tier, false);
  }

  /** An image begins, with another renderer's captures of its light. */
  begin({ captureLight }: FrameInput, captures: Captures): void {
    this.#light = captureLight;
    this.#borrowed = captures;
  }

  update(frame: FrameInput, kind: GBufferKind): Captures {
    return this.#borrowed ?? this.#own.update(frame, kind);
  }

  steps(frame: FrameInput): Steps<Captures> {
    return this.#own.steps(frame);
  }

  /** Shadow cube of a frame's light, a face in each step: before the other captures, which go on from it. */
  shadow({ captureLight }: FrameInput): Steps<ShadowCube> {
    return this.#own.shadow(captureLight);
  }

  /** Continues captures of the image's light. True once they are held: see `LightCaptures`. */
  hold(frame: FrameInput, steps: number): boolean {
    const captureLight = this.#light ?? frame.captureLight;
    const areHeld = this.#own.hold({ ...frame, captureLight }, steps);
    if (areHeld) this.#borrowed = null;
    return areHeld;
  }
}
