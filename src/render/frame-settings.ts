import type { Features, Inspection } from "../settings.js";

export interface FrameSettings {
  readonly features: Features;
  /** Of the screen. */
  readonly gamut: PredefinedColorSpace;
  /** Compensation, EV. */
  readonly exposure: number;
  /** Whether the camera or the candle has moved since the last frame, and continues to. */
  readonly isMoving: boolean;
  /** Whether another frame follows soon, to which long work may be deferred. */
  readonly canDefer: boolean;
  /** No flicker and no sway: `prefers-reduced-motion`. */
  readonly isStill: boolean;
  /** Steps of a refinement that this frame may do; only for renderers that refine. */
  readonly steps?: number;
  /** Pass to inspect; looks without passes show the frame. */
  readonly inspect: Inspection;
}

/** A frame of the same settings at rest, in a running animation. */
export function atRest<T extends Pick<FrameSettings, "isMoving" | "canDefer">>(frame: T): T {
  return { ...frame, isMoving: false, canDefer: true };
}
