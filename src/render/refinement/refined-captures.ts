import type { Gpu } from "../../gl/gpu.js";
import type { Steps } from "../../steps.js";
import { isUnlit } from "../cached-light.js";
import type { FrameInput } from "../frame-input.js";
import type { GBufferKind } from "../gbuffer/gbuffer.js";
import { fitToRoom } from "../gi/fit-to-room.js";
import type { IndirectScene } from "../gi/indirect-pass.js";
import { type Captures, LightCaptures } from "../gi/light-captures.js";
import { probeTraceOf } from "../gi/probe-rays.js";
import { FINE_INDIRECT, type PhysicalTier } from "../quality.js";
import { SCHEDULE } from "../schedule.js";

/**
 * Captures of the light that an image is refined in: first with few probes, which take a second, then with `high`'s.
 *
 * By the moon alone `high`'s are the first: all light there is indirect.
 */
export class RefinedCaptures {
  readonly #makeFine: () => LightCaptures;
  readonly #room: IndirectScene;
  readonly #first: LightCaptures;
  #fine: LightCaptures | null = null;
  #current: LightCaptures;
  /** Another renderer's, as long as none are held. */
  #borrowed: Captures | null = null;

  constructor(gpu: Gpu, room: IndirectScene, tier: PhysicalTier) {
    this.#room = room;
    this.#first = new LightCaptures(gpu, room, tier, false);
    this.#current = this.#first;
    this.#makeFine = () =>
      new LightCaptures(gpu, room, { ...tier, indirect: FINE_INDIRECT }, false);
  }

  /** Takes another renderer's until some are held. */
  borrow(captures: Captures): void {
    this.#borrowed = captures;
  }

  /** Those that are held. */
  update(frame: FrameInput, kind: GBufferKind): Captures {
    return this.#borrowed ?? this.#current.update(frame, kind);
  }

  steps(frame: FrameInput): Steps<Captures> {
    return this.#current.steps(frame);
  }

  /** Whether those that are held have `high`'s probes. */
  get isFine(): boolean {
    return this.#current === this.#fine;
  }

  /** Continues the first captures that are good enough. True once they are held: see `LightCaptures`. */
  hold(frame: FrameInput, steps: number): boolean {
    const { world, captureLight } = frame;
    if (isUnlit(world) || this.#fine?.isHeldFor(captureLight)) return this.#holdFine(frame, steps);
    return this.#first.hold(frame, steps) && this.#use(this.#first);
  }

  #use(captures: LightCaptures): true {
    this.#current = captures;
    this.#borrowed = null;
    return true;
  }

  /** Continues captures with `high`'s probes, of the light that the first ones are of. True once they are held. */
  refine(frame: FrameInput, steps: number): boolean {
    return this.#holdFine(
      { ...frame, captureLight: this.#first.heldLight ?? frame.captureLight },
      steps,
    );
  }

  #holdFine(frame: FrameInput, steps: number): boolean {
    const { collision, model } = this.#room;
    const trace = probeTraceOf(collision, model, fitToRoom(FINE_INDIRECT, collision, model));
    for (let step = 0; step < steps && !this.#fine; step++) {
      if (trace.proceed(SCHEDULE.probesPerFrame)) this.#fine = this.#makeFine();
    }
    return this.#fine?.hold(frame, steps) ? this.#use(this.#fine) : false;
  }
}
