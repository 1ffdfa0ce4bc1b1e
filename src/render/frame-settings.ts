import type { Features, Inspection } from "../settings.js";

/** What a picture depends on beside the world. */
export interface FrameSettings {
  readonly features: Features;
  /** What the screen can show. */
  readonly gamut: PredefinedColorSpace;
  /** Compensation, EV. */
  readonly exposure: number;
  /** Whether the eye or the candle has moved since the picture before, in a row that goes on. */
  readonly isMoving: boolean;
  /** Whether another picture follows soon, so that one may leave to the next what takes long. */
  readonly isPatient: boolean;
  /** No flicker and no sway: `prefers-reduced-motion`. */
  readonly isStill: boolean;
  /** What is shown of the frame; looks without passes show the picture. */
  readonly inspect: Inspection;
}
