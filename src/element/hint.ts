import type { Device } from "../input/first-person-input.js";
import { type KeyName, nameKeys } from "../key-names.js";
import { outSentence } from "./messages.js";

/**
 * Line of text over the canvas that is shown for a moment, then fades; without `controls` only what lasts is, and the rest for
 * screen readers alone.
 *
 * Screen readers announce it politely when it changes; to them it stays. The page may have words of its own for the
 * controls, in the slot `hint`.
 */
export class Hint {
  readonly element = document.createElement("div");
  readonly #controls = document.createElement("slot");
  readonly #sentence = createEnglish("p");
  #device: Device = "keyboard";
  #nameOf: KeyName = (key) => key;

  constructor() {
    this.element.part.add("hint");
    this.element.setAttribute("role", "status");
    this.#controls.name = "hint";
    this.#controls.hidden = true;
    this.element.append(this.#controls);
  }

  /** What the visitor does to light a candle, by the device in hand. */
  get lighting(): string {
    if (this.#device === "touch") return "Tap twice";
    return `Press ${this.#device === "gamepad" ? "A" : this.#nameOf("E")}`;
  }

  /** Tells news, if there are any, and that the carried candle is out, if it is, and how to light it. */
  tellFlame(isLit: boolean, canLight: boolean, news: string | null = null): void {
    const out = outSentence(canLight ? this.lighting : null);
    const sentences = [news, !isLit && out].filter(Boolean);
    this.tell(sentences.join(" "), canLight && !isLit);
  }

  /** Shows a sentence, or with an empty one none. One that lasts goes later. */
  tell(sentence: string, lasts = false): void {
    this.#clear();
    if (!sentence) return;
    this.#sentence.textContent = sentence;
    this.#sentence.className = lasts ? "lasting" : "";
    this.element.append(this.#sentence);
  }

  /** @param controls what the device does; keys are in brackets */
  tellControls(device: Device, controls: string): void {
    this.#clear();
    this.#device = device;
    const line = createEnglish("p");
    line.className = "controls";
    for (const [, key, words] of controls.matchAll(/\[(\w+)\]|([^[]+)/g)) {
      line.append(key === undefined ? ` ${words?.trim()} ` : keyCap(key));
    }
    this.#controls.append(line);
    this.#controls.hidden = false;
    if (device !== "gamepad") void this.#nameKeys(line);
  }

  async #nameKeys(line: HTMLElement): Promise<void> {
    this.#nameOf = await nameKeys(line.querySelectorAll("kbd"));
  }

  #clear(): void {
    this.#sentence.remove();
    this.#controls.replaceChildren();
    this.#controls.hidden = true;
  }
}

/** An element for words of our own, on pages of any language and direction. */
export function createEnglish<Tag extends "p" | "button">(tag: Tag): HTMLElementTagNameMap[Tag] {
  return Object.assign(document.createElement(tag), { lang: "en", dir: "ltr" });
}

function keyCap(name: string): HTMLElement {
  const cap = document.createElement("kbd");
  cap.textContent = name;
  return cap;
}
