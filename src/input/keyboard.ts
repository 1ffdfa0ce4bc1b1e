import type { Action } from "../world/player/intent.js";
import { type Intent, STILL } from "../world/player/intent.js";

/** Effect of a key while it is held: a share of one axis of the intent, or running. */
type KeyEffect =
  | { readonly axis: "forward" | "right" | "turn" | "tilt"; readonly way: 1 | -1 }
  | { readonly axis: "runs" };

/** By the key's place on the keyboard, whatever the layout. */
const EFFECTS: Readonly<Record<string, KeyEffect>> = {
  KeyW: { axis: "forward", way: 1 },
  ArrowUp: { axis: "forward", way: 1 },
  KeyS: { axis: "forward", way: -1 },
  ArrowDown: { axis: "forward", way: -1 },
  KeyD: { axis: "right", way: 1 },
  ArrowRight: { axis: "right", way: 1 },
  KeyA: { axis: "right", way: -1 },
  ArrowLeft: { axis: "right", way: -1 },
  KeyQ: { axis: "turn", way: 1 },
  Home: { axis: "turn", way: 1 },
  KeyR: { axis: "turn", way: -1 },
  End: { axis: "turn", way: -1 },
  PageUp: { axis: "tilt", way: 1 },
  PageDown: { axis: "tilt", way: -1 },
  ShiftLeft: { axis: "runs" },
  ShiftRight: { axis: "runs" },
};

/** Actions, triggered when the key goes down. */
const ACTIONS: Readonly<Record<string, Action>> = {
  KeyE: "togglesFlame",
  KeyB: "blows",
  KeyF: "placesOrTakes",
};

/** The keys that are down, as an intent. Keyboard alone reaches everything. */
export class Keyboard {
  readonly #down = new Set<string>();
  #actions: Partial<Record<Action, true>> = {};

  /** Whether the key is one of ours. */
  press({ code, repeat }: KeyboardEvent): boolean {
    const action = ACTIONS[code];
    if (action && !repeat) this.#actions[action] = true;
    if (EFFECTS[code]) this.#down.add(code);
    return action !== undefined || EFFECTS[code] !== undefined;
  }

  lift({ code }: KeyboardEvent): void {
    this.#down.delete(code);
  }

  release(): void {
    this.#down.clear();
  }

  read(): Intent {
    const sums = { forward: 0, right: 0, turn: 0, tilt: 0 };
    let runs = false;
    for (const code of this.#down) {
      const effect = EFFECTS[code];
      if (effect?.axis === "runs") runs = true;
      else if (effect) sums[effect.axis] += effect.way;
    }
    // Two keys for the same way are no faster than one.
    const intent: Intent = {
      ...STILL,
      forward: Math.sign(sums.forward),
      right: Math.sign(sums.right),
      turn: Math.sign(sums.turn),
      tilt: Math.sign(sums.tilt),
      runs,
      ...this.#actions,
    };
    this.#actions = {};
    return intent;
  }
}
