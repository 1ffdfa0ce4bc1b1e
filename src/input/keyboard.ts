import { type Action, type Intent, STILL } from "../world/player/intent.js";

/** What keys do while they are held, by their place on the keyboard, whatever the layout. */
const EFFECTS: Readonly<Record<string, Partial<Intent>>> = {
  KeyW: { forward: 1 },
  ArrowUp: { forward: 1 },
  KeyS: { forward: -1 },
  ArrowDown: { forward: -1 },
  KeyD: { right: 1 },
  ArrowRight: { right: 1 },
  KeyA: { right: -1 },
  ArrowLeft: { right: -1 },
  KeyQ: { turn: 1 },
  Home: { turn: 1 },
  KeyR: { turn: -1 },
  End: { turn: -1 },
  PageUp: { tilt: 1 },
  PageDown: { tilt: -1 },
  ShiftLeft: { runs: true },
  ShiftRight: { runs: true },
};

/** Actions, triggered when the key goes down. */
const ACTIONS: Readonly<Record<string, Action>> = {
  KeyE: "togglesFlame",
  KeyB: "blows",
  KeyF: "placesOrTakes",
};

/** The keys that are down, or were since the last reading, as an intent. Keyboard alone reaches everything. */
export class Keyboard {
  readonly #down = new Set<string>();
  /** Pressed since the last reading: between two slow frames a key may go down and up. */
  readonly #tapped = new Set<string>();
  #actions: Partial<Record<Action, true>> = {};

  /** Whether the key is one of ours. */
  press({ code, repeat }: KeyboardEvent): boolean {
    const action = ACTIONS[code];
    if (action && !repeat) this.#actions[action] = true;
    if (EFFECTS[code]) {
      this.#down.add(code);
      if (!repeat) this.#tapped.add(code);
    }
    return action !== undefined || EFFECTS[code] !== undefined;
  }

  lift({ code, key }: KeyboardEvent): void {
    // macOS reports no key that is released while Command is down.
    if (key === "Meta") this.#releaseKeys();
    this.#down.delete(code);
  }

  /** Forgets keys that are down, and actions that no frame has read. */
  release(): void {
    this.#releaseKeys();
    this.#actions = {};
  }

  #releaseKeys(): void {
    this.#down.clear();
    this.#tapped.clear();
  }

  read(): Intent {
    const codes = new Set([...this.#down, ...this.#tapped]);
    this.#tapped.clear();
    const effects = [...codes].map((code) => EFFECTS[code] ?? STILL);
    // Two keys for the same way are no faster than one.
    const way = (axis: "forward" | "right" | "turn" | "tilt") =>
      Math.sign(effects.reduce((sum, effect) => sum + (effect[axis] ?? 0), 0));
    const intent: Intent = {
      ...STILL,
      forward: way("forward"),
      right: way("right"),
      turn: way("turn"),
      tilt: way("tilt"),
      runs: effects.some(({ runs }) => runs),
      ...this.#actions,
    };
    this.#actions = {};
    return intent;
  }
}
