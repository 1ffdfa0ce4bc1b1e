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

/** Whether the button to go in is down. */
export function hasEntering(pads: readonly (Pad | null)[]): boolean {
  return pads.some((pad) => pad?.mapping === "standard" && pad.buttons[BUTTONS.a]?.pressed);
}

/** Applies a radial dead zone: the rim stays at length 1 in every direction. */
export function beyondDeadZone(x: number, y: number, exponent = 1): [x: number, y: number] {
  const length = Math.hypot(x, y);
  if (!(length > DEAD_ZONE)) return [0, 0];
  const deflection = Math.min(1, (length - DEAD_ZONE) / (1 - DEAD_ZONE)) ** exponent;
  return [(x / length) * deflection, (y / length) * deflection];
}

/** @param before the buttons that were down; where nothing is known, all were */
function readPad({ axes, buttons }: Pad, before: readonly boolean[] = []) {
  const axis = (index: number) => axes[index] ?? 0;
  const walk = beyondDeadZone(axis(AXES.right), axis(AXES.back));
  const look = beyondDeadZone(axis(AXES.turnRight), axis(AXES.down), LOOK_CURVE);
  const pressed = buttons.map(({ pressed }) => pressed);
  const goesDown = pressed.map((isDown, button) => isDown && before[button] === false);
  const isUsed = [...pressed, ...walk, ...look].some(Boolean);
  return { walk, look, pressed, goesDown, isUsed };
}

/** The standard gamepad in the hand, as an intent: left stick walks, right stick looks, buttons act once. */
export class Gamepads {
  /** Buttons that were down, of each pad by its place. */
  #pressed: readonly (readonly boolean[] | undefined)[] = [];
  /** Place of the pad that was used last. */
  #place = 0;
  /** Whether the button to go in, or to leave, went down since the last reading. */
  enters = false;
  leaves = false;

  /** Ignores buttons that are down until they are released. */
  release(): void {
    this.#pressed = [];
  }

  read(pads: readonly (Pad | null)[]): Intent {
    const readings = pads.map((pad, place) =>
      pad?.mapping === "standard" ? readPad(pad, this.#pressed[place]) : undefined,
    );
    this.#pressed = readings.map((reading) => reading?.pressed);
    // Others may be idle, drift, or be made by a program.
    const places = [this.#place, ...readings.keys()].filter((place) => readings[place]);
    this.#place =
      places.find((place) => readings[place]?.goesDown.some(Boolean)) ??
      places.find((place) => readings[place]?.isUsed) ??
      places[0] ??
      this.#place;
    const reading = readings[this.#place];
    const goesDown = (button: number) => reading?.goesDown[button] === true;
    this.enters = goesDown(BUTTONS.a);
    this.leaves = goesDown(BUTTONS.b);
    if (!reading) return STILL;
    const { walk, look, pressed } = reading;
    return {
      ...STILL,
      forward: -walk[1],
      right: walk[0],
      turn: -look[0],
      tilt: -look[1],
      runs: [BUTTONS.leftStick, BUTTONS.rightTrigger].some((button) => pressed[button]),
      togglesFlame: goesDown(BUTTONS.a),
      placesOrTakes: goesDown(BUTTONS.x),
      blows: goesDown(BUTTONS.y),
    };
  }
}
