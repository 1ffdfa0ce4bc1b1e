/** Intent: the visitor's input of one frame, whatever the device. */
export interface Intent {
  /** Walking, -1 to 1 along and across the line of sight. */
  readonly forward: number;
  readonly right: number;
  readonly runs: boolean;
  /** Turning by keys or stick, -1 to 1, left positive. */
  readonly turn: number;
  /** Raising the view by keys or stick, -1 to 1, up positive. */
  readonly tilt: number;
  /** Turned since the last frame, radians: yaw left positive, pitch up positive. */
  readonly yaw: number;
  readonly pitch: number;
  /** The candle is to be put down, or taken up again. */
  readonly placesOrTakes: boolean;
  /** The flame is to be put out, or lit again. */
  readonly togglesFlame: boolean;
  readonly blows: boolean;
}

export const STILL: Intent = {
  forward: 0,
  right: 0,
  runs: false,
  turn: 0,
  tilt: 0,
  yaw: 0,
  pitch: 0,
  placesOrTakes: false,
  togglesFlame: false,
  blows: false,
};

/** Action that is triggered once, not for as long as something is held. */
export type Action = keyof Pick<Intent, "placesOrTakes" | "togglesFlame" | "blows">;
