import type { Device } from "./input/first-person-input.js";

type Words = readonly (string | readonly string[])[];

/** What each device does, keys in lists of their own. */
const CONTROLS: Readonly<Record<Device, Words>> = {
  mouse: [
    ["W", "A", "S", "D"],
    "walk, the mouse looks, a click is for the flame,",
    ["F"],
    "for the candle,",
    ["Esc"],
    "leaves",
  ],
  keyboard: [
    ["W", "A", "S", "D"],
    "walk,",
    ["Q", "R"],
    "turn,",
    ["E"],
    "is for the flame,",
    ["F"],
    "for the candle,",
    ["Esc"],
    "leaves",
  ],
  touch: [
    "Walk with the left thumb, look with the right. Tap twice for the flame, hold for the candle",
  ],
  gamepad: [
    "Left stick walks, right stick looks,",
    ["A"],
    "is for the flame,",
    ["X"],
    "for the candle,",
    ["B"],
    "leaves",
  ],
};

/**
 * What the visitor should know for a moment: a line over the picture that fades by itself.
 *
 * It is read aloud when it changes, politely; what has faded stays for whoever reads with the ears.
 */
export class Hint {
  readonly element = document.createElement("div");

  constructor() {
    this.element.part.add("hint");
    this.element.role = "status";
  }

  /** One sentence, or nothing. */
  tell(sentence: string | null): void {
    this.#show(sentence === null ? [] : [sentence]);
  }

  /** How to get about with what the visitor has in hand. */
  tellControls(device: Device): void {
    this.#show(CONTROLS[device], "controls");
  }

  #show(words: Words, className = ""): void {
    this.element.replaceChildren();
    if (words.length === 0) return;
    const line = document.createElement("p");
    line.className = className;
    for (const word of words) {
      if (typeof word === "string") line.append(` ${word} `);
      else line.append(...word.map(keyCap));
    }
    this.element.append(line);
  }
}

function keyCap(name: string): HTMLElement {
  const cap = document.createElement("kbd");
  cap.textContent = name;
  return cap;
}
