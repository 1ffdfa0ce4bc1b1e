import { type Intent, STILL } from "../world/player/intent.js";

/** Dead zone, as a share of a stick's range. */
const DEAD_ZONE = 0.15;
/** Exponent of the looking stick: fine near the middle, fast at the rim. */
const LOOK_CURVE = 1.6;

/** Indices of the W3C's standard gamepad. Other layouts are not supported. */
const AXES = { right: 0, back: 1, turnRight: 2, down: 3 } as const;
const BUTTONS = { a: 0, b: 1, x: 2, y: 3, rightTrigger: 7, leftStick: 10 } as const;

/** The part of a `Gamepad` that is read. */
export interface Pad {
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Applies a radial dead zone: the rim stays at length 1 in every direction. */
export function beyondDeadZone(x: number, y: number, exponent = 1): [x: number, y: number] {
  const length = Math.hypot(x, y);
  if (!(length > DEAD_ZONE)) return [0, 0];
  const deflection = Math.min(1, (length - DEAD_ZONE) / (1 - DEAD_ZONE)) ** exponent;
  return [(x / length) * deflection, (y / length) * deflection];
}

/** The first standard gamepad, as an intent: left stick walks, right stick looks, buttons act once. */
export class Gamepads {
  #pressed: readonly boolean[] = [];
  /** Whether the button to go in, or to leave, went down since the last reading. */
  enters = false;
  leaves = false;

  /** Ignores buttons that are down until they are released. */
  release(): void {
    this.#pressed = Array<boolean>(BUTTONS.leftStick + 1).fill(true);
  }

  read(pads: readonly (Pad | null)[]): Intent {
    const pad = pads.find((pad) => pad?.mapping === "standard");
    this.enters = false;
    this.leaves = false;
    if (!pad) return STILL;
    const previous = this.#pressed;
    this.#pressed = pad.buttons.map(({ pressed }) => pressed);
    const goesDown = (button: number) => this.#pressed[button] === true && !previous[button];
    this.enters = goesDown(BUTTONS.a);
    this.leaves = goesDown(BUTTONS.b);
    const axis = (index: number) => pad.axes[index] ?? 0;
    const [right, back] = beyondDeadZone(axis(AXES.right), axis(AXES.back));
    const [turn, down] = beyondDeadZone(axis(AXES.turnRight), axis(AXES.down), LOOK_CURVE);
    return {
      ...STILL,
      forward: -back,
      right,
      turn: -turn,
      tilt: -down,
      runs: [BUTTONS.leftStick, BUTTONS.rightTrigger].some((button) => this.#pressed[button]),
      togglesFlame: goesDown(BUTTONS.a),
      placesOrTakes: goesDown(BUTTONS.x),
      blows: goesDown(BUTTONS.y),
    };
  }
}
