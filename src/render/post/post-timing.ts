import type { GBufferKind } from "../gbuffer/gbuffer.js";
import { SCHEDULE } from "../schedule.js";

/** When a frame updates bloom and exposure: where it may defer that, once in a few frames, see `SCHEDULE`. */
export class PostTiming {
  /** Frames since the last update. */
  #age = 0;
  #images = 0;

  /** @param images how many the opaque stage has begun: the first frame of each is metered */
  of(
    kind: GBufferKind,
    {
      canSkip,
      isShadowNew,
      images = 0,
    }: {
      readonly canSkip: boolean;
      readonly isShadowNew: boolean;
      readonly images: number | undefined;
    },
  ): "before display" | "after display" | "skip" {
    const isOther = images !== this.#images;
    this.#images = images;
    const { frames, restFrames } = SCHEDULE.post;
    const isIdle = kind === "reprojected" && !isShadowNew;
    const isDue = ++this.#age > (kind === "full" ? restFrames : frames) || isIdle;
    if (canSkip && !isOther && !isDue) return "skip";
    this.#age = 0;
    return canSkip && kind === "reprojected" ? "after display" : "before display";
  }
}
