import { mat4 } from "gl-matrix";
import type { Size } from "../frame-input.js";
import { SCHEDULE } from "../schedule.js";
import { type Reprojection, type ReprojectionSource, reprojectionBetween } from "./reprojection.js";

/** Samples of successive frames: at the centers of a texel's four pixels, in texels from its own. */
const OFFSETS = [
  [-0.25, -0.25],
  [0.25, 0.25],
  [0.25, -0.25],
  [-0.25, 0.25],
] as const;

/**
 * Successive reduced G-buffers: each samples the image at other places, so that what several frames accumulate is as fine
 * as the canvas.
 *
 * Source: Yang, Liu and Salvi 2020, "A Survey of Temporal Antialiasing Techniques", 3.1.
 */
export class SampleJitter {
  #turn = 0;
  #last: ReprojectionSource | null = null;
  /** Whether the previous frame was drawn, so that this one may be reprojected from it. */
  #isNew = false;
  /** From texel centers to samples, uv. */
  offset: readonly [number, number] = [0, 0];

  /** The next frame begins anew. */
  reset(): void {
    this.#last = null;
    this.#isNew = false;
  }

  /**
   * From the current frame to the last one that was not reprojected.
   *
   * @param isMoving whether it may be reprojected from that, if it is the previous one
   */
  history(
    current: ReprojectionSource,
    isMoving: boolean,
  ): { readonly history: Reprojection | null; readonly isReprojected: boolean } {
    const history = this.#last && reprojectionBetween(current, this.#last, 0.15);
    const isNear = history !== null && history.motion < SCHEDULE.reprojection.motion;
    const isReprojected = isMoving && this.#isNew && isNear;
    this.#isNew = false;
    if (!isReprojected) this.#last = current;
    return { history, isReprojected };
  }

  /** Camera of a new G-buffer. */
  next(clipFromWorld: mat4, { width, height }: Size): mat4 {
    this.#isNew = true;
    this.#turn = (this.#turn + 1) % OFFSETS.length;
    const [x, y] = OFFSETS[this.#turn]!;
    this.offset = [x / width, y / height];
    const shift = mat4.fromTranslation(mat4.create(), [(-2 * x) / width, (-2 * y) / height, 0]);
    return mat4.multiply(shift, shift, clipFromWorld);
  }
}
