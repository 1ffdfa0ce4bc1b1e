import { vec3 } from "gl-matrix";
import { finish, type Steps } from "../../world/steps.js";
import type { CaptureLight } from "../light-block.js";
import { SCHEDULE } from "../schedule.js";
import type { ShadowCasters } from "../shadow/shadow-casters.js";
import type { IndirectPass, ShadowMap } from "./indirect-pass.js";
import type { IrradianceVolume } from "./irradiance-volume.js";

interface Update {
  readonly light: CaptureLight;
  readonly isExact: boolean;
  readonly capture: Steps;
  /** Null until the surfels are captured. */
  bounces: Steps | null;
  hasWaited: boolean;
}

/** Amortised updates of indirect light for a moving flame: a few steps in each frame, see `SCHEDULE.indirect`. */
export class IndirectUpdates {
  readonly #indirect: IndirectPass;
  #update: Update | null = null;
  /** Frames until the next update may begin. */
  #pause = 0;

  constructor(indirect: IndirectPass) {
    this.#indirect = indirect;
  }

  /**
   * @param isExact whether the camera rests: all bounces are computed, at once where the light has moved far. In motion
   * one bounce of the previous irradiance approximates all further bounces
   * @param isBusy whether this frame takes long anyway: a bounce waits for the next one
   */
  update(
    casters: ShadowCasters,
    light: CaptureLight,
    shadow: ShadowMap,
    { isExact = false, isBusy = false },
  ): IrradianceVolume {
    const indirect = this.#indirect;
    const { lastLight } = indirect;
    indirect.shadow = shadow;
    // A stepped frame, or a prepared one, may have captured surfels of its own since.
    const goesOn = this.#update?.isExact === isExact && this.#update.light === indirect.capturedFor;
    if (!goesOn) this.#update = null;
    const isFar =
      lastLight && vec3.distance(light.position, lastLight.position) > SCHEDULE.shadow.distance;
    if (!lastLight || (isExact && isFar)) {
      return finish(indirect.capture(casters, light, shadow));
    }
    if (!this.#update) {
      if (this.#pause-- > 0 || indirect.isKnown(light, isExact)) return indirect.volume;
      const capture = indirect.captureSurfels(casters, light);
      this.#update = { light, isExact, capture, bounces: null, hasWaited: false };
    }
    const update = this.#update;
    update.hasWaited = isBusy && !update.hasWaited && update.bounces !== null;
    for (let step = 0; step < SCHEDULE.indirect.steps && !update.hasWaited; step++) {
      if (!this.#hasFinished(update)) continue;
      this.#update = null;
      this.#pause = SCHEDULE.indirect.restFrames;
      break;
    }
    return indirect.volume;
  }

  /** Does the next step. */
  #hasFinished(update: Update): boolean {
    if (!update.capture.next().done) return false;
    const { light, isExact } = update;
    // Another light's bounces may have come in between.
    if (!update.bounces || !this.#indirect.hasBegun(light)) {
      update.bounces = isExact
        ? this.#indirect.allBounces(light)
        : this.#indirect.twoBounces(light);
    }
    return update.bounces.next().done === true;
  }
}
