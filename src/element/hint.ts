import type { Device } from "../input/first-person-input.js";
import type { Refusal } from "../world/room/placement.js";
import { type CandleChange, changeSentence, outSentence, REFUSALS } from "./messages.js";

/** Controls of each device; keys are in brackets. */
const CONTROLS: Readonly<Record<Device, string>> = {
  mouse:
    "[W][A][S][D] walk, the mouse looks, a click is for the flame, [F] for the candle, [Esc] leaves",
  keyboard:
    "[W][A][S][D] walk, [Q][R] turn, [E] is for the flame, [F] for the candle, [Esc] leaves",
  touch:
    "Walk with the left thumb, look with the right. Tap twice for the flame, hold for the candle",
  gamepad:
    "Left stick walks, right stick looks, [A] is for the flame, [X] for the candle, [B] leaves",
};

/**
 * Line of text over the canvas that is shown for a moment, then fades.
 *
 * Screen readers announce it politely when it changes; to them it stays. The page may have words of its own for the
 * controls, in the slot `hint`.
 */
export class Hint {
  readonly element = document.createElement("div");
  readonly #controls = document.createElement("slot");
  readonly #sentence = document.createElement("p");

  constructor() {
    this.element.part.add("hint");
    this.element.setAttribute("role", "status");
    this.#controls.name = "hint";
    this.#controls.hidden = true;
    this.element.append(this.#controls);
  }

  /** Says that the candle is out, and how to light it; nothing while it burns. */
  tellFlame(isLit: boolean, canLight: boolean): void {
    this.tell(isLit ? null : outSentence(canLight), canLight);
  }

  /** Says that another candle was lit or went out, and that the first is out, if it is. */
  tellOther(change: CandleChange, isLit: boolean, canLight: boolean): void {
    const sentences = [changeSentence(change), isLit ? null : outSentence(canLight)];
    this.tell(sentences.filter(Boolean).join(" "), canLight && !isLit);
  }

  /** Says why the candle could not be put down, and that it is out, if it is. */
  tellRefusal(refusal: Refusal | null, isLit: boolean, canLight: boolean): void {
    const sentences = [refusal && REFUSALS[refusal], isLit ? null : outSentence(canLight)];
    this.tell(sentences.filter(Boolean).join(" ") || null, canLight && !isLit);
  }

  /** Shows a sentence, or none. One that lasts becomes fainter, and stays until the next. */
  tell(sentence: string | null, lasts = false): void {
    this.#clear();
    if (sentence === null) return;
    this.#sentence.textContent = sentence;
    this.#sentence.className = lasts ? "lasting" : "";
    this.element.append(this.#sentence);
  }

  tellControls(device: Device): void {
    this.#clear();
    const line = document.createElement("p");
    line.className = "controls";
    for (const [, key, words] of CONTROLS[device].matchAll(/\[(\w+)\]|([^[]+)/g)) {
      line.append(key === undefined ? ` ${words?.trim()} ` : keyCap(key));
    }
    this.#controls.append(line);
    this.#controls.hidden = false;
  }

  #clear(): void {
    this.#sentence.remove();
    this.#controls.replaceChildren();
    this.#controls.hidden = true;
  }
}

function keyCap(name: string): HTMLElement {
  const cap = document.createElement("kbd");
  cap.textContent = name;
  return cap;
}
