/** Intent: the visitor's input of one frame, whatever the device. */
export type Intent = Readonly<typeof STILL>;

export const STILL = {
  /** Walking, -1 to 1 along and across the line of sight. */
  forward: 0,
  right: 0,
  runs: false,
  /** Turning by keys or stick, -1 to 1, left positive. */
  turn: 0,
  /** Raising the view by keys or stick, -1 to 1, up positive. */
  tilt: 0,
  /** Turned since the last frame, radians: yaw left positive, pitch up positive. */
  yaw: 0,
  pitch: 0,
  /** The candle is to be put down, or taken up again. */
  placesOrTakes: false,
  /** The flame is to be put out, or lit again. */
  togglesFlame: false,
  blows: false,
};

/** Action that is triggered once, not for as long as something is held. */
export type Action = keyof Pick<Intent, "placesOrTakes" | "togglesFlame" | "blows">;
