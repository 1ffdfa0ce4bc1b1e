import { mat4 } from "gl-matrix";
import type { Size } from "../frame-input.js";
import { SCHEDULE } from "../schedule.js";
import { type Reprojection, type ReprojectionSource, reprojectionBetween } from "./reprojection.js";

/** Samples of successive frames, one for each pixel that a texel covers: from the texel's center, in texels. */
const OFFSETS = [
  [-0.25, -0.25],
  [0.25, 0.25],
  [0.25, -0.25],
  [-0.25, 0.25],
] as const;

/** Largest motion between two G-buffers, as a share of the image's size: of two frames, and some more. */
const MOST_MOTION = 2.5 * SCHEDULE.reprojection.motion;

/**
 * Successive reduced G-buffers: each samples the image at other places, so that what several frames accumulate is as fine
 * as the canvas.
 *
 * Source: Yang, Liu and Salvi 2020, "A Survey of Temporal Antialiasing Techniques", 3.1.
 */
export class SampleJitter {
  #turn = 0;
  #offset: readonly [number, number] = [0, 0];
  #last: ReprojectionSource | null = null;
  /** Whether the frame before has drawn the last G-buffer. */
  #isNew = false;

  /** From the centers of texels to the samples of the last G-buffer, uv. */
  get offset(): readonly [number, number] {
    return this.#offset;
  }

  /** Without a history, as after frames at rest. */
  reset(): void {
    this.#last = null;
    this.#isNew = false;
  }

  /** From a frame to the one that the last G-buffer was drawn for; null if that has too little in common with it. */
  historyOf(current: ReprojectionSource): Reprojection | null {
    return this.#last && reprojectionBetween(current, this.#last, MOST_MOTION);
  }

  /** Whether a frame in motion with this history may have the last G-buffer, of the frame before, in place of a new one. */
  mayReproject(history: Reprojection | null): boolean {
    const isNew = this.#isNew;
    this.#isNew = false;
    return isNew && history !== null && history.motion < SCHEDULE.reprojection.motion;
  }

  /** The camera of the next G-buffer. */
  next(clipFromWorld: mat4, { width, height }: Size): mat4 {
    this.#last = null; // there is none while it is drawn
    this.#turn = (this.#turn + 1) % OFFSETS.length;
    const [x, y] = OFFSETS[this.#turn]!;
    this.#offset = [x / width, y / height];
    const shift = mat4.fromTranslation(mat4.create(), [(-2 * x) / width, (-2 * y) / height, 0]);
    return mat4.multiply(shift, shift, clipFromWorld);
  }

  /** A G-buffer was drawn, for a frame. */
  drawn(source: ReprojectionSource): void {
    this.#last = source;
    this.#isNew = true;
  }
}
